#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// One reading of the accelerometer: specific force [m/s^2] in the sensor's own axes. At rest it
// points up with 9.81.
struct AccelerometerReading {
  Stamp stamp;
  Eigen::Vector3d acceleration_imu;
};

// A recorded RGB-D sequence, read in order of time. Not thread-safe.
class RgbdSource {
 public:
  virtual ~RgbdSource() = default;

  // How many pairs there are at most, for progress; some may yet turn out not to be readable.
  virtual std::size_t size() const = 0;

  // The next pair, with a later stamp than the one before; nullopt at the end. Pairs that cannot be
  // decoded are left out and counted.
  virtual std::optional<RgbdImage> Next() = 0;

  // Why pairs were left out so far: one line each, the first few; and how many in all.
  virtual const std::vector<std::string>& problems() const = 0;
  virtual std::size_t dropped() const = 0;

  // All accelerometer readings by ascending stamp; empty if the recording has none. The same from
  // construction on.
  virtual const std::vector<AccelerometerReading>& accelerometer() const = 0;

  // Rotation from the accelerometer's axes to the colour optical frame, where the recording itself
  // says so; else it is the camera configuration's.
  virtual std::optional<Eigen::Matrix3d> R_camera_imu() const { return std::nullopt; }
};

}  // namespace semantic_slam
