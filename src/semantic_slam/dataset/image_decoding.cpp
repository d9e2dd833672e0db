#include "semantic_slam/dataset/image_decoding.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr std::uint8_t kStartOfImage[] = {0xFF, 0xD8};
constexpr std::uint8_t kEndOfImage[] = {0xFF, 0xD9};
constexpr std::size_t kMaxTrailer = 1024;  // bytes that some cameras append to the image

bool IsTruncatedJpeg(const std::uint8_t* data, std::size_t size) {
  if (size < 4 || !std::equal(std::begin(kStartOfImage), std::end(kStartOfImage), data)) {
    return false;
  }
  const std::uint8_t* end = data + size;
  const std::uint8_t* tail = end - std::min(size, kMaxTrailer);
  return std::search(tail, end, std::begin(kEndOfImage), std::end(kEndOfImage)) == end;
}

}  // namespace

cv::Mat DecodeImage(const std::uint8_t* data, std::size_t size, int imread_flags) {
  if (size == 0 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return {};
  if (IsTruncatedJpeg(data, size)) return {};
  // cv::imdecode only reads, but takes no pointer to const.
  const cv::Mat bytes(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(data));
  // IMREAD_UNCHANGED is all bits set, and means the same with one more.
  const int flags = imread_flags == cv::IMREAD_UNCHANGED
                        ? imread_flags
                        : imread_flags | cv::IMREAD_IGNORE_ORIENTATION;
  try {
    return cv::imdecode(bytes, flags);
  } catch (const cv::Exception&) {
    return {};  // its header asks for more pixels than OpenCV allows
  }
}

std::vector<std::uint8_t> ReadFileBytes(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) throw InputError("no such file: " + path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot open " + path);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  return bytes;
}

}  // namespace semantic_slam
