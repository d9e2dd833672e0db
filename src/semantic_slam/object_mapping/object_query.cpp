#include "semantic_slam/object_mapping/object_query.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace semantic_slam {
namespace {

// Whether the projections of both boxes on an axis of the floor plan meet.
bool MeetAlong(const Eigen::Vector2d& axis, const MapObject& object,
               const Eigen::AlignedBox3d& box) {
  const Eigen::Vector2d half = 0.5 * object.box_size_m.head<2>();
  const Eigen::Matrix2d axes = object.T_map_box.linear().topLeftCorner<2, 2>();
  const double reach = half.dot((axes.transpose() * axis).cwiseAbs()) +
                       0.5 * box.sizes().head<2>().dot(axis.cwiseAbs());
  const Eigen::Vector2d between = (object.T_map_box.translation() - box.center()).head<2>();
  return std::abs(axis.dot(between)) <= reach;
}

// Separating axes (Gottschalk et al., SIGGRAPH 1996): upright boxes need the sides of both only.
bool Meet(const MapObject& object, const Eigen::AlignedBox3d& box) {
  if (object.min_height_m > box.max().z() || object.max_height_m < box.min().z()) return false;
  const Eigen::Vector2d x = object.T_map_box.linear().col(0).head<2>();
  const Eigen::Vector2d y = object.T_map_box.linear().col(1).head<2>();
  return MeetAlong({1.0, 0.0}, object, box) && MeetAlong({0.0, 1.0}, object, box) &&
         MeetAlong(x, object, box) && MeetAlong(y, object, box);
}

}  // namespace

std::vector<MapObject> FindObjects(const ObjectMap& map, std::optional<LabelId> label,
                                   const std::optional<Eigen::AlignedBox3d>& box_m) {
  std::vector<MapObject> found;
  std::copy_if(map.objects.begin(), map.objects.end(), std::back_inserter(found),
               [&](const MapObject& object) {
                 return (!label || object.labels.front().label == *label) &&
                        (!box_m || Meet(object, *box_m));
               });
  return found;
}

}  // namespace semantic_slam
