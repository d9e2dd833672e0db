#include "semantic_slam/simulation/frame_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

constexpr int kBlockPx = 4;  // a packet's rays go through a square of pixels
static_assert(kBlockPx * kBlockPx == kRaysPerPacket);

// Where more rays go through a pixel at a border: evenly around its centre, right and down [px].
constexpr int kMoreRays = 3;
constexpr std::array<std::array<float, 2>, kMoreRays> kOffsetsPx{
    {{0.34f, 0.12f}, {-0.28f, 0.24f}, {-0.06f, -0.36f}}};
constexpr int kPixelsPerPacket = kRaysPerPacket / kMoreRays;

RenderedView EmptyView(cv::Size size) {
  RenderedView view;
  view.colour = cv::Mat::zeros(size, CV_8UC3);
  view.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  view.labels = cv::Mat(size, CV_8UC1, cv::Scalar(kUnknownLabel));
  view.instances = cv::Mat(size, CV_16UC1, cv::Scalar(kNoInstance));
  view.incidence = cv::Mat::zeros(size, CV_32FC1);
  return view;
}

bool AreInOnePlane(const SceneTriangle& a, const SceneTriangle& b) {
  return std::abs(a.offset_m - b.offset_m) < 1e-4 && a.normal.dot(b.normal) > 1.0 - 1e-8;
}

}  // namespace

FrameTracer::FrameTracer(const LitScene& scene, const CameraModel& camera,
                         const Rigid3d& T_world_camera)
    : scene_(scene),
      camera_(camera),
      origin_m_(T_world_camera.translation()),
      R_world_camera_(T_world_camera.linear()),
      pixel_rad_(static_cast<float>(1.0 / camera.intrinsics().fx_px)),
      view_(EmptyView({camera.width_px(), camera.height_px()})),
      triangles_(view_.colour.total(), nullptr) {}

RenderedView FrameTracer::Trace() {
  const int block_rows = (camera_.height_px() + kBlockPx - 1) / kBlockPx;
  cv::parallel_for_({0, block_rows}, [&](const cv::Range& range) {
    for (int row = range.start; row < range.end; ++row) {
      for (int u = 0; u < camera_.width_px(); u += kBlockPx) TraceBlock({u, row * kBlockPx});
    }
  });
  cv::parallel_for_({0, camera_.height_px()}, [&](const cv::Range& range) {
    for (int v = range.start; v < range.end; ++v) SmoothBorders(v);
  });
  return std::move(view_);
}

FrameTracer::Aim FrameTracer::AimAt(cv::Point pixel, float right_px, float down_px) const {
  Eigen::Vector2f through = camera_.Ray(pixel.x, pixel.y);
  if (right_px != 0.0f || down_px != 0.0f) {
    const int u = std::min(pixel.x, camera_.width_px() - 2);
    const int v = std::min(pixel.y, camera_.height_px() - 2);
    if (u >= 0) through += right_px * (camera_.Ray(u + 1, pixel.y) - camera_.Ray(u, pixel.y));
    if (v >= 0) through += down_px * (camera_.Ray(pixel.x, v + 1) - camera_.Ray(pixel.x, v));
  }
  return {pixel, R_world_camera_ * through.cast<double>().homogeneous()};
}

void FrameTracer::SetRay(RayPacket& packet, int lane, const Aim& aim) const {
  packet.Set(lane, origin_m_.cast<float>(), aim.ray.cast<float>());
}

void FrameTracer::Cast(RayPacket& packet) const {
  scene_.still.rays().FindHits(packet, true);
  scene_.moving.rays().FindHits(packet, true);
}

FrameTracer::Met FrameTracer::MetBy(const RayPacket& packet, int lane, const Aim& aim) const {
  Met met;
  met.moves = packet.Geometry(lane) == MovingScene::kGeometry;
  const SceneTriangle& triangle =
      met.moves ? scene_.moving.triangles().triangles[packet.Triangle(lane)]
                : scene_.still.triangles().triangles[scene_.still.TriangleAt(packet, lane)];
  // More exact than Embree's, which is in floats.
  met.depth_m = (triangle.offset_m - triangle.normal.dot(origin_m_)) / triangle.normal.dot(aim.ray);
  const Eigen::Vector3f position_m = (origin_m_ + met.depth_m * aim.ray).cast<float>();
  const Eigen::Vector3f direction = aim.ray.cast<float>();
  met.point = met.moves ? scene_.moving.PointAt(packet, lane, position_m, direction)
                        : scene_.still.PointAt(packet, lane, position_m, direction);
  return met;
}

cv::Vec3b FrameTracer::ColourOf(const Met& met, const Aim& aim) const {
  Eigen::Vector3f irradiance = met.point.irradiance;
  if (!met.moves) {
    irradiance -= scene_.moving.TakenLight(scene_.lamps, scene_.still, met.point.position_m,
                                           met.point.normal, met.point.triangle->lamps);
    irradiance = irradiance.cwiseMax(0.0f);
  }
  const Eigen::Vector3f to_point = static_cast<float>(met.depth_m) * aim.ray.cast<float>();
  return scene_.tone_curve.Pixel(scene_.shader.LightFrom(met.point, to_point,
                                                         to_point.norm() * pixel_rad_, irradiance,
                                                         scene_.lamps, scene_.still.rays()));
}

void FrameTracer::TraceBlock(cv::Point first) {
  std::array<Aim, kRaysPerPacket> aims;
  RayPacket packet;
  packet.Clear();
  for (int i = 0; i < kRaysPerPacket; ++i) {
    const cv::Point pixel = first + cv::Point(i % kBlockPx, i / kBlockPx);
    if (pixel.x >= camera_.width_px() || pixel.y >= camera_.height_px()) continue;
    aims[i] = AimAt(pixel, 0.0f, 0.0f);
    SetRay(packet, i, aims[i]);
  }
  Cast(packet);
  for (int i = 0; i < kRaysPerPacket; ++i) {
    if (packet.IsSet(i) && packet.IsHit(i)) Store(MetBy(packet, i, aims[i]), aims[i]);
  }
}

void FrameTracer::Store(const Met& met, const Aim& aim) {
  const SceneTriangle& triangle = *met.point.triangle;
  TriangleIn(aim.pixel) = &triangle;
  view_.colour.at<cv::Vec3b>(aim.pixel) = ColourOf(met, aim);
  view_.depth_m.at<float>(aim.pixel) = static_cast<float>(met.depth_m);
  view_.labels.at<LabelId>(aim.pixel) = met.point.surface->label;
  view_.instances.at<InstanceId>(aim.pixel) = met.point.surface->instance;
  view_.incidence.at<float>(aim.pixel) =
      static_cast<float>(std::abs(triangle.normal.dot(aim.ray)) / aim.ray.norm());
}

void FrameTracer::SmoothBorders(int v) {
  std::array<cv::Point, kPixelsPerPacket> pixels;
  int count = 0;
  for (int u = 0; u < camera_.width_px(); ++u) {
    if (!IsAtBorder({u, v})) continue;
    pixels[count++] = {u, v};
    if (count == kPixelsPerPacket) {
      Supersample(pixels.data(), count);
      count = 0;
    }
  }
  if (count > 0) Supersample(pixels.data(), count);
}

// Whether another surface, or one with another direction, is seen right beside the pixel.
bool FrameTracer::IsAtBorder(cv::Point pixel) const {
  const SceneTriangle* const here = TriangleIn(pixel);
  const auto borders_on = [&](cv::Point other) {
    const SceneTriangle* const there = TriangleIn(other);
    if (here == nullptr || there == nullptr) return here != there;
    return here->part != there->part && !AreInOnePlane(*here, *there);
  };
  const int u = pixel.x, v = pixel.y;
  return (u > 0 && borders_on({u - 1, v})) || (v > 0 && borders_on({u, v - 1})) ||
         (u + 1 < camera_.width_px() && borders_on({u + 1, v})) ||
         (v + 1 < camera_.height_px() && borders_on({u, v + 1}));
}

void FrameTracer::Supersample(const cv::Point* pixels, int count) {
  std::array<Aim, kPixelsPerPacket * kMoreRays> aims;
  RayPacket packet;
  packet.Clear();
  for (int i = 0; i < count * kMoreRays; ++i) {
    const auto& [right_px, down_px] = kOffsetsPx[i % kMoreRays];
    aims[i] = AimAt(pixels[i / kMoreRays], right_px, down_px);
    SetRay(packet, i, aims[i]);
  }
  Cast(packet);
  for (int i = 0; i < count; ++i) {
    cv::Vec3b& colour = view_.colour.at<cv::Vec3b>(pixels[i]);
    cv::Vec3f light = cv::Vec3f(colour).mul(colour);  // what counts is not its root
    for (int lane = i * kMoreRays; lane < (i + 1) * kMoreRays; ++lane) {
      if (!packet.IsHit(lane)) continue;
      const cv::Vec3f more = ColourOf(MetBy(packet, lane, aims[lane]), aims[lane]);
      light += more.mul(more);
    }
    for (int c = 0; c < 3; ++c) {
      colour[c] = cv::saturate_cast<std::uint8_t>(std::sqrt(light[c] / (kMoreRays + 1)));
    }
  }
}

}  // namespace semantic_slam
