#pragma once

#include <memory>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// What a perfect camera sees of a world: one size, one ray through the centre of each raw pixel.
// Only colours are mixed where surfaces border on each other.
struct RenderedView {
  cv::Mat colour;     // CV_8UC3, BGR; black where there is nothing
  cv::Mat depth_m;    // CV_32FC1 along the optical axis; NaN where there is nothing
  cv::Mat labels;     // CV_8UC1, label ids; kUnknownLabel where there is nothing
  cv::Mat instances;  // CV_16UC1, WorldObject::instance; kNoInstance where there is nothing
  cv::Mat incidence;  // CV_32FC1, cosine of the angle between ray and surface normal, 0..1
};

// Looks at a world by casting rays (Embree) on all cores. The same call gives the same bytes on any
// number of cores. Render() may be called from one thread at a time.
class SceneRenderer {
 public:
  // Builds the ray casting structures, the textures and the light on all that stands still: some
  // seconds for a house. Throws ConfigError naming a material's pattern that does not exist.
  explicit SceneRenderer(std::shared_ptr<const World> world);
  ~SceneRenderer();

  const World& world() const;

  // The view of a camera at `time_s` of the world (people walk). Throws InputError if the pose or
  // the time is not finite.
  RenderedView Render(const Rigid3d& T_world_camera, const CameraModel& camera,
                      double time_s) const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace semantic_slam
