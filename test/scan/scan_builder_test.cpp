#include "semantic_slam/scan/scan_builder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/camera/level_frame.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

constexpr double kHeightM = 2.05;  // the band is above everything in the room but its walls
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A camera in TexturedRoom, turned by `yaw` to the left from +x, by `pitch` down, by `roll`
// clockwise.
Rigid3d Camera(double yaw_rad, double pitch_rad, double roll_rad, double z_m = kHeightM) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  Rigid3d T = Rigid3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T.linear() = AngleAxisd(yaw_rad, Vector3d::UnitZ()) * T.linear() *
               AngleAxisd(-pitch_rad, Vector3d::UnitX()) * AngleAxisd(roll_rad, Vector3d::UnitZ());
  T.translation() << 0.3, -0.2, z_m;
  return T;
}

PlanarScan Build(const RgbdImage& image, const Rigid3d& T_map_camera,
                 const ScanBuilderOptions& options = {}) {
  return ScanBuilder(options, SmallCamera()).Build(image, T_map_camera);
}

PlanarScan ScanOfRoom(const Rigid3d& T_map_camera, const ScanBuilderOptions& options = {}) {
  return Build(SmallRoomImage(T_map_camera, Stamp{1}), T_map_camera, options);
}

// Horizontal distance to the room's walls along a direction in the world.
double WallDistance(const Eigen::Vector2d& from, const Eigen::Vector2d& direction) {
  const auto along = [](double place_m, double component, double half_m) {
    return component == 0.0 ? 1e9 : (std::copysign(half_m, component) - place_m) / component;
  };
  return std::min(along(from.x(), direction.x(), TexturedRoom::kLengthM / 2),
                  along(from.y(), direction.y(), TexturedRoom::kWidthM / 2));
}

// Errors [m] of the beams that hit something, against the room's walls.
std::vector<double> WallErrors(const PlanarScan& scan, const Rigid3d& T_world_camera) {
  const Rigid3d T_world_level = LevelPose(T_world_camera);
  const Eigen::Vector2d from = T_world_level.translation().head<2>();
  std::vector<double> errors;
  for (std::size_t i = 0; i < scan.beams.size(); ++i) {
    if (scan.beams[i].status() != BeamStatus::kHit) continue;
    const Eigen::Vector2d direction =
        T_world_level.linear().topLeftCorner<2, 2>() * scan.Direction(i);
    errors.push_back(scan.beams[i].hit_m - WallDistance(from, direction));
  }
  return errors;
}

double Largest(const std::vector<double>& errors) {
  double largest = 0.0;
  for (const double error : errors) largest = std::max(largest, std::abs(error));
  return largest;
}

int Count(const PlanarScan& scan, BeamStatus status) {
  return static_cast<int>(
      std::count_if(scan.beams.begin(), scan.beams.end(),
                    [status](const ScanBeam& beam) { return beam.status() == status; }));
}

// A flat image at one depth everywhere.
RgbdImage Flat(float depth_m) {
  RgbdImage image = BlankImage(Stamp{1});
  image.depth_m.setTo(depth_m);
  return image;
}

// What a camera looking down by `pitch_rad` sees of an endless floor 2 m below; farther than 20 m
// is as far.
RgbdImage TiltedFloor(double pitch_rad) {
  RgbdImage image = Flat(20.0f);
  const Eigen::AngleAxisd tilt(-pitch_rad, Eigen::Vector3d::UnitX());
  for (int v = 0; v < image.depth_m.rows; ++v) {
    for (int u = 0; u < image.depth_m.cols; ++u) {
      const Eigen::Vector3d ray = tilt * SmallCamera()->Ray(u, v).homogeneous().cast<double>();
      if (ray.y() > 0.1) image.depth_m.at<float>(v, u) = static_cast<float>(2.0 / ray.y());
    }
  }
  return image;
}

// Depth is exact here. 2 cm: a beam is half a degree wide and reports the mean of its pixels.
constexpr double kExactM = 0.02;

TEST(ScanBuilderTest, FindsTheWallsWhicheverWayItLooks) {
  for (const double yaw_rad : {0.0, 0.8, 1.6, 3.0, -2.0}) {
    const Rigid3d T = Camera(yaw_rad, 0.0, 0.0);
    const PlanarScan scan = ScanOfRoom(T);
    const std::vector<double> errors = WallErrors(scan, T);
    EXPECT_GT(errors.size(), 110u) << "the view is 63 degrees wide: 126 beams";
    EXPECT_LT(Largest(errors), kExactM) << "yaw " << yaw_rad;
    EXPECT_EQ(Count(scan, BeamStatus::kFree), 0) << "there is a wall everywhere";
  }
}

TEST(ScanBuilderTest, FindsTheWallsLookingUpAndDown) {
  for (const double pitch_rad : {-0.3, 0.3}) {
    const Rigid3d T = Camera(0.4, pitch_rad, 0.0);
    const std::vector<double> errors = WallErrors(ScanOfRoom(T), T);
    EXPECT_GT(errors.size(), 110u);
    EXPECT_LT(Largest(errors), kExactM) << "pitch " << pitch_rad;
  }
}

TEST(ScanBuilderTest, SeesTheSameWhenTheCameraIsRolled) {
  const PlanarScan upright = ScanOfRoom(Camera(0.4, 0.1, 0.0));
  for (const double roll_rad : {-0.3, 0.6, M_PI / 2, M_PI}) {
    const PlanarScan rolled = ScanOfRoom(Camera(0.4, 0.1, roll_rad));
    ASSERT_EQ(rolled.beams.size(), upright.beams.size());
    int compared = 0;
    for (std::size_t i = 0; i < rolled.beams.size(); ++i) {
      if (rolled.beams[i].status() != BeamStatus::kHit) continue;
      if (upright.beams[i].status() != BeamStatus::kHit) continue;
      EXPECT_NEAR(rolled.beams[i].hit_m, upright.beams[i].hit_m, kExactM);
      ++compared;
    }
    EXPECT_GT(compared, 80) << "roll " << roll_rad << "; 90 beams across the short side";
  }
}

TEST(ScanBuilderTest, IsFreeUpToTheWall) {
  const PlanarScan scan = ScanOfRoom(Camera(0.0, 0.0, 0.0));
  const auto middle = static_cast<std::ptrdiff_t>(scan.beams.size() / 2);
  // 45 degrees of the 63 in view: towards the image's edges less height is in view nearby.
  for (std::ptrdiff_t i = middle - 45; i < middle + 45; ++i) {
    const ScanBeam& beam = scan.beams[i];
    EXPECT_EQ(beam.free_from_m, 0.0f);
    EXPECT_LE(beam.free_to_m, beam.hit_m);
    EXPECT_GT(beam.free_to_m, beam.hit_m - 0.12) << "slanting walls end the pixels' rays earlier";
  }
}

TEST(ScanBuilderTest, DoesNotClearWhatItHardlySees) {
  // Looking down by 0.5 rad, the view's upper edge falls by 0.04 per metre, so of a band 0.1 m
  // about the camera's height the lower half is in view, and less and less of it.
  ScanBuilderOptions options;
  options.band_lower_m = -0.1;
  options.band_upper_m = 0.1;
  options.min_free_share = 0.6;
  const PlanarScan scan = Build(TiltedFloor(0.5), Camera(0.0, 0.5, 0.0), options);
  EXPECT_EQ(Count(scan, BeamStatus::kFree), 0);
  options.min_free_share = 0.1;
  EXPECT_GT(Count(Build(TiltedFloor(0.5), Camera(0.0, 0.5, 0.0), options), BeamStatus::kFree), 100);
}

TEST(ScanBuilderTest, FindsTheWallsWithinTheSensorsNoise) {
  const TexturedRoom room;  // 640 x 480, distorted, noisy
  const Rigid3d T = Camera(0.4, 0.15, 0.1);
  const auto camera = std::make_shared<const CameraModel>(Freiburg1Camera().intrinsics);
  const ScanBuilder builder({}, camera);
  const std::vector<double> errors = WallErrors(builder.Build(room.Render(T, Stamp{1}), T), T);
  EXPECT_GT(errors.size(), 100u);
  double sum_m = 0.0;
  for (const double error : errors) sum_m += std::abs(error);
  // A Kinect's noise is 1 cm at 2.7 m, and some ten pixels are averaged; 3 cm is half a cell.
  EXPECT_LT(sum_m / errors.size(), 0.01);
  EXPECT_LT(Largest(errors), 0.03);
}

TEST(ScanBuilderTest, LooksOnlyAtTheBand) {
  // High up nothing stands before the wall; at 1.0 m the screens do (x = 2.05 m, 0.6 m wide).
  const Rigid3d T = Camera(0.0, 0.0, 0.0, 1.0);
  const PlanarScan flight = ScanOfRoom(T);
  ScanBuilderOptions options;
  options.fixed_band = true;
  options.band_lower_m = 1.4;
  options.band_upper_m = 1.6;
  const PlanarScan above = ScanOfRoom(T, options);
  const auto nearer = [](double error) { return error < -0.3; };
  const std::vector<double> flight_errors = WallErrors(flight, T);
  const std::vector<double> above_errors = WallErrors(above, T);
  EXPECT_GT(std::count_if(flight_errors.begin(), flight_errors.end(), nearer), 20);
  EXPECT_EQ(std::count_if(above_errors.begin(), above_errors.end(), nearer), 0);
  EXPECT_GT(above_errors.size(), 100u);
}

TEST(ScanBuilderTest, DoesNotClearWhatIsBelowItsView) {
  // A fixed band half a metre above the camera: its lower parts are out of sight nearby.
  const Rigid3d T = Camera(0.0, 0.0, 0.0, 1.0);
  ScanBuilderOptions options;
  options.fixed_band = true;
  options.band_lower_m = 1.5;
  options.band_upper_m = 1.7;
  int seen_free = 0;
  for (const ScanBeam& beam : ScanOfRoom(T, options).beams) {
    if (beam.free_to_m == 0.0f) continue;
    ++seen_free;
    // The view's upper edge climbs by 0.46 per metre ahead.
    EXPECT_GT(beam.free_from_m, 1.0);
  }
  EXPECT_GT(seen_free, 50);
}

TEST(ScanBuilderTest, KnowsNothingOfABandOutOfView) {
  // Straight down, and up by more than half the vertical view (25 degrees) at a band of no height.
  ScanBuilderOptions options;
  options.band_lower_m = -0.001;
  options.band_upper_m = 0.001;
  for (const double pitch_rad : {M_PI / 2, -0.6}) {
    const PlanarScan scan = ScanOfRoom(Camera(0.0, pitch_rad, 0.0), options);
    EXPECT_EQ(Count(scan, BeamStatus::kUnknown), static_cast<int>(scan.beams.size()));
  }
}

TEST(ScanBuilderTest, IsFreeToTheMaximumRangeWhereNothingIs) {
  const PlanarScan scan = Build(Flat(20.0f), Camera(0.0, 0.0, 0.0));
  EXPECT_EQ(Count(scan, BeamStatus::kHit), 0);
  EXPECT_GT(Count(scan, BeamStatus::kFree), 110);
  for (const ScanBeam& beam : scan.beams) {
    if (beam.status() == BeamStatus::kFree) {
      EXPECT_EQ(beam.free_to_m, 5.0f);
    }
  }
}

TEST(ScanBuilderTest, TakesNoDepthForUnknownNeverForFree) {
  for (const float depth_m : {kNan, 0.0f, -1.0f, std::numeric_limits<float>::infinity()}) {
    const PlanarScan scan = Build(Flat(depth_m), Camera(0.0, 0.0, 0.0));
    EXPECT_EQ(Count(scan, BeamStatus::kUnknown), static_cast<int>(scan.beams.size())) << depth_m;
  }
  // Something dark covers most of the band in the left half, with a wall in sight above and below.
  RgbdImage image = Flat(3.0f);
  image.depth_m(cv::Rect(0, 110, 160, 20)).setTo(kNan);
  for (const ScanBeam& beam : Build(image, Camera(0.0, 0.0, 0.0)).beams) {
    EXPECT_NE(beam.status(), BeamStatus::kFree);
  }
  // 20 of the 35 rows that are inside the band at 3 m say nothing, and of the 52 rows at 2 m.
  const PlanarScan scan = Build(image, Camera(0.0, 0.0, 0.0));
  const std::size_t left = scan.beams.size() / 2 + 20, right = scan.beams.size() / 2 - 20;
  EXPECT_GT(scan.beams[left].free_to_m, 1.5);
  EXPECT_LT(scan.beams[left].free_to_m, 2.8);
  EXPECT_GT(scan.beams[right].free_to_m, 2.8);
}

TEST(ScanBuilderTest, IgnoresSinglePixels) {
  RgbdImage image = Flat(3.0f);
  for (const int v : {60, 118, 120}) image.depth_m.at<float>(v, 160) = 1.0f;
  const PlanarScan scan = Build(image, Camera(0.0, 0.0, 0.0));
  for (const ScanBeam& beam : scan.beams) {
    if (beam.status() == BeamStatus::kHit) {
      EXPECT_GT(beam.hit_m, 2.9f);
    }
  }
}

TEST(ScanBuilderTest, IgnoresTheRobotItself) {
  const PlanarScan scan = Build(Flat(0.1f), Camera(0.0, 0.0, 0.0));
  EXPECT_EQ(Count(scan, BeamStatus::kUnknown), static_cast<int>(scan.beams.size()));
}

TEST(ScanBuilderTest, RefusesWhatDoesNotFit) {
  const Rigid3d T = Camera(0.0, 0.0, 0.0);
  EXPECT_EQ(MessageOf<InputError>([&] { Build(RgbdImage(), T); }), "colour image is empty");
  RgbdImage small;
  small.colour = cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(0));
  small.depth_m = cv::Mat(8, 8, CV_32FC1, cv::Scalar::all(1));
  EXPECT_EQ(MessageOf<InputError>([&] { Build(small, T); }),
            "image is [8 x 8] but the camera's calibration is for [320 x 240]");
  Rigid3d broken = T;
  broken.translation().x() = kNan;
  EXPECT_EQ(MessageOf<InputError>([&] { Build(Flat(1.0f), broken); }),
            "the camera's pose is not finite");
}

TEST(ScanBuilderTest, RefusesAnEmptyBand) {
  ScanBuilderOptions options;
  options.band_lower_m = 0.3;
  options.band_upper_m = 0.3;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ScanBuilder(options, SmallCamera()); }),
            "band_lower_m = 0.3, but must be below band_upper_m = 0.3");
}

}  // namespace
}  // namespace semantic_slam
