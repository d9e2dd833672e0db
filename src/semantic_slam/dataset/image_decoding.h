#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// Decodes a JPEG or PNG file's bytes, as it is stored: no rotation by EXIF. `imread_flags` are
// cv::IMREAD_COLOR and the like. Empty if the bytes are no image, or not all of one: libjpeg fills
// what is missing with grey, which would pass for a wall.
cv::Mat DecodeImage(const std::uint8_t* data, std::size_t size, int imread_flags);

// The bytes of a file. Throws InputError naming it if it is missing or cannot be read.
std::vector<std::uint8_t> ReadFileBytes(const std::string& path);

}  // namespace semantic_slam
