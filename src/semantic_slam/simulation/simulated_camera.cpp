#include "semantic_slam/simulation/simulated_camera.h"

#include <utility>

#include "semantic_slam/common/option_groups.h"

namespace semantic_slam {

SimulatedCamera::SimulatedCamera(std::shared_ptr<const SceneRenderer> renderer,
                                 const CameraIntrinsics& intrinsics,
                                 const SimulatedCameraOptions& options)
    : renderer_(std::move(renderer)),
      model_(intrinsics),
      depth_noise_(ValidatedGroups(options).depth_noise, intrinsics.fx_px),
      colour_noise_(options.colour_noise) {}

SimulatedImage SimulatedCamera::Capture(const Rigid3d& T_world_camera, Stamp stamp,
                                        double time_s) const {
  SimulatedImage image;
  image.truth = renderer_->Render(T_world_camera, model_, time_s);
  image.measured.stamp = image.measured.depth_stamp = stamp;
  image.measured.colour = colour_noise_.Apply(image.truth.colour, stamp);
  image.measured.depth_m = depth_noise_.Apply(image.truth.depth_m, image.truth.incidence, stamp);
  return image;
}

}  // namespace semantic_slam
