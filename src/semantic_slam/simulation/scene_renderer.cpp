#include "semantic_slam/simulation/scene_renderer.h"

#include <cmath>
#include <utility>
#include <vector>

#include "semantic_slam/common/error.h"
#include "semantic_slam/simulation/frame_tracer.h"
#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/light_bake.h"
#include "semantic_slam/simulation/moving_scene.h"
#include "semantic_slam/simulation/shader.h"
#include "semantic_slam/simulation/still_scene.h"
#include "semantic_slam/simulation/tone_curve.h"

namespace semantic_slam {
namespace {

std::vector<Lamp> LampsOf(const World& world) {
  return {world.lights.begin(), world.lights.end()};
}

Eigen::Vector3f AmbientOf(const World& world) {
  return {world.ambient_rgb[2], world.ambient_rgb[1], world.ambient_rgb[0]};
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
    const LitScene scene{still_, moving_, lamps_, shader_, tone_curve_};
    return FrameTracer(scene, model, T_world_camera).Trace();
  }

 private:
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
