#include "testing/textured_room.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "testing/handheld_path.h"

namespace semantic_slam {
namespace {

const Stamp kNow{1'000'000'000};

TexturedRoomOptions Exact() {
  TexturedRoomOptions options;
  options.noise = false;
  return options;
}

// Level, at `p`, looking along the world's +y.
Rigid3d LookingAlongY(const Eigen::Vector3d& p) {
  Eigen::Matrix3d R_world_camera;
  R_world_camera << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // x right, y down = -z, z forward = y
  Rigid3d T_world_camera = Rigid3d::Identity();
  T_world_camera.linear() = R_world_camera;
  T_world_camera.translation() = p;
  return T_world_camera;
}

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST(TexturedRoomTest, DepthOfAWallIsTheDistanceAlongTheAxisAtEveryPixel) {
  const TexturedRoom room(Exact());
  const auto image = room.Render(LookingAlongY({-0.5, 0.0, 2.0}), kNow);
  for (const int u : {0, 100, 320, 500}) {
    // The wall at +y is 2 m away, whatever the ray's direction.
    EXPECT_NEAR(image.depth_m.at<float>(200, u), TexturedRoom::kWidthM / 2, 1e-6) << u;
  }
}

TEST(TexturedRoomTest, DepthOfTheFloorFollowsFromTheRay) {
  const TexturedRoom room(Exact());
  const double height_m = 1.2;
  const auto image = room.Render(LookingAlongY({-0.5, -1.0, height_m}), kNow);
  const Eigen::Vector2f ray = room.camera().Ray(320, 470);
  EXPECT_NEAR(image.depth_m.at<float>(470, 320), height_m / ray.y(), 1e-5);
}

TEST(TexturedRoomTest, DepthOfABoxIsTheDistanceOfItsFace) {
  const TexturedRoom room(Exact());
  // The cupboard has a face at y = 0.7 for x from -2.25 to -1.75 and is 1.8 m high.
  const auto image = room.Render(LookingAlongY({-2.0, -1.0, 1.0}), kNow);
  EXPECT_NEAR(image.depth_m.at<float>(240, 320), 1.7, 1e-6);
}

TEST(TexturedRoomTest, PointsThatTwoViewsShareLookTheSame) {
  const TexturedRoom room(Exact());
  const Rigid3d T_world_a = HandheldPath::T_world_camera(2.0);
  const Rigid3d T_world_b = HandheldPath::T_world_camera(2.3);
  const auto a = room.Render(T_world_a, kNow), b = room.Render(T_world_b, kNow);
  int compared = 0, alike = 0;
  for (int v = 20; v < 460; v += 10) {
    for (int u = 20; u < 620; u += 10) {
      const Eigen::Vector3d p_a =
          room.camera().Ray(u, v).homogeneous().cast<double>() * a.depth_m.at<float>(v, u);
      const Eigen::Vector3d p_b = T_world_b.inverse() * T_world_a * p_a;
      const Eigen::Vector2d pixel = room.camera().ProjectRaw(p_b);
      const cv::Point at(cvRound(pixel.x()), cvRound(pixel.y()));
      if (!cv::Rect(0, 0, 640, 480).contains(at)) continue;
      if (std::abs(b.depth_m.at<float>(at) - p_b.z()) > 0.02) continue;  // hidden by something
      ++compared;
      const cv::Vec3b x = a.colour.at<cv::Vec3b>(v, u), y = b.colour.at<cv::Vec3b>(at);
      if (cv::norm(cv::Vec3d(x) - cv::Vec3d(y)) < 60.0) ++alike;
    }
  }
  EXPECT_GT(compared, 1500);
  EXPECT_GT(alike, 0.95 * compared);  // the rest lies at edges, half a pixel apart
}

TEST(TexturedRoomTest, TheSameSeedGivesTheSameBytes) {
  const Rigid3d T_world_camera = HandheldPath::T_world_camera(1.0);
  const auto first = TexturedRoom().Render(T_world_camera, kNow);
  const auto again = TexturedRoom().Render(T_world_camera, kNow);
  EXPECT_TRUE(SameBytes(first.colour, again.colour));
  EXPECT_TRUE(SameBytes(first.depth_m, again.depth_m));
  TexturedRoomOptions options;
  options.seed = 2;
  EXPECT_FALSE(SameBytes(first.colour, TexturedRoom(options).Render(T_world_camera, kNow).colour));
}

TEST(TexturedRoomTest, NoiseIsAKinects) {
  const Rigid3d T_world_camera = LookingAlongY({-0.5, 0.0, 2.0});
  const auto exact = TexturedRoom(Exact()).Render(T_world_camera, kNow);
  const auto noisy = TexturedRoom().Render(T_world_camera, kNow);
  EXPECT_NO_THROW(CheckRgbdImage(noisy));
  double sum = 0.0;
  int count = 0;
  for (int u = 0; u < 640; ++u) {
    const double error = noisy.depth_m.at<float>(200, u) - exact.depth_m.at<float>(200, u);
    if (exact.depth_m.at<float>(200, u) < 1.99f || std::isnan(error)) continue;
    sum += error * error;
    ++count;
  }
  // 1.425e-3 * 2^2 m = 5.7 mm; the deviation of a deviation from 500 samples is 3 %.
  EXPECT_NEAR(std::sqrt(sum / count), 5.7e-3, 0.6e-3);
  EXPECT_FALSE(
      SameBytes(noisy.depth_m, TexturedRoom().Render(T_world_camera, Stamp{kNow.ns + 1}).depth_m));
}

TEST(TexturedRoomTest, EveryViewOfThePathIsFullOfCorners) {
  const TexturedRoom room;
  for (double t_s = 0.0; t_s < 16.0; t_s += 2.0) {
    const auto image = room.Render(HandheldPath::T_world_camera(t_s), kNow);
    cv::Mat grey;
    cv::cvtColor(image.colour, grey, cv::COLOR_BGR2GRAY);
    std::vector<cv::KeyPoint> corners;
    cv::FAST(grey, corners, 20);
    EXPECT_GT(corners.size(), 1000u) << "at " << t_s << " s";
    EXPECT_GT(cv::countNonZero(image.depth_m == image.depth_m), 0.9 * 640 * 480) << t_s;
  }
}

}  // namespace
}  // namespace semantic_slam
