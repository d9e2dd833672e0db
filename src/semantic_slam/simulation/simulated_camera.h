#pragma once

#include <memory>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/simulation/colour_noise.h"
#include "semantic_slam/simulation/depth_noise.h"
#include "semantic_slam/simulation/scene_renderer.h"

namespace semantic_slam {

struct SimulatedCameraOptions {
  DepthNoiseOptions depth_noise;
  ColourNoiseOptions colour_noise;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("depth_noise", self.depth_noise);
    visit("colour_noise", self.colour_noise);
  }
};

// One moment before a simulated camera.
struct SimulatedImage {
  RgbdImage measured;  // what the camera delivers
  RenderedView truth;  // what is there
};

// A colour and depth camera in a simulated world. Capture() may be called from one thread at a
// time.
class SimulatedCamera {
 public:
  // Throws ConfigError if the intrinsics are not usable or an option is out of range.
  SimulatedCamera(std::shared_ptr<const SceneRenderer> renderer, const CameraIntrinsics& intrinsics,
                  const SimulatedCameraOptions& options = {});

  const CameraModel& model() const { return model_; }
  const SceneRenderer& renderer() const { return *renderer_; }

  // `time_s` is the world's, `stamp` what the images carry. The same arguments and seeds give the
  // same bytes on any number of cores. Throws InputError if the pose or time is not finite.
  SimulatedImage Capture(const Rigid3d& T_world_camera, Stamp stamp, double time_s) const;

 private:
  const std::shared_ptr<const SceneRenderer> renderer_;
  const CameraModel model_;
  const DepthNoise depth_noise_;
  const ColourNoise colour_noise_;
};

}  // namespace semantic_slam
