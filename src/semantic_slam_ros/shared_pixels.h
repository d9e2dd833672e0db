#pragma once

#include <cstddef>
#include <cstdint>

#include <boost/shared_ptr.hpp>

#include <opencv2/core.hpp>

namespace semantic_slam_ros {

// A rows x cols image of `cv_type` whose pixels are memory of a message, without a copy: the last
// cv::Mat that looks at them lets go of `owner`. Rows are `step` bytes apart. The caller has
// checked that the memory is large enough, and nobody writes: the message belongs to others too.
cv::Mat SharePixels(boost::shared_ptr<const void> owner, const std::uint8_t* pixels, int rows,
                    int cols, int cv_type, std::size_t step);

}  // namespace semantic_slam_ros
