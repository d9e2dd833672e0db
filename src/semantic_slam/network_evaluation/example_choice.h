#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace semantic_slam {

// An image that stands for a set, and why.
struct Example {
  std::string name;  // "best", "median" or "worst"
  std::size_t index = 0;
  double score = 0.0;
};

// The images of the highest, the middle and the lowest of `scores`, of equal ones the earliest;
// none twice. Those without a score, NaN, are passed over.
std::vector<Example> ChooseExamples(const std::vector<double>& scores);

}  // namespace semantic_slam
