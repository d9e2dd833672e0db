#pragma once

#include <vector>

#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/light_gather.h"
#include "semantic_slam/simulation/ray_scene.h"
#include "semantic_slam/simulation/scene_triangles.h"
#include "semantic_slam/simulation/still_scene.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// All that moves in a world: who walks, and what swings. Safe from any thread between calls of
// MoveTo().
class MovingScene {
 public:
  static constexpr unsigned kGeometry = 2;  // what packets call its hits

  // `first_part` is the first id for its parts.
  MovingScene(const World& world, int first_part);

  // Puts everything where it is at `time_s`, and into the light that is there.
  void MoveTo(double time_s, const std::vector<Lamp>& lamps, const StillScene& surroundings,
              const LightGatherer& gatherer);

  const RayScene& rays() const { return rays_; }
  const SceneTriangles& triangles() const { return triangles_; }

  // What the ray of a lane has met. Precondition: it is a hit in this scene.
  SurfacePoint PointAt(const RayPacket& packet, int lane, const Eigen::Vector3f& position_m,
                       const Eigen::Vector3f& direction) const;

  // Irradiance (blue, green, red) by `lamps` that a place on something still would get if nothing
  // moved, and does not. Lamps that are not in `lit_by` do not shine there anyhow.
  Eigen::Vector3f TakenLight(const std::vector<Lamp>& lamps, const StillScene& surroundings,
                             const Eigen::Vector3f& position_m, const Eigen::Vector3f& normal,
                             LampSet lit_by = kAllLamps) const;

 private:
  struct MovingSurface {
    const Surface* surface;
    std::vector<Mesh> parts;
    std::vector<int> part_ids;
  };
  struct MovingObject {
    const WorldObject* object;
    std::vector<MovingSurface> surfaces;
  };
  // Something that moves between a lamp and places that get less of its light.
  struct Shade {
    std::size_t lamp;
    Eigen::AlignedBox3f box_m;  // around all that moves, and as much more as the lamp is wide
  };

  void LightCorners(std::size_t first, const std::vector<Lamp>& lamps,
                    const StillScene& surroundings, const LightGatherer& gatherer);
  void AddShades(std::size_t first, const std::vector<Lamp>& lamps, const StillScene& surroundings);
  Eigen::AlignedBox3f BoundsFrom(std::size_t first) const;

  std::vector<MovingObject> objects_;
  SceneTriangles triangles_;
  std::vector<Shade> shades_;
  RayScene rays_{RayScene::Lifetime::kChanging};
};

}  // namespace semantic_slam
