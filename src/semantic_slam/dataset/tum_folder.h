#pragma once

#include <string>
#include <vector>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/dataset/image_pairer.h"
#include "semantic_slam/dataset/problem_log.h"
#include "semantic_slam/dataset/rgbd_source.h"
#include "semantic_slam/dataset/tum_images.h"

namespace semantic_slam {

// A sequence in the format of the TUM RGB-D benchmark: a folder with rgb.txt and depth.txt (lines
// "stamp filename"), the images they name (8-bit colour PNG or JPEG; 16-bit depth PNG registered to
// colour, 0 where there is no return) and optionally accelerometer.txt. Not thread-safe.
class TumFolder : public RgbdSource {
 public:
  // Reads the lists, not yet the images. `camera` says how large the images are and what a unit of
  // depth is. Throws InputError, in one line, if the folder or a list is missing, a line of a list
  // is not understood (naming file and line), or no images pair up.
  TumFolder(const std::string& folder, const CameraConfig& camera,
            const ImagePairerOptions& pairing = {});

  std::size_t size() const override { return pairs_.size(); }
  std::optional<RgbdImage> Next() override;
  const std::vector<std::string>& problems() const override { return problems_.reasons(); }
  std::size_t dropped() const override { return problems_.count(); }
  const std::vector<AccelerometerReading>& accelerometer() const override { return accelerometer_; }

 private:
  RgbdImage Load(const ImageFile& colour, const ImageFile& depth) const;

  const CameraConfig camera_;
  std::vector<ImageFile> colour_;
  std::vector<ImageFile> depth_;
  std::vector<PairIndices> pairs_;
  std::size_t next_ = 0;
  ProblemLog problems_;
  std::vector<AccelerometerReading> accelerometer_;
};

// Whether `path` looks like such a folder: it has an rgb.txt.
bool IsTumFolder(const std::string& path);

}  // namespace semantic_slam
