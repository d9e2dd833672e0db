#include "semantic_slam/simulation/moving_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/simulation/mesh_parts.h"

namespace semantic_slam {
namespace {

constexpr float kCornerSpacingM = 0.15f;  // of corners, where light is known
constexpr float kShadeReachM = 6.0f;      // lamps farther from what moves throw no shadow of it
constexpr float kLiftM = 0.002f;          // shadow rays start that far above the surface
constexpr float kFaintShade = 0.005f;     // light that would not be missed
constexpr std::uint64_t kGatherSeed = 1;

Rigid3d SwungPose(const Swing& swing, double time_s) {
  const double angle_rad =
      swing.amplitude_rad * std::sin(2.0 * M_PI * time_s / swing.period_s + swing.phase_rad);
  Rigid3d T = Rigid3d::Identity();
  T.linear() = Eigen::AngleAxisd(angle_rad, swing.axis.normalized()).toRotationMatrix();
  T.translation() = swing.pivot_m - T.linear() * swing.pivot_m;
  return T;
}

// Indirect light from six sides, as it comes to a place in the air.
class LightFromAround {
 public:
  LightFromAround(const LightGatherer& gatherer, const Eigen::Vector3f& position_m) {
    for (int side = 0; side < 6; ++side) {
      const Eigen::Vector3f normal =
          (side % 2 == 0 ? 1.0f : -1.0f) * Eigen::Vector3f::Unit(side / 2);
      light_[side] = gatherer.Gather(position_m, normal, kGatherSeed).irradiance;
    }
  }

  Eigen::Vector3f On(const Eigen::Vector3f& normal) const {
    Eigen::Vector3f light = Eigen::Vector3f::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      light += normal[axis] * normal[axis] * light_[2 * axis + (normal[axis] < 0.0f ? 1 : 0)];
    }
    return light;
  }

 private:
  std::array<Eigen::Vector3f, 6> light_;
};

// Whether a ray passes through a box before t = 1.
bool Meets(const Eigen::AlignedBox3f& box_m, const Eigen::Vector3f& origin_m,
           const Eigen::Vector3f& direction) {
  const Eigen::Array3f inverse = direction.array().inverse();
  const Eigen::Array3f a = (box_m.min() - origin_m).array() * inverse;
  const Eigen::Array3f b = (box_m.max() - origin_m).array() * inverse;
  return a.min(b).maxCoeff() <= std::min(a.max(b).minCoeff(), 1.0f) && a.max(b).minCoeff() >= 0.0f;
}

// Whether a lamp is in sight from the middle or a corner of a box.
bool IsInLightOf(const Lamp& lamp, const RayScene& scene, const Eigen::AlignedBox3f& box_m) {
  if (VisibleShare(lamp, scene, box_m.center()) > 0.0f) return true;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3f::CornerType>(i);
    if (VisibleShare(lamp, scene, box_m.corner(corner)) > 0.0f) return true;
  }
  return false;
}

}  // namespace

MovingScene::MovingScene(const World& world, int first_part) {
  int part_id = first_part;
  for (const WorldObject& object : world.objects) {
    MovingObject moving{&object, {}};
    for (const Surface& surface : object.surfaces) {
      if (!Moves(object, surface)) continue;
      moving.surfaces.push_back({&surface, {}, {}});
      for (const Mesh& part : ConnectedParts(surface.mesh)) {
        moving.surfaces.back().parts.push_back(Refined(part, kCornerSpacingM));
        moving.surfaces.back().part_ids.push_back(part_id++);
      }
    }
    if (!moving.surfaces.empty()) objects_.push_back(std::move(moving));
  }
}

void MovingScene::MoveTo(double time_s, const std::vector<Lamp>& lamps,
                         const StillScene& surroundings, const LightGatherer& gatherer) {
  triangles_ = {};
  shades_.clear();
  for (const MovingObject& moving : objects_) {
    const std::size_t first = triangles_.corners.size();
    const Rigid3d T_world_object = moving.object->Pose(time_s);
    for (const MovingSurface& surface : moving.surfaces) {
      triangles_.AddSurface(*moving.object, *surface.surface);
      const auto& swing = surface.surface->swing;
      const Rigid3d T_world_surface =
          swing ? T_world_object * SwungPose(*swing, time_s) : T_world_object;
      for (std::size_t i = 0; i < surface.parts.size(); ++i) {
        triangles_.AddPart(surface.parts[i], T_world_surface, surface.part_ids[i], kNoGrid);
      }
    }
    if (triangles_.corners.size() == first) continue;
    LightCorners(first, lamps, surroundings, gatherer);
    AddShades(first, lamps, surroundings);
  }
  rays_.SetTriangles(kGeometry, triangles_.Positions(), triangles_.Corners(), kOpaque);
  rays_.Commit();
}

Eigen::AlignedBox3f MovingScene::BoundsFrom(std::size_t first) const {
  Eigen::AlignedBox3f bounds_m;
  for (std::size_t i = first; i < triangles_.corners.size(); ++i) {
    bounds_m.extend(triangles_.corners[i].position_m);
  }
  return bounds_m;
}

// What is in the way of the lamps is looked at once for all of an object, from its middle.
void MovingScene::LightCorners(std::size_t first, const std::vector<Lamp>& lamps,
                               const StillScene& surroundings, const LightGatherer& gatherer) {
  const Eigen::Vector3f middle_m = BoundsFrom(first).center();
  const LightFromAround around(gatherer, middle_m);
  for (std::size_t i = first; i < triangles_.corners.size(); ++i) {
    triangles_.corner_light[i] = around.On(triangles_.corners[i].normal).homogeneous();
  }
  LampSet lit_by = 0;
  for (std::size_t lamp_index = 0; lamp_index < lamps.size(); ++lamp_index) {
    const Lamp& lamp = lamps[lamp_index];
    const float share = VisibleShare(lamp, surroundings.rays(), middle_m);
    if (share <= 0.0f) continue;
    lit_by |= OnlyLamp(lamp_index);
    for (std::size_t i = first; i < triangles_.corners.size(); ++i) {
      const SceneCorner& corner = triangles_.corners[i];
      triangles_.corner_light[i].head<3>() +=
          share * lamp.Strength(corner.position_m, corner.normal) * lamp.radiant();
    }
  }
  for (SceneTriangle& triangle : triangles_.triangles) {
    if (triangle.corners[0] >= static_cast<int>(first)) triangle.lamps = lit_by;
  }
}

void MovingScene::AddShades(std::size_t first, const std::vector<Lamp>& lamps,
                            const StillScene& surroundings) {
  const Eigen::AlignedBox3f bounds_m = BoundsFrom(first);
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    if (bounds_m.exteriorDistance(lamps[i].centre_m()) > kShadeReachM) continue;
    if (!IsInLightOf(lamps[i], surroundings.rays(), bounds_m)) continue;
    const Eigen::Vector3f margin_m = Eigen::Vector3f::Constant(0.5f * lamps[i].side_m());
    shades_.push_back({i, {bounds_m.min() - margin_m, bounds_m.max() + margin_m}});
  }
}

SurfacePoint MovingScene::PointAt(const RayPacket& packet, int lane,
                                  const Eigen::Vector3f& position_m,
                                  const Eigen::Vector3f& direction) const {
  return PointOn(triangles_, {}, packet.Triangle(lane), packet.Barycentric(lane), position_m,
                 direction);
}

Eigen::Vector3f MovingScene::TakenLight(const std::vector<Lamp>& lamps,
                                        const StillScene& surroundings,
                                        const Eigen::Vector3f& position_m,
                                        const Eigen::Vector3f& normal, LampSet lit_by) const {
  Eigen::Vector3f taken = Eigen::Vector3f::Zero();
  const Eigen::Vector3f start_m = position_m + kLiftM * normal;
  for (const Shade& shade : shades_) {
    const Lamp& lamp = lamps[shade.lamp];
    if ((lit_by & OnlyLamp(shade.lamp)) == 0) continue;
    if (lamp.Strength(start_m, normal) * lamp.radiant().maxCoeff() < kFaintShade) continue;
    if (!Meets(shade.box_m, start_m, lamp.centre_m() - start_m)) continue;
    RayPacket packet;
    const std::array<float, kRaysPerPacket> strengths = lamp.Aim(start_m, normal, packet);
    rays_.FindOccluded(packet);
    RayPacket beyond;  // whether the lamp would be seen there otherwise
    lamp.Aim(start_m, normal, beyond);
    bool any = false;
    for (int i = 0; i < kRaysPerPacket; ++i) {
      any |= packet.IsOccluded(i);
      if (!packet.IsOccluded(i)) beyond.Unset(i);
    }
    if (!any) continue;
    surroundings.rays().FindOccluded(beyond);
    for (int i = 0; i < kRaysPerPacket; ++i) {
      if (beyond.IsSet(i) && !beyond.IsOccluded(i)) taken += strengths[i] * lamp.radiant();
    }
  }
  return taken;
}

}  // namespace semantic_slam
