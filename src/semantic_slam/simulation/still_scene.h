#pragma once

#include <vector>

#include "semantic_slam/simulation/light_grid.h"
#include "semantic_slam/simulation/ray_scene.h"
#include "semantic_slam/simulation/scene_triangles.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// All that stands still in a world, ready to be traced, with places for the light on it, which is
// dark to begin with. Safe from any thread while nothing is changed.
class StillScene {
 public:
  explicit StillScene(const World& world);

  const RayScene& rays() const { return rays_; }
  const SceneTriangles& triangles() const { return triangles_; }
  const std::vector<LightGrid>& grids() const { return grids_; }
  int part_count() const { return part_count_; }

  // What the ray of a lane has met. `direction` is its direction. Precondition: it is a hit in
  // this scene.
  SurfacePoint PointAt(const RayPacket& packet, int lane, const Eigen::Vector3f& position_m,
                       const Eigen::Vector3f& direction) const;

  // The triangle that the ray of a lane has met. Precondition as above.
  unsigned TriangleAt(const RayPacket& packet, int lane) const;

  // Where the light must be known: of all grids, one after the other, then of all corners.
  const std::vector<LightSite>& sites() const { return sites_; }

  // By site: the part it belongs to.
  const std::vector<int>& site_parts() const { return site_parts_; }

  // Takes the light at all sites, in their order.
  void SetLight(const std::vector<LightSample>& light);

  // Takes the lamps that shine on each part.
  void SetLamps(const std::vector<LampSet>& lamps_of_parts);

  // The first of the sites of each grid, then the first of the corners, then their number.
  std::vector<std::size_t> SiteRanges() const;

 private:
  enum GeometryId : unsigned { kOpaqueGeometry = 0, kShiningGeometry = 1 };

  void AddSurfaces(const World& world, bool shining);
  void AddFlatPart(const Mesh& part, const Rigid3d& T_world_object);
  void AddCurvedPart(const Mesh& part, const Rigid3d& T_world_object);

  SceneTriangles triangles_;  // opaque ones first
  unsigned first_shining_ = 0;
  std::vector<LightGrid> grids_;
  std::vector<LightSite> sites_;
  std::vector<int> site_parts_;
  std::vector<LightSite> corner_sites_;  // these two only while this is built
  std::vector<int> corner_site_parts_;
  int part_count_ = 0;
  RayScene rays_{RayScene::Lifetime::kStill};
};

}  // namespace semantic_slam
