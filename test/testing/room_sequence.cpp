#include "testing/room_sequence.h"

#include <cmath>
#include <filesystem>
#include <iomanip>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "testing/handheld_path.h"

namespace semantic_slam {

namespace fs = std::filesystem;

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

void WriteImage(const std::string& path, const cv::Mat& image) {
  const std::vector<int> flags{cv::IMWRITE_JPEG_QUALITY, 95, cv::IMWRITE_PNG_COMPRESSION, 1};
  if (!cv::imwrite(path, image, flags)) throw InputError("cannot write " + path);
}

cv::Mat ToDepthPng(const cv::Mat& depth_m, double factor) {
  cv::Mat finite = depth_m.clone();
  finite.setTo(0.0f, depth_m != depth_m);  // NaN
  cv::Mat png;
  finite.convertTo(png, CV_16UC1, factor);
  return png;
}

void WriteCamera(const std::string& path, const CameraIntrinsics& c, const CameraConfig& config) {
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

void WriteAccelerometer(const std::string& path,
                        const std::vector<AccelerometerReading>& readings) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << "# timestamp ax ay az\n" << std::fixed << std::setprecision(6);
    for (const AccelerometerReading& reading : readings) {
      out << ToString(reading.stamp) << " " << reading.acceleration_imu.x() << " "
          << reading.acceleration_imu.y() << " " << reading.acceleration_imu.z() << "\n";
    }
  });
}

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
  const CameraConfig config = Freiburg1Camera();
  const fs::path root(folder);
  std::error_code error;
  fs::create_directories(root / "rgb", error);
  fs::create_directories(root / "depth", error);
  if (error) throw InputError("cannot make the folder " + folder + ": " + error.message());
  std::string colour_list = "# timestamp filename\n", depth_list = colour_list;
  for (std::size_t done = 1; const auto image = sequence.Next(); ++done) {
    const std::string colour = "rgb/" + ToString(image->stamp) + ".jpg";
    const std::string depth = "depth/" + ToString(image->depth_stamp) + ".png";
    WriteImage((root / colour).string(), image->colour);
    WriteImage((root / depth).string(), ToDepthPng(image->depth_m, config.depth_png_factor));
    colour_list += ToString(image->stamp) + " " + colour + "\n";
    depth_list += ToString(image->depth_stamp) + " " + depth + "\n";
    if (on_image) on_image(done, sequence.size());
  }
  WriteCamera((root / "camera.yaml").string(), options.intrinsics, config);
  WriteTumTrajectory(RoomSequencePoses(seconds), (root / "groundtruth.txt").string());
  WriteAccelerometer((root / "accelerometer.txt").string(), sequence.accelerometer());
  WriteFileAtomically((root / "depth.txt").string(), [&](std::ostream& out) { out << depth_list; });
  // Last: a folder is a sequence once it has this list.
  WriteFileAtomically((root / "rgb.txt").string(), [&](std::ostream& out) { out << colour_list; });
}

}  // namespace semantic_slam
