#include "semantic_slam_ros/static_transforms.h"

#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

namespace {

constexpr double kWarnPeriodS = 5.0;

}  // namespace

std::optional<Rigid3d> StaticTransforms::Find(const std::string& target,
                                              const std::string& source) {
  if (target == source) return Rigid3d::Identity();
  const auto known = found_.find({target, source});
  if (known != found_.end()) return known->second;
  std::string why;
  try {
    const Rigid3d T_target_source =
        ToRigid(buffer_.lookupTransform(target, source, ros::Time(0)).transform);
    found_[{target, source}] = T_target_source;
    return T_target_source;
  } catch (const tf2::TransformException& e) {
    why = e.what();
  } catch (const semantic_slam::InputError& e) {
    why = e.what();
  }
  const ros::WallTime now = ros::WallTime::now();
  if ((now - warned_).toSec() > kWarnPeriodS) {
    warned_ = now;
    ROS_WARN("waiting for the transform %s <- %s on tf: %s", target.c_str(), source.c_str(),
             why.c_str());
  }
  return std::nullopt;
}

}  // namespace semantic_slam_ros
