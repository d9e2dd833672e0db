#include "testing/room_sequence.h"

#include <cmath>

#include "semantic_slam/dataset/tum_folder_writer.h"
#include "testing/handheld_path.h"

namespace semantic_slam {

namespace {

constexpr double kImagesPerS = 30.0;
constexpr double kAccelerometerPerS = 100.0;
constexpr std::int64_t kDepthDelayNs = 8'000'000;

std::size_t Images(double seconds) {
  return static_cast<std::size_t>(std::floor(seconds * kImagesPerS));
}

double ImageTime(std::size_t i) {
  return static_cast<double>(i) / kImagesPerS;
}

// To the microsecond, as TUM's files have it.
Stamp StampAt(double t_s) {
  return {kRoomSequenceStart.ns + 1000 * static_cast<std::int64_t>(std::llround(t_s * 1e6))};
}

class RoomSequence : public RgbdSource {
 public:
  RoomSequence(double seconds, const TexturedRoomOptions& options)
      : room_(options), size_(Images(seconds)) {
    const Eigen::Matrix3d R_imu_camera = Freiburg1Camera().R_camera_imu.transpose();
    const auto readings = static_cast<std::size_t>(seconds * kAccelerometerPerS);
    for (std::size_t i = 0; i < readings; ++i) {
      const double t_s = static_cast<double>(i) / kAccelerometerPerS;
      accelerometer_.push_back({StampAt(t_s), R_imu_camera * HandheldPath::SpecificForce(t_s)});
    }
  }

  std::size_t size() const override { return size_; }
  std::optional<RgbdImage> Next() override {
    if (next_ == size_) return std::nullopt;
    const double t_s = ImageTime(next_++);
    RgbdImage image = room_.Render(HandheldPath::T_world_camera(t_s), StampAt(t_s));
    image.depth_stamp.ns += kDepthDelayNs;
    return image;
  }
  const std::vector<std::string>& problems() const override { return problems_; }
  std::size_t dropped() const override { return 0; }
  const std::vector<AccelerometerReading>& accelerometer() const override { return accelerometer_; }

 private:
  const TexturedRoom room_;
  const std::size_t size_;
  std::size_t next_ = 0;
  const std::vector<std::string> problems_;
  std::vector<AccelerometerReading> accelerometer_;
};

}  // namespace

std::unique_ptr<RgbdSource> MakeRoomSequence(double seconds, const TexturedRoomOptions& options) {
  return std::make_unique<RoomSequence>(seconds, options);
}

Trajectory RoomSequencePoses(double seconds) {
  Trajectory poses;
  for (std::size_t i = 0; i < Images(seconds); ++i) {
    poses.push_back({StampAt(ImageTime(i)), HandheldPath::T_world_camera(ImageTime(i))});
  }
  return poses;
}

void WriteRoomSequence(const std::string& folder, double seconds,
                       const TexturedRoomOptions& options,
                       const std::function<void(std::size_t, std::size_t)>& on_image) {
  RoomSequence sequence(seconds, options);
  CameraConfig config = Freiburg1Camera();
  config.intrinsics = options.intrinsics;
  TumFolderWriter writer(folder, config);
  for (std::size_t done = 1; const auto image = sequence.Next(); ++done) {
    writer.Add(*image);
    if (on_image) on_image(done, sequence.size());
  }
  WriteTumTrajectory(RoomSequencePoses(seconds), folder + "/groundtruth.txt");
  writer.WriteAccelerometer(sequence.accelerometer());
  writer.Finish();
}

}  // namespace semantic_slam
