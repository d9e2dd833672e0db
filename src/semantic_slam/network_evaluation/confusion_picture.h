#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/network_evaluation/confusion_matrix.h"

namespace semantic_slam {

// Draws the matrix, BGR: a row per true class, in whose cells stands how many percent of it were
// predicted as the class of each column; at its end how many there are in all. Classes that are
// neither true nor predicted anywhere are left out, and so are row and column of none(), called
// `none_name`, where they are empty.
cv::Mat DrawConfusion(const ConfusionMatrix& matrix, const std::vector<std::string>& names,
                      const std::string& none_name, const std::string& title);

}  // namespace semantic_slam
