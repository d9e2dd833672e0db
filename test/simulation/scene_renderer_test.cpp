#include "semantic_slam/simulation/scene_renderer.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "simulation/world_builder.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

// Depth is promised to that.
constexpr double kExactM = 1e-5;

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

bool SamePixels(const RenderedView& a, const RenderedView& b) {
  return SamePixels(a.colour, b.colour) && SamePixels(a.depth_m, b.depth_m) &&
         SamePixels(a.labels, b.labels) && SamePixels(a.instances, b.instances) &&
         SamePixels(a.incidence, b.incidence);
}

// Ray of a pixel in the world, scaled so that its parameter is depth.
Eigen::Vector3d RayOf(const Rigid3d& T_world_camera, const CameraModel& camera, int u, int v) {
  return T_world_camera.linear() * camera.Ray(u, v).cast<double>().homogeneous();
}

// The parameter at which a ray enters a box, or leaves it if it begins inside; NaN if it misses.
double ThroughBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& ray) {
  const Eigen::Array3d a = (box.min() - origin).array() / ray.array();
  const Eigen::Array3d b = (box.max() - origin).array() / ray.array();
  const double enters = a.min(b).maxCoeff(), leaves = a.max(b).minCoeff();
  if (enters > leaves || leaves < 0.0) return std::numeric_limits<double>::quiet_NaN();
  return enters > 0.0 ? enters : leaves;
}

TEST(SceneRendererTest, DepthOfARoomSeenAskewIsExact) {
  WorldBuilder builder;
  builder.AddRoom(1, {-7, -6, 0}, {7, 6, 3});
  const SceneRenderer renderer(builder.Build());
  const Eigen::AlignedBox3d room(Eigen::Vector3d(-7, -6, 0), Eigen::Vector3d(7, 6, 3));
  const CameraModel camera = SmallCamera();
  for (const auto& [from, to] :
       {std::pair(Eigen::Vector3d(-6.1, -5.2, 1.1), Eigen::Vector3d(3, 2, 1)),
        std::pair(Eigen::Vector3d(2, 1, 0.3), Eigen::Vector3d(-1, 0.5, 3))}) {
    const Rigid3d T_world_camera = LookAt(from, to);
    const RenderedView view = renderer.Render(T_world_camera, camera, 0.0);
    for (int v = 0; v < camera.height_px(); ++v) {
      for (int u = 0; u < camera.width_px(); ++u) {
        const double expected_m = ThroughBox(room, from, RayOf(T_world_camera, camera, u, v));
        ASSERT_NEAR(view.depth_m.at<float>(v, u), expected_m, kExactM) << u << ' ' << v;
        ASSERT_EQ(view.labels.at<LabelId>(v, u), 1);
        ASSERT_EQ(view.instances.at<InstanceId>(v, u), 1);
      }
    }
  }
}

TEST(SceneRendererTest, DepthLabelAndInstanceAgreeOnTurnedBoxes) {
  WorldBuilder builder;
  Rigid3d T_world_box = Rigid3d::Identity();
  T_world_box.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 1, 2).normalized()).toRotationMatrix();
  T_world_box.translation() << 3.0, 0.2, 0.1;
  builder.Add(4, BoxMesh({0, 0, 0}, {1.0f, 0.8f, 0.6f})).T_world_object = T_world_box;
  builder.Add(9, BoxMesh({4.5f, 0, 0}, {0.2f, 3, 3}));
  const SceneRenderer renderer(builder.Build());
  const CameraModel camera = SmallCamera(96, 72);
  const Rigid3d T_world_camera = LookAt({0, 0.1, 0.2}, {3, 0, 0});
  const RenderedView view = renderer.Render(T_world_camera, camera, 0.0);
  const Eigen::AlignedBox3d near(Eigen::Vector3d(-0.5, -0.4, -0.3), Eigen::Vector3d(0.5, 0.4, 0.3));
  const Eigen::AlignedBox3d far(Eigen::Vector3d(4.4, -1.5, -1.5), Eigen::Vector3d(4.6, 1.5, 1.5));
  const Rigid3d T_box_world = T_world_box.inverse();
  int seen_near = 0, seen_far = 0, seen_nothing = 0, doubtful = 0;
  for (int v = 0; v < camera.height_px(); ++v) {
    for (int u = 0; u < camera.width_px(); ++u) {
      const Eigen::Vector3d ray = RayOf(T_world_camera, camera, u, v);
      const Eigen::Vector3d origin = T_world_camera.translation();
      const double near_m = ThroughBox(near, T_box_world * origin, T_box_world.linear() * ray);
      const double far_m = ThroughBox(far, origin, ray);
      const InstanceId expected = !std::isnan(near_m) ? 1 : !std::isnan(far_m) ? 2 : kNoInstance;
      const InstanceId seen = view.instances.at<InstanceId>(v, u);
      const float depth_m = view.depth_m.at<float>(v, u);
      if (seen != expected) {
        ++doubtful;
        continue;
      }
      ASSERT_EQ(view.labels.at<LabelId>(v, u), seen == 1 ? 4 : seen == 2 ? 9 : kUnknownLabel);
      if (seen == kNoInstance) {
        ++seen_nothing;
        ASSERT_TRUE(std::isnan(depth_m));
        ASSERT_EQ(view.colour.at<cv::Vec3b>(v, u), cv::Vec3b());
      } else {
        ++(seen == 1 ? seen_near : seen_far);
        ASSERT_NEAR(depth_m, seen == 1 ? near_m : far_m, kExactM);
      }
    }
  }
  EXPECT_GT(seen_near, 200);
  EXPECT_GT(seen_far, 300);
  EXPECT_GT(seen_nothing, 300);
  EXPECT_LE(doubtful, 2);  // a ray may pass within a float's rounding of an edge
}

TEST(SceneRendererTest, LidOfACylinderAndAQuadAreExactThroughALens) {
  WorldBuilder builder;
  builder.Add(9, CylinderMesh({0, 0, 0}, 0.5f, 0.5f, 1.0f, 64));
  builder.Add(4, QuadMesh({-3, 3, -1}, {6, 0, 0}, {0, -6, 0}));
  const SceneRenderer renderer(builder.Build());
  const CameraModel camera({64, 48, 40.0, 41.0, 30.0, 25.0, {-0.2, 0.05, 0.001, -0.002}});
  const Rigid3d T_world_camera = LookAt({0.1, 0.05, 3}, {0, 0, 0}, Eigen::Vector3d::UnitY());
  const RenderedView view = renderer.Render(T_world_camera, camera, 0.0);
  int lid = 0, floor = 0;
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      const Eigen::Vector3d ray = RayOf(T_world_camera, camera, u, v);
      const double lid_m = (1.0 - 3.0) / ray.z();
      const Eigen::Vector2d on_lid = (T_world_camera.translation() + lid_m * ray).head<2>();
      const float depth_m = view.depth_m.at<float>(v, u);
      if (on_lid.norm() < 0.49) {  // within the 64-sided lid
        ++lid;
        ASSERT_NEAR(depth_m, lid_m, kExactM);
        // The cosine between the ray and the vertical.
        ASSERT_NEAR(view.incidence.at<float>(v, u), -ray.z() / ray.norm(), 1e-6);
      } else if (view.labels.at<LabelId>(v, u) == 4) {
        ++floor;
        ASSERT_NEAR(depth_m, (-1.0 - 3.0) / ray.z(), kExactM);
      }
    }
  }
  EXPECT_GT(lid, 100);
  EXPECT_GT(floor, 500);
}

WorldBuilder LitRoom() {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  builder.Add(4, BoxMesh({0.3f, 0, 0.7f}, {1.0f, 0.8f, 0.04f}),
              builder.AddMaterial({"wood", {150, 100, 60}, 1, {0, 0}, 0.5f, 0.0f}));
  builder.Add(9, EllipsoidMesh({0.3f, 0, 0.9f}, {0.1f, 0.1f, 0.15f}));
  builder.Add(3, BoxMesh({0, 0, 0.8f}, {0.3f, 0.3f, 1.6f})).walk =
      Walk({{-1.2, -1.2}, {1.2, -1.2}}, 1.0);
  builder.AddLight({0, 0, 2.4});
  builder.world().ambient_rgb = {0.2f, 0.2f, 0.2f};
  return builder;
}

TEST(SceneRendererTest, TheSameBytesOnOneCoreAndTwo) {
  const CameraModel camera = SmallCamera(98, 75);  // not a multiple of a block of rays
  const Rigid3d T_world_camera = LookAt({-1.8, 1.5, 1.4}, {0.3, -0.5, 0.7});
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const RenderedView one = SceneRenderer(LitRoom().Build()).Render(T_world_camera, camera, 0.7);
  cv::setNumThreads(2);
  const SceneRenderer renderer(LitRoom().Build());
  renderer.Render(T_world_camera, camera, 3.1);  // what was seen before does not matter
  const RenderedView two = renderer.Render(T_world_camera, camera, 0.7);
  cv::setNumThreads(threads);
  EXPECT_TRUE(SamePixels(one, two));
}

TEST(SceneRendererTest, SomebodyWalksThroughTheView) {
  const SceneRenderer renderer(LitRoom().Build());
  const CameraModel camera = SmallCamera();
  const Rigid3d T_world_camera = LookAt({0, 1.8, 1.2}, {0, -1.2, 0.8});
  double before_px = std::numeric_limits<double>::infinity();
  for (const double time_s : {0.2, 0.8, 1.4, 2.0}) {  // x grows: to the left in this view
    const RenderedView view = renderer.Render(T_world_camera, camera, time_s);
    const cv::Mat walker = view.instances == 4;
    ASSERT_GT(cv::countNonZero(walker), 20) << time_s;
    const cv::Moments moments = cv::moments(walker, true);
    EXPECT_LT(moments.m10 / moments.m00, before_px - 2.0);
    before_px = moments.m10 / moments.m00;
    EXPECT_EQ(cv::countNonZero((view.labels == 3) != walker), 0);
  }
}

TEST(SceneRendererTest, ItIsDarkerUnderTheTable) {
  const SceneRenderer renderer(LitRoom().Build());
  const RenderedView view =
      renderer.Render(LookAt({-1.8, 0, 0.4}, {0.8, 0, 0}), SmallCamera(), 2.4);
  const auto floor_at = [&](int v) {
    return static_cast<int>(view.colour.at<cv::Vec3b>(v, 32)[1]);
  };
  // The ray of the middle row meets the floor at x = 0.8 m, that of row 44 at x = -1.1 m.
  EXPECT_LT(floor_at(24), floor_at(44) - 25);
}

TEST(SceneRendererTest, WithoutLightAllIsBlackButHasDepth) {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  builder.AddLight({5, 0, 2.4});  // outside
  const RenderedView view =
      SceneRenderer(builder.Build()).Render(LookAt({0, 0, 1}, {1, 0, 1}), SmallCamera(), 0.0);
  EXPECT_EQ(cv::countNonZero(view.colour.reshape(1)), 0);
  EXPECT_EQ(cv::countNonZero(view.depth_m == view.depth_m), 64 * 48);
}

TEST(SceneRendererTest, AnEmptyWorldIsBlack) {
  const RenderedView view =
      SceneRenderer(std::make_shared<World>()).Render(Rigid3d::Identity(), SmallCamera(), 0.0);
  EXPECT_EQ(cv::countNonZero(view.colour.reshape(1)), 0);
  EXPECT_EQ(cv::countNonZero(view.depth_m == view.depth_m), 0);
  EXPECT_EQ(cv::countNonZero(view.labels), 0);
  EXPECT_EQ(cv::countNonZero(view.instances), 0);
}

TEST(SceneRendererTest, MeshesMayBeEmptyOrWithoutArea) {
  WorldBuilder builder;
  builder.Add(3, Mesh());
  builder.Add(4, BoxMesh({2, 0, 0}, {0, 0, 0}));
  builder.Add(9, Mesh()).walk = Walk({{0, 0}, {1, 0}}, 1.0);
  builder.AddLight({0, 0, 2});
  const RenderedView view =
      SceneRenderer(builder.Build()).Render(LookAt({0, 0, 0}, {1, 0, 0}), SmallCamera(), 1.0);
  EXPECT_EQ(cv::countNonZero(view.instances), 0);
}

TEST(SceneRendererTest, ACameraMayBeInsideOfAThing) {
  WorldBuilder builder;
  builder.Add(4, BoxMesh({0, 0, 0}, {2, 2, 2}));
  const RenderedView view =
      SceneRenderer(builder.Build()).Render(LookAt({0, 0, 0}, {1, 0, 0}), SmallCamera(), 0.0);
  EXPECT_EQ(cv::countNonZero(view.instances == 1), 64 * 48);
  EXPECT_NEAR(view.depth_m.at<float>(24, 32), 1.0f, kExactM);
}

TEST(SceneRendererTest, RefusesAPoseThatIsNotFinite) {
  const SceneRenderer renderer(std::make_shared<World>());
  Rigid3d T_world_camera = Rigid3d::Identity();
  T_world_camera.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(
      MessageOf<InputError>([&] { renderer.Render(T_world_camera, SmallCamera(), 0.0); }).empty());
  EXPECT_FALSE(MessageOf<InputError>([&] {
                 renderer.Render(Rigid3d::Identity(), SmallCamera(),
                                 std::numeric_limits<double>::infinity());
               }).empty());
}

}  // namespace
}  // namespace semantic_slam
