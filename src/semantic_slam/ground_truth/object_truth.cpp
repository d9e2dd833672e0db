#include "semantic_slam/ground_truth/object_truth.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "semantic_slam/ground_truth/column_crossings.h"
#include "semantic_slam/plane_projection/convex_polygon.h"

namespace semantic_slam {
namespace {

constexpr double kHairM = 0.0005;     // a sheet on a wall gets this much to its front and back
constexpr double kLevelM = 0.02;      // surfaces of about one height are one
constexpr double kLevelCosine = 0.9;  // of a surface's normal with "up", for it to be level

std::vector<Eigen::Vector3d> Corners(const WorldObject& object) {
  std::vector<Eigen::Vector3d> corners;
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
      corners.push_back(object.T_world_object * p.cast<double>());
    }
  }
  return corners;
}

ConvexPolygon Outline(const std::vector<Eigen::Vector3d>& corners) {
  std::vector<Eigen::Vector2d> seen_from_above;
  for (const Eigen::Vector3d& p : corners) {
    for (const double dx : {-kHairM, kHairM}) {
      for (const double dy : {-kHairM, kHairM}) {
        seen_from_above.push_back(p.head<2>() + Eigen::Vector2d(dx, dy));
      }
    }
  }
  // The hair's own corners are none of the object's.
  return Simplified(ConvexHull(std::move(seen_from_above)), 2.0 * kHairM);
}

// Calls visit(a, b, c) with the corners of every triangle, in the world.
template <typename Visit>
void ForEachTriangle(const WorldObject& object, Visit&& visit) {
  for (const Surface& surface : object.surfaces) {
    const auto corner = [&](int i) {
      return Eigen::Vector3d(object.T_world_object * surface.mesh.positions_m[i].cast<double>());
    };
    for (const Eigen::Vector3i& t : surface.mesh.triangles) {
      visit(corner(t[0]), corner(t[1]), corner(t[2]));
    }
  }
}

// The height [m] of the largest level surface that looks up, of equally large ones the highest.
std::optional<double> TopHeight(const WorldObject& object) {
  std::map<long, double> area_by_level;
  ForEachTriangle(
      object, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
        const Eigen::Vector3d normal = (b - a).cross(c - a);
        if (normal.z() <= kLevelCosine * normal.norm()) return;
        area_by_level[std::lround((a + b + c).z() / 3.0 / kLevelM)] += 0.5 * normal.norm();
      });
  std::optional<double> top_m;
  double largest = 0.0;
  for (const auto& [level, area] : area_by_level) {
    if (area < largest * (1.0 - 1e-6)) continue;  // equal but for rounding
    largest = std::max(largest, area);
    top_m = static_cast<double>(level) * kLevelM;
  }
  return top_m;
}

// Which columns of the outline nothing of the object is in, from `floor_m` up to its top.
SpaceBelow TrueSpaceBelow(const WorldObject& object, const ConvexPolygon& outline, double top_m,
                          const HollownessOptions& options) {
  const CellLattice lattice{options.column_m, {0.0, 0.0}};
  std::set<std::pair<int, int>> occupied;
  for (const Surface& surface : object.surfaces) {
    for (const Crossing& crossing : CrossColumns(surface.mesh, object.T_world_object, lattice)) {
      if (crossing.z_m < top_m - options.clearance_m) {
        occupied.insert({crossing.cell.x, crossing.cell.y});
      }
    }
  }
  const auto cell = [&](double coordinate_m) {
    return static_cast<int>(std::floor(coordinate_m / options.column_m));
  };
  SpaceBelow below;
  for (int y = cell(-Support(outline, {0, -1})); y <= cell(Support(outline, {0, 1})); ++y) {
    for (int x = cell(-Support(outline, {-1, 0})); x <= cell(Support(outline, {1, 0})); ++x) {
      if (!Contains(outline, options.column_m * Eigen::Vector2d(x + 0.5, y + 0.5))) continue;
      ++(occupied.count({x, y}) > 0 ? below.occupied_columns : below.free_columns);
    }
  }
  return below;
}

Hollowness TrueHollowness(const WorldObject& object, const MapObject& shape, bool class_is_hollow) {
  const HollownessOptions options;
  const std::optional<double> top_m = TopHeight(object);
  if (!top_m || *top_m - shape.min_height_m < options.min_room_m) return Hollowness::kNo;
  return JudgeHollowness(TrueSpaceBelow(object, shape.footprint_m, *top_m, options),
                         class_is_hollow, options);
}

}  // namespace

MapObject TrueObject(const WorldObject& object, const LabelVocabulary& vocabulary) {
  MapObject truth;
  truth.id = object.instance;
  truth.labels = {{object.label, 1.0f}};
  const std::vector<Eigen::Vector3d> corners = Corners(object);
  truth.min_height_m = std::numeric_limits<double>::infinity();
  truth.max_height_m = -truth.min_height_m;
  for (const Eigen::Vector3d& p : corners) {
    truth.min_height_m = std::min(truth.min_height_m, p.z());
    truth.max_height_m = std::max(truth.max_height_m, p.z());
  }
  truth.footprint_m = Outline(corners);
  const Rectangle box = MinimumAreaRectangle(truth.footprint_m);
  truth.position_m << box.centre, 0.5 * (truth.min_height_m + truth.max_height_m);
  truth.position_covariance_m2.setZero();
  truth.T_map_box = Eigen::Translation3d(truth.position_m) *
                    Eigen::AngleAxisd(box.yaw_rad, Eigen::Vector3d::UnitZ());
  truth.box_size_m << box.size, truth.max_height_m - truth.min_height_m;
  truth.hollow = TrueHollowness(object, truth, vocabulary[object.label].hollow);
  return truth;
}

ObjectMap TrueObjects(const World& world, const LabelVocabulary& vocabulary) {
  ObjectMap map;
  map.vocabulary_hash = vocabulary.hash();
  for (const WorldObject& object : world.objects) {
    if (object.is_structure || object.IsMoving() || Corners(object).empty()) continue;
    map.objects.push_back(TrueObject(object, vocabulary));
  }
  return map;
}

}  // namespace semantic_slam
