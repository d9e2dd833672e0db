#include "semantic_slam/worlds/opening_pieces.h"

#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {
namespace {

constexpr double kCasingM = 0.05;       // how far a door's casing covers the wall around it
constexpr double kCasingDepthM = 0.03;  // thickness of its boards on both sides together
constexpr double kRebateM = 0.02;       // a window's frame lies that far inside the outer face

// From the middle of the wall to the face that is away from the site's room.
double HalfBehind(const Building& building, const WallOpening& hole, const WallSite& site) {
  if (building.SitesOf(hole).size() > 1) return 0.5 * building.wall_thickness_m();
  return building.HalfThickness(*site.room, site.side) - 0.5 * building.wall_thickness_m();
}

}  // namespace

FittedPiece FitDoor(const Building& building, const WallOpening& hole, const WallSite& site) {
  const double front_m = 0.5 * building.wall_thickness_m();
  const double behind_m = HalfBehind(building, hole, site);
  const Eigen::Vector3d size_m(front_m + behind_m + kCasingDepthM, hole.width_m + 2 * kCasingM,
                               hole.top_m - hole.bottom_m + kCasingM);
  return {building.OpeningPose(hole, site) * Eigen::Translation3d(0.5 * (front_m - behind_m), 0, 0),
          size_m.cast<float>()};
}

FittedPiece FitWindow(const Building& building, const WallOpening& hole, const WallSite& site) {
  Eigen::Vector3f size_m = FindFurnitureKind("window").size_m;
  size_m.y() = static_cast<float>(hole.width_m);
  size_m.z() = static_cast<float>(hole.top_m - hole.bottom_m);
  const double behind_m = HalfBehind(building, hole, site);
  return {building.OpeningPose(hole, site) *
              Eigen::Translation3d(kRebateM + 0.5 * size_m.x() - behind_m, 0, 0),
          size_m};
}

}  // namespace semantic_slam
