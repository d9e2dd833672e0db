#include "semantic_slam/simulation/still_scene.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "semantic_slam/simulation/mesh_parts.h"

namespace semantic_slam {
namespace {

constexpr float kGridSpacingM = 0.08f;    // of light on flat surfaces
constexpr float kCornerSpacingM = 0.12f;  // on others
constexpr float kInsetM = 0.005f;         // light at the rim of a surface is that a little inside

Mesh InWorld(const Mesh& part, const Rigid3d& T_world_object) {
  Mesh moved;
  Append(moved, part, T_world_object);
  return moved;
}

// Where to look for the light on a corner: there, but a little towards the middle of the part.
LightSite SiteOf(const Mesh& part, std::size_t corner, const Eigen::Vector3f& middle_m) {
  const Eigen::Vector3f& normal = part.normals[corner];
  Eigen::Vector3f inwards = middle_m - part.positions_m[corner];
  inwards -= normal.dot(inwards) * normal;
  const float reach_m = std::min(kInsetM, 0.5f * inwards.norm());
  return {part.positions_m[corner] + reach_m * inwards.stableNormalized(), normal};
}

}  // namespace

StillScene::StillScene(const World& world) {
  AddSurfaces(world, false);
  first_shining_ = static_cast<unsigned>(triangles_.triangles.size());
  AddSurfaces(world, true);
  sites_.insert(sites_.end(), corner_sites_.begin(), corner_sites_.end());
  site_parts_.insert(site_parts_.end(), corner_site_parts_.begin(), corner_site_parts_.end());
  corner_sites_ = {};
  corner_site_parts_ = {};
  const std::vector<Eigen::Vector3f> positions_m = triangles_.Positions();
  const std::vector<Eigen::Vector3i> corners = triangles_.Corners();
  const auto first_shining = corners.begin() + first_shining_;
  rays_.SetTriangles(kOpaqueGeometry, positions_m, {corners.begin(), first_shining}, kOpaque);
  rays_.SetTriangles(kShiningGeometry, positions_m, {first_shining, corners.end()}, kShining);
  rays_.Commit();
}

void StillScene::AddSurfaces(const World& world, bool shining) {
  for (const WorldObject& object : world.objects) {
    for (const Surface& surface : object.surfaces) {
      const bool shines = world.materials[surface.material].brightness > 0.0f;
      if (shines != shining || Moves(object, surface)) continue;
      triangles_.AddSurface(object, surface);
      for (const Mesh& part : ConnectedParts(surface.mesh)) {
        if (IsFlat(part)) {
          AddFlatPart(part, object.T_world_object);
        } else {
          AddCurvedPart(Refined(part, kCornerSpacingM), object.T_world_object);
        }
      }
    }
  }
}

void StillScene::AddFlatPart(const Mesh& part, const Rigid3d& T_world_object) {
  const Mesh in_world = InWorld(part, T_world_object);
  grids_.emplace_back(in_world, kGridSpacingM);
  const std::vector<LightSite> sites = grids_.back().Sites(in_world);
  sites_.insert(sites_.end(), sites.begin(), sites.end());
  site_parts_.resize(sites_.size(), part_count_);
  corner_sites_.resize(corner_sites_.size() + part.positions_m.size(),
                       {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()});
  corner_site_parts_.resize(corner_sites_.size(), part_count_);
  triangles_.AddPart(part, T_world_object, part_count_++, static_cast<int>(grids_.size()) - 1);
}

void StillScene::AddCurvedPart(const Mesh& part, const Rigid3d& T_world_object) {
  const Mesh in_world = InWorld(part, T_world_object);
  Eigen::Vector3f middle_m = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : in_world.positions_m) middle_m += p;
  middle_m /= static_cast<float>(in_world.positions_m.size());
  for (std::size_t i = 0; i < in_world.positions_m.size(); ++i) {
    corner_sites_.push_back(SiteOf(in_world, i, middle_m));
  }
  corner_site_parts_.resize(corner_sites_.size(), part_count_);
  triangles_.AddPart(part, T_world_object, part_count_++, kNoGrid);
}

unsigned StillScene::TriangleAt(const RayPacket& packet, int lane) const {
  return packet.Triangle(lane) + (packet.Geometry(lane) == kShiningGeometry ? first_shining_ : 0);
}

SurfacePoint StillScene::PointAt(const RayPacket& packet, int lane,
                                 const Eigen::Vector3f& position_m,
                                 const Eigen::Vector3f& direction) const {
  return PointOn(triangles_, grids_, TriangleAt(packet, lane), packet.Barycentric(lane), position_m,
                 direction);
}

void StillScene::SetLight(const std::vector<LightSample>& light) {
  auto next = light.begin();
  for (LightGrid& grid : grids_) {
    std::copy_n(next, grid.samples().size(), grid.samples().begin());
    next += static_cast<std::ptrdiff_t>(grid.samples().size());
  }
  std::copy(next, light.end(), triangles_.corner_light.begin());
}

void StillScene::SetLamps(const std::vector<LampSet>& lamps_of_parts) {
  for (SceneTriangle& triangle : triangles_.triangles) {
    triangle.lamps = lamps_of_parts[triangle.part];
  }
}

std::vector<std::size_t> StillScene::SiteRanges() const {
  std::vector<std::size_t> ranges{0};
  for (const LightGrid& grid : grids_) ranges.push_back(ranges.back() + grid.samples().size());
  ranges.push_back(ranges.back() + triangles_.corners.size());
  return ranges;
}

}  // namespace semantic_slam
