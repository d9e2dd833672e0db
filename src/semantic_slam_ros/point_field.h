#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <sensor_msgs/PointField.h>

namespace semantic_slam_ros {

// One number per point, at `offset` bytes from the point's start.
inline sensor_msgs::PointField MakePointField(const std::string& name, std::size_t offset,
                                              std::uint8_t datatype) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = datatype;
  field.count = 1;
  return field;
}

}  // namespace semantic_slam_ros
