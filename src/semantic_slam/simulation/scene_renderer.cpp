#include "semantic_slam/simulation/scene_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "semantic_slam/common/error.h"
#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/light_bake.h"
#include "semantic_slam/simulation/moving_scene.h"
#include "semantic_slam/simulation/shader.h"
#include "semantic_slam/simulation/still_scene.h"
#include "semantic_slam/simulation/tone_curve.h"

namespace semantic_slam {
namespace {

constexpr int kBlockPx = 4;  // a packet's rays go through a square of pixels
static_assert(kBlockPx * kBlockPx == kRaysPerPacket);

std::vector<Lamp> LampsOf(const World& world) {
  return {world.lights.begin(), world.lights.end()};
}

Eigen::Vector3f AmbientOf(const World& world) {
  return {world.ambient_rgb[2], world.ambient_rgb[1], world.ambient_rgb[0]};
}

RenderedView EmptyView(cv::Size size) {
  RenderedView view;
  view.colour = cv::Mat::zeros(size, CV_8UC3);
  view.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  view.labels = cv::Mat(size, CV_8UC1, cv::Scalar(kUnknownLabel));
  view.instances = cv::Mat(size, CV_16UC1, cv::Scalar(kNoInstance));
  view.incidence = cv::Mat::zeros(size, CV_32FC1);
  return view;
}

// A camera at its place. Rays are scaled so that their parameter is depth.
struct PlacedCamera {
  Eigen::Vector3d origin_m;
  Eigen::Matrix3d R_world_camera;
  const CameraModel& model;
  float pixel_rad;  // how wide a pixel is in the middle

  Eigen::Vector3d Ray(int u, int v) const {
    return R_world_camera * model.Ray(u, v).cast<double>().homogeneous();
  }
};

// Depth at which a ray meets the plane of a triangle: more exact than Embree's, which is in floats.
double DepthOf(const SceneTriangle& triangle, const PlacedCamera& camera,
               const Eigen::Vector3d& ray) {
  return (triangle.offset_m - triangle.normal.dot(camera.origin_m)) / triangle.normal.dot(ray);
}

}  // namespace

class SceneRenderer::Implementation {
 public:
  explicit Implementation(std::shared_ptr<const World> world)
      : world_(std::move(world)),
        shader_(*world_),
        lamps_(LampsOf(*world_)),
        still_(*world_),
        gatherer_(still_, shader_.reflectances(), AmbientOf(*world_)),
        moving_(*world_, still_.part_count()) {
    BakeLight(lamps_, AmbientOf(*world_), shader_.reflectances(), still_);
  }

  const World& world() const { return *world_; }

  RenderedView Render(const Rigid3d& T_world_camera, const CameraModel& model, double time_s) {
    if (!IsFinite(T_world_camera) || !std::isfinite(time_s)) {
      throw InputError("the pose or time of a simulated camera is not finite");
    }
    moving_.MoveTo(time_s, lamps_, still_, gatherer_);
    RenderedView view = EmptyView({model.width_px(), model.height_px()});
    const PlacedCamera camera{T_world_camera.translation(), T_world_camera.linear(), model,
                              static_cast<float>(1.0 / model.intrinsics().fx_px)};
    const int block_rows = (model.height_px() + kBlockPx - 1) / kBlockPx;
    cv::parallel_for_({0, block_rows}, [&](const cv::Range& range) {
      for (int row = range.start; row < range.end; ++row) {
        for (int u = 0; u < model.width_px(); u += kBlockPx) {
          RenderBlock(camera, u, row * kBlockPx, view);
        }
      }
    });
    return view;
  }

 private:
  void RenderBlock(const PlacedCamera& camera, int u, int v, RenderedView& view) const {
    const Eigen::Vector3f origin_m = camera.origin_m.cast<float>();
    std::array<Eigen::Vector3d, kRaysPerPacket> rays;
    RayPacket packet;
    packet.Clear();
    for (int i = 0; i < kRaysPerPacket; ++i) {
      const int pixel_u = u + i % kBlockPx, pixel_v = v + i / kBlockPx;
      if (pixel_u >= view.colour.cols || pixel_v >= view.colour.rows) continue;
      rays[i] = camera.Ray(pixel_u, pixel_v);
      packet.Set(i, origin_m, rays[i].cast<float>());
    }
    still_.rays().FindHits(packet, true);
    moving_.rays().FindHits(packet, true);
    for (int i = 0; i < kRaysPerPacket; ++i) {
      if (!packet.IsSet(i) || !packet.IsHit(i)) continue;
      RenderPixel(camera, packet, i, rays[i], {u + i % kBlockPx, v + i / kBlockPx}, view);
    }
  }

  void RenderPixel(const PlacedCamera& camera, const RayPacket& packet, int lane,
                   const Eigen::Vector3d& ray, cv::Point pixel, RenderedView& view) const {
    const bool moves = packet.Geometry(lane) == MovingScene::kGeometry;
    const SceneTriangle& triangle =
        moves ? moving_.triangles().triangles[packet.Triangle(lane)]
              : still_.triangles().triangles[still_.TriangleAt(packet, lane)];
    const double depth_m = DepthOf(triangle, camera, ray);
    const Eigen::Vector3f position_m = (camera.origin_m + depth_m * ray).cast<float>();
    const Eigen::Vector3f direction = ray.cast<float>();
    const SurfacePoint point = moves ? moving_.PointAt(packet, lane, position_m, direction)
                                     : still_.PointAt(packet, lane, position_m, direction);
    view.depth_m.at<float>(pixel) = static_cast<float>(depth_m);
    view.labels.at<LabelId>(pixel) = point.surface->label;
    view.instances.at<InstanceId>(pixel) = point.surface->instance;
    view.incidence.at<float>(pixel) =
        static_cast<float>(std::abs(triangle.normal.dot(ray)) / ray.norm());
    Eigen::Vector3f irradiance = point.irradiance;
    if (!moves) {
      irradiance -= moving_.TakenLight(lamps_, still_, position_m, point.normal);
      irradiance = irradiance.cwiseMax(0.0f);
    }
    const auto depth = static_cast<float>(depth_m);
    view.colour.at<cv::Vec3b>(pixel) = tone_curve_.Pixel(
        shader_.LightFrom(point, depth * direction, depth * direction.norm() * camera.pixel_rad,
                          irradiance, lamps_, still_.rays()));
  }

  const std::shared_ptr<const World> world_;
  const Shader shader_;
  const ToneCurve tone_curve_;
  const std::vector<Lamp> lamps_;
  StillScene still_;
  const LightGatherer gatherer_;
  MovingScene moving_;
};

SceneRenderer::SceneRenderer(std::shared_ptr<const World> world)
    : implementation_(std::make_unique<Implementation>(std::move(world))) {}

SceneRenderer::~SceneRenderer() = default;

const World& SceneRenderer::world() const {
  return implementation_->world();
}

RenderedView SceneRenderer::Render(const Rigid3d& T_world_camera, const CameraModel& camera,
                                   double time_s) const {
  return implementation_->Render(T_world_camera, camera, time_s);
}

}  // namespace semantic_slam
