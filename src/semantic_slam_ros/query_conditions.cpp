#include "semantic_slam_ros/query_conditions.h"

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;

std::optional<Eigen::AlignedBox3d> ToBox(const geometry_msgs::Point& low,
                                         const geometry_msgs::Point& high) {
  const Eigen::Vector3d min(low.x, low.y, low.z), max(high.x, high.y, high.z);
  if (!min.allFinite() || !max.allFinite() || (min.array() > max.array()).any()) {
    throw InputError("box_min and box_max are not the lower and the upper corner of a box");
  }
  if (min == max) return std::nullopt;
  return Eigen::AlignedBox3d(min, max);
}

std::optional<semantic_slam::LabelId> ToLabel(const std::string& name,
                                              const semantic_slam::LabelVocabulary& vocabulary) {
  if (name.empty()) return std::nullopt;
  const auto label = vocabulary.Find(name);
  if (!label) throw InputError("there is no class '" + name + "'");
  return label;
}

}  // namespace semantic_slam_ros
