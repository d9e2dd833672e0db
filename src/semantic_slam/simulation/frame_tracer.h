#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/moving_scene.h"
#include "semantic_slam/simulation/scene_renderer.h"
#include "semantic_slam/simulation/shader.h"
#include "semantic_slam/simulation/still_scene.h"
#include "semantic_slam/simulation/tone_curve.h"

namespace semantic_slam {

// All that a ray may need to know of a world at one moment.
struct LitScene {
  const StillScene& still;
  const MovingScene& moving;
  const std::vector<Lamp>& lamps;
  const Shader& shader;
  const ToneCurve& tone_curve;
};

// Draws one view of a scene, on all cores: a ray through the centre of each pixel, by which all but
// the colour is decided, and where surfaces border on each other more rays, so that colours mix as
// they do on a sensor. Not thread-safe.
class FrameTracer {
 public:
  // `scene` and `camera` must live as long as this does.
  FrameTracer(const LitScene& scene, const CameraModel& camera, const Rigid3d& T_world_camera);

  // The view. To be called once.
  RenderedView Trace();

 private:
  // A place in the image and the ray through it, in the world, scaled so that its parameter is
  // depth.
  struct Aim {
    cv::Point pixel;
    Eigen::Vector3d ray;
  };
  // What a ray has met.
  struct Met {
    SurfacePoint point;
    double depth_m = 0.0;
    bool moves = false;
  };

  Aim AimAt(cv::Point pixel, float right_px, float down_px) const;
  void Cast(RayPacket& packet) const;
  void SetRay(RayPacket& packet, int lane, const Aim& aim) const;
  Met MetBy(const RayPacket& packet, int lane, const Aim& aim) const;
  cv::Vec3b ColourOf(const Met& met, const Aim& aim) const;

  void TraceBlock(cv::Point first);
  void Store(const Met& met, const Aim& aim);

  void SmoothBorders(int v);
  bool IsAtBorder(cv::Point pixel) const;
  void Supersample(const cv::Point* pixels, int count);

  const SceneTriangle*& TriangleIn(cv::Point pixel) {
    return triangles_[static_cast<std::size_t>(pixel.y) * view_.colour.cols + pixel.x];
  }
  const SceneTriangle* TriangleIn(cv::Point pixel) const {
    return triangles_[static_cast<std::size_t>(pixel.y) * view_.colour.cols + pixel.x];
  }

  const LitScene& scene_;
  const CameraModel& camera_;
  const Eigen::Vector3d origin_m_;
  const Eigen::Matrix3d R_world_camera_;
  const float pixel_rad_;  // how wide a pixel is in the middle of the image
  RenderedView view_;
  std::vector<const SceneTriangle*> triangles_;  // by pixel; null where there is nothing
};

}  // namespace semantic_slam
