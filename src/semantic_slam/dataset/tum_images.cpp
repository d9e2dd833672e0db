#include "semantic_slam/dataset/tum_images.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/image_decoding.h"
#include "semantic_slam/dataset/text_table.h"

namespace semantic_slam {

namespace fs = std::filesystem;

namespace {

cv::Mat Load(const std::string& path, int imread_flags, const CameraIntrinsics& camera) {
  const std::vector<std::uint8_t> bytes = ReadFileBytes(path);
  cv::Mat image = DecodeImage(bytes.data(), bytes.size(), imread_flags);
  std::ostringstream what;
  if (image.empty()) {
    what << "cannot decode " << path << ", " << bytes.size() << " bytes";
    throw InputError(what.str());
  }
  if (image.cols != camera.width_px || image.rows != camera.height_px) {
    what << path << " is " << image.size() << ", expected [" << camera.width_px << " x "
         << camera.height_px << "] as the camera configuration says";
    throw InputError(what.str());
  }
  return image;
}

}  // namespace

std::vector<ImageFile> ReadImageList(const std::string& folder, const std::string& list,
                                     ProblemLog& problems) {
  const std::string path = (fs::path(folder) / list).string();
  std::vector<TextRow> rows = ReadTextTable(path, 1, "stamp filename");
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TextRow& a, const TextRow& b) { return a.stamp < b.stamp; });
  std::vector<ImageFile> files;
  for (const TextRow& row : rows) {
    if (!files.empty() && files.back().stamp == row.stamp) {
      problems.Add(path + ":" + std::to_string(row.line) + ": stamp " + ToString(row.stamp) +
                   " appears twice");
      continue;
    }
    files.push_back({row.stamp, (fs::path(folder) / row.fields[0]).string()});
  }
  return files;
}

cv::Mat LoadColour(const std::string& path, const CameraConfig& camera) {
  return Load(path, cv::IMREAD_COLOR, camera.intrinsics);
}

cv::Mat LoadDepthMetres(const std::string& path, const CameraConfig& camera) {
  const cv::Mat raw = Load(path, cv::IMREAD_UNCHANGED, camera.intrinsics);
  if (raw.type() != CV_16UC1) {
    throw InputError(path + " is " + cv::typeToString(raw.type()) +
                     ", expected a 16-bit depth image with one channel");
  }
  cv::Mat depth_m;
  raw.convertTo(depth_m, CV_32FC1, 1.0 / camera.depth_png_factor);
  depth_m.setTo(std::numeric_limits<float>::quiet_NaN(), raw == 0);
  return depth_m;
}

}  // namespace semantic_slam
