#include "semantic_slam/camera/camera_model.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

CameraIntrinsics Pinhole() {
  return {640, 480, 525.0, 520.0, 319.5, 239.5, {}};
}

// TUM's freiburg 1: the strongest distortion we meet.
CameraIntrinsics Freiburg1() {
  return {640,
          480,
          517.306,
          516.469,
          318.643,
          255.314,
          {0.262383, -0.953104, -0.005358, 0.002628, 1.163314}};
}

std::string ErrorOf(const CameraIntrinsics& intrinsics) {
  return MessageOf<ConfigError>([&] { CheckIntrinsics(intrinsics); });
}

TEST(CameraModelTest, ThePrincipalPointIsOnTheOpticalAxis) {
  const CameraModel camera(Pinhole());
  EXPECT_TRUE(camera.Project({0.0, 0.0, 3.0}).isApprox(Eigen::Vector2d(319.5, 239.5)));
  // One metre right and 0.5 m down at 2 m: half and a quarter of the focal length from the centre.
  EXPECT_TRUE(camera.Project({1.0, 0.5, 2.0}).isApprox(Eigen::Vector2d(582.0, 369.5)));
}

TEST(CameraModelTest, ProjectUndoesUnproject) {
  const CameraModel camera(Pinhole());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u_px(0.0, 640.0), v_px(0.0, 480.0), depth_m(0.1, 10.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d pixel(u_px(random), v_px(random));
    const Eigen::Vector3d p_camera = camera.Unproject(pixel.x(), pixel.y(), depth_m(random));
    EXPECT_TRUE(camera.Project(p_camera).isApprox(pixel, 1e-12)) << pixel.transpose();
  }
}

TEST(CameraModelTest, WithoutDistortionRawIsUndistorted) {
  const CameraModel camera(Pinhole());
  EXPECT_TRUE(camera.Undistort({10.25f, 20.5f}).isApprox(Eigen::Vector2f(10.25f, 20.5f), 1e-5f));
  EXPECT_NEAR(camera.Ray(0, 0).x(), -319.5 / 525.0, 1e-6);
  EXPECT_FLOAT_EQ(camera.undistorted_bounds().x, 0.0f);
  EXPECT_FLOAT_EQ(camera.undistorted_bounds().width, 639.0f);
}

TEST(CameraModelTest, TheRayOfEveryPixelProjectsBackToIt) {
  const CameraModel camera(Freiburg1());
  double worst_px = 0.0;
  for (int v = 0; v < camera.height_px(); v += 7) {
    for (int u = 0; u < camera.width_px(); u += 7) {
      const Eigen::Vector2d ray = camera.Ray(u, v).cast<double>();
      const Eigen::Vector2d raw = camera.ProjectRaw({ray.x(), ray.y(), 1.0});
      worst_px = std::max(worst_px, (raw - Eigen::Vector2d(u, v)).norm());
    }
  }
  EXPECT_LT(worst_px, 1e-3);  // the table is float: 6e-8 of a ray near 1, times f = 517 px
}

TEST(CameraModelTest, TheCornersOfADistortedImageTooProjectBack) {
  const CameraModel camera(Freiburg1());
  for (const int u : {0, 639}) {
    for (const int v : {0, 479}) {
      const Eigen::Vector2d ray = camera.Ray(u, v).cast<double>();
      const Eigen::Vector2d raw = camera.ProjectRaw({ray.x(), ray.y(), 1.0});
      EXPECT_NEAR(raw.x(), u, 1e-3);
      EXPECT_NEAR(raw.y(), v, 1e-3);
    }
  }
}

TEST(CameraModelTest, UndistortBetweenPixelsAgreesWithTheLens) {
  const CameraModel camera(Freiburg1());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> x(-0.55, 0.55), y(-0.4, 0.4);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p_camera(x(random), y(random), 1.0);
    const Eigen::Vector2d raw = camera.ProjectRaw(p_camera);
    const Eigen::Vector2d expected = camera.Project(p_camera);
    const Eigen::Vector2d undistorted = camera.Undistort(raw.cast<float>()).cast<double>();
    // Bilinear between pixel centres: the lens bends by less than 0.001 px within one pixel.
    EXPECT_LT((undistorted - expected).norm(), 2e-3) << raw.transpose();
  }
}

TEST(CameraModelTest, UndistortClampsToTheImage) {
  const CameraModel camera(Freiburg1());
  EXPECT_EQ(camera.Undistort({-5.0f, -5.0f}), camera.Undistort({0.0f, 0.0f}));
  EXPECT_EQ(camera.Undistort({900.0f, 900.0f}), camera.Undistort({639.0f, 479.0f}));
}

TEST(CameraModelTest, TheBoundsHoldEveryUndistortedPixel) {
  const CameraModel camera(Freiburg1());
  const cv::Rect2f bounds = camera.undistorted_bounds();
  for (const float u : {0.0f, 320.0f, 639.0f}) {
    for (const float v : {0.0f, 240.0f, 479.0f}) {
      const Eigen::Vector2f p = camera.Undistort({u, v});
      EXPECT_GE(p.x(), bounds.x - 1e-3f);
      EXPECT_LE(p.x(), bounds.x + bounds.width + 1e-3f);
      EXPECT_GE(p.y(), bounds.y - 1e-3f);
      EXPECT_LE(p.y(), bounds.y + bounds.height + 1e-3f);
    }
  }
}

TEST(CameraModelTest, ContainsComparesSizes) {
  const CameraModel camera(Pinhole());
  EXPECT_TRUE(camera.Contains(cv::Mat(480, 640, CV_8UC1)));
  EXPECT_FALSE(camera.Contains(cv::Mat(640, 480, CV_8UC1)));
}

TEST(CheckIntrinsicsTest, NamesTheFirstUnusableIntrinsic) {
  EXPECT_EQ(ErrorOf(Pinhole()), "");
  CameraIntrinsics c = Pinhole();
  c.fx_px = 0.0;
  EXPECT_EQ(ErrorOf(c), "camera fx_px = 0, but must be in [1, 100000]");
  c = Pinhole();
  c.cy_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOf(c), "camera cy_px = nan, but must be in [-480, 960]");
  c = Pinhole();
  c.width_px = 0;
  EXPECT_EQ(ErrorOf(c), "camera width_px = 0, but must be in [8, 16384]");
}

TEST(CheckIntrinsicsTest, RefusesANumberOfCoefficientsThatOpenCvDoesNotKnow) {
  CameraIntrinsics c = Pinhole();
  c.distortion = {0.1, 0.2};
  EXPECT_EQ(ErrorOf(c),
            "camera distortion has 2 coefficients, expected 0, 4, 5 or 8 "
            "(k1 k2 p1 p2 [k3 [k4 k5 k6]])");
  c.distortion = {0.1, 0.2, 0.0, 0.0, std::numeric_limits<double>::infinity()};
  EXPECT_NE(ErrorOf(c), "");
  EXPECT_THROW(CameraModel{c}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
