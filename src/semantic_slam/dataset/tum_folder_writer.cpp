#include "semantic_slam/dataset/tum_folder_writer.h"

#include <filesystem>
#include <iomanip>
#include <utility>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {

namespace fs = std::filesystem;

namespace {

constexpr char kColour[] = "rgb";
constexpr char kDepth[] = "depth";
constexpr int kJpegQuality = 95;
constexpr int kPngCompression = 1;  // more takes many times as long and saves little

cv::Mat InBgr(const RgbdImage& image) {
  if (image.order == ColourOrder::kBgr) return image.colour;
  cv::Mat bgr;
  cv::cvtColor(image.colour, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

cv::Mat ToDepthPng(const cv::Mat& depth_m, double factor) {
  cv::Mat storable = depth_m.clone();
  storable.setTo(0.0f, ~(depth_m < 65535.5 / factor));  // NaN too
  cv::Mat png;
  storable.convertTo(png, CV_16UC1, factor);
  return png;
}

void WriteCamera(const std::string& path, const CameraConfig& config) {
  const CameraIntrinsics& c = config.intrinsics;
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << std::setprecision(10) << "camera:\n  width_px: " << c.width_px
        << "\n  height_px: " << c.height_px << "\n  fx_px: " << c.fx_px << "\n  fy_px: " << c.fy_px
        << "\n  cx_px: " << c.cx_px << "\n  cy_px: " << c.cy_px << "\n  distortion: [";
    for (std::size_t i = 0; i < c.distortion.size(); ++i) {
      out << (i == 0 ? "" : ", ") << c.distortion[i];
    }
    out << "]\nimu:\n  R_camera_imu: [";
    for (int i = 0; i < 9; ++i) out << (i == 0 ? "" : ", ") << config.R_camera_imu(i / 3, i % 3);
    out << "]\ndataset:\n  depth_png_factor: " << config.depth_png_factor << "\n";
  });
}

}  // namespace

TumFolderWriter::TumFolderWriter(std::string folder, const CameraConfig& camera)
    : folder_(std::move(folder)), depth_png_factor_(camera.depth_png_factor) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputError("cannot make the folder " + folder_ + ": " + error.message());
  fs::remove(PathOf("rgb.txt"), error);
  WriteCamera(PathOf("camera.yaml"), camera);
}

void TumFolderWriter::Add(const RgbdImage& image) {
  AddFile(kColour, image.stamp, ".jpg", InBgr(image));
  if (image.depth_m.empty()) return;
  AddFile(kDepth, image.depth_stamp, ".png", ToDepthPng(image.depth_m, depth_png_factor_));
}

void TumFolderWriter::Add(const std::string& kind, Stamp stamp, const cv::Mat& image) {
  AddFile(kind, stamp, ".png", image);
}

void TumFolderWriter::AddFile(const std::string& kind, Stamp stamp, const std::string& extension,
                              const cv::Mat& image) {
  std::string& list = lists_[kind];
  std::error_code error;
  if (list.empty()) fs::create_directories(PathOf(kind), error);
  const std::string name = kind + "/" + ToString(stamp) + extension;
  const std::vector<int> flags{cv::IMWRITE_JPEG_QUALITY, kJpegQuality, cv::IMWRITE_PNG_COMPRESSION,
                               kPngCompression};
  if (error || !cv::imwrite(PathOf(name), image, flags)) {
    throw InputError("cannot write " + PathOf(name));
  }
  list += ToString(stamp) + " " + name + "\n";
}

void TumFolderWriter::WriteAccelerometer(const std::vector<AccelerometerReading>& readings) const {
  WriteFileAtomically(PathOf("accelerometer.txt"), [&](std::ostream& out) {
    out << "# timestamp ax ay az\n" << std::fixed << std::setprecision(6);
    for (const AccelerometerReading& reading : readings) {
      out << ToString(reading.stamp) << " " << reading.acceleration_imu.x() << " "
          << reading.acceleration_imu.y() << " " << reading.acceleration_imu.z() << "\n";
    }
  });
}

void TumFolderWriter::Finish() const {
  const auto write = [this](const std::string& kind, const std::string& lines) {
    WriteFileAtomically(PathOf(kind + ".txt"), [&lines](std::ostream& out) {
      out << "# timestamp filename\n" << lines;
    });
  };
  for (const auto& [kind, lines] : lists_) {
    if (kind != kColour) write(kind, lines);
  }
  const auto colour = lists_.find(kColour);
  if (colour != lists_.end()) write(kColour, colour->second);
}

std::string TumFolderWriter::PathOf(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

}  // namespace semantic_slam
