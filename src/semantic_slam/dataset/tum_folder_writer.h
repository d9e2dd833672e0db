#pragma once

#include <map>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/dataset/rgbd_source.h"

namespace semantic_slam {

// Writes an RGB-D sequence as a folder in the format of the TUM RGB-D benchmark: rgb/*.jpg,
// depth/*.png and their lists, with camera.yaml for the calibration, and images of other kinds
// beside them. The folder is a sequence once it has rgb.txt, which comes last. Not thread-safe.
class TumFolderWriter {
 public:
  // Makes the folder, if it is not there. A list of images that it has from before goes. Throws
  // InputError naming what cannot be written, as all methods do.
  TumFolderWriter(std::string folder, const CameraConfig& camera);

  // Colour and, unless it is empty, depth; depth [m] is rounded to 1 / depth_png_factor, and 0 where
  // there is no return or too far away for 16 bits.
  void Add(const RgbdImage& image);

  // An image of another kind, 8 or 16 bits: KIND/<stamp>.png, listed in KIND.txt.
  void Add(const std::string& kind, Stamp stamp, const cv::Mat& image);

  // Writes accelerometer.txt.
  void WriteAccelerometer(const std::vector<AccelerometerReading>& readings) const;

  // Writes the lists. No Add() after that.
  void Finish() const;

 private:
  void AddFile(const std::string& kind, Stamp stamp, const std::string& extension,
               const cv::Mat& image);
  std::string PathOf(const std::string& name) const;

  const std::string folder_;
  const double depth_png_factor_;
  std::map<std::string, std::string> lists_;  // by kind: the lines of its list
};

}  // namespace semantic_slam
