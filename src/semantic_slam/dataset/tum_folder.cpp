#include "semantic_slam/dataset/tum_folder.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/accelerometer_file.h"
#include "semantic_slam/dataset/image_decoding.h"
#include "semantic_slam/dataset/text_table.h"

namespace semantic_slam {

namespace fs = std::filesystem;

namespace {

template <typename ImageFile>
std::vector<Stamp> Stamps(const std::vector<ImageFile>& files) {
  std::vector<Stamp> stamps;
  for (const ImageFile& file : files) stamps.push_back(file.stamp);
  return stamps;
}

cv::Mat LoadImage(const std::string& path, int imread_flags) {
  const std::vector<std::uint8_t> bytes = ReadFileBytes(path);
  cv::Mat image = DecodeImage(bytes.data(), bytes.size(), imread_flags);
  if (image.empty())
    throw InputError("cannot decode " + path + ", " + std::to_string(bytes.size()) + " bytes");
  return image;
}

void CheckSize(const std::string& path, const cv::Mat& image, const CameraIntrinsics& camera) {
  if (image.cols == camera.width_px && image.rows == camera.height_px) return;
  std::ostringstream what;
  what << path << " is " << image.size() << ", expected [" << camera.width_px << " x "
       << camera.height_px << "] as the camera configuration says";
  throw InputError(what.str());
}

cv::Mat LoadDepthMetres(const std::string& path, double depth_png_factor) {
  const cv::Mat raw = LoadImage(path, cv::IMREAD_UNCHANGED);
  if (raw.type() != CV_16UC1) {
    throw InputError(path + " is " + cv::typeToString(raw.type()) +
                     ", expected a 16-bit depth image with one channel");
  }
  cv::Mat depth_m;
  raw.convertTo(depth_m, CV_32FC1, 1.0 / depth_png_factor);
  depth_m.setTo(std::numeric_limits<float>::quiet_NaN(), raw == 0);
  return depth_m;
}

}  // namespace

bool IsTumFolder(const std::string& path) {
  return fs::is_regular_file(fs::path(path) / "rgb.txt");
}

TumFolder::TumFolder(const std::string& folder, const CameraConfig& camera,
                     const ImagePairerOptions& pairing)
    : folder_(folder), camera_(camera) {
  Validate(pairing);
  if (!fs::is_directory(folder_)) throw InputError("no such folder: " + folder_);
  colour_ = ReadList("rgb.txt");
  depth_ = ReadList("depth.txt");
  pairs_ = PairStamps(Stamps(colour_), Stamps(depth_), pairing.max_gap_s);
  if (pairs_.empty()) {
    std::ostringstream what;
    what << folder_ << ": none of " << colour_.size() << " colour and " << depth_.size()
         << " depth images are within " << pairing.max_gap_s << " s of each other";
    throw InputError(what.str());
  }
  const fs::path accelerometer = fs::path(folder_) / "accelerometer.txt";
  if (fs::exists(accelerometer)) accelerometer_ = ReadAccelerometerFile(accelerometer.string());
}

std::vector<TumFolder::ImageFile> TumFolder::ReadList(const std::string& name) {
  const std::string path = (fs::path(folder_) / name).string();
  std::vector<TextRow> rows = ReadTextTable(path, 1, "stamp filename");
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TextRow& a, const TextRow& b) { return a.stamp < b.stamp; });
  std::vector<ImageFile> files;
  for (const TextRow& row : rows) {
    if (!files.empty() && files.back().stamp == row.stamp) {
      problems_.Add(path + ":" + std::to_string(row.line) + ": stamp " + ToString(row.stamp) +
                    " appears twice");
      continue;
    }
    files.push_back({row.stamp, (fs::path(folder_) / row.fields[0]).string()});
  }
  return files;
}

std::optional<RgbdImage> TumFolder::Next() {
  while (next_ < pairs_.size()) {
    const PairIndices& pair = pairs_[next_++];
    try {
      return Load(colour_[pair.colour], depth_[pair.depth]);
    } catch (const InputError& e) {
      problems_.Add(e.what());
    }
  }
  return std::nullopt;
}

RgbdImage TumFolder::Load(const ImageFile& colour, const ImageFile& depth) const {
  RgbdImage image;
  image.stamp = colour.stamp;
  image.depth_stamp = depth.stamp;
  image.colour = LoadImage(colour.path, cv::IMREAD_COLOR);
  CheckSize(colour.path, image.colour, camera_.intrinsics);
  image.depth_m = LoadDepthMetres(depth.path, camera_.depth_png_factor);
  CheckSize(depth.path, image.depth_m, camera_.intrinsics);
  return image;
}

}  // namespace semantic_slam
