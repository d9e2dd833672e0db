#include "semantic_slam_ros/object_markers.h"

#include <algorithm>
#include <cstdio>

#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::LabelClass;
using semantic_slam::LabelVocabulary;
using semantic_slam::MapObject;
using semantic_slam::ObjectId;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

constexpr double kLineM = 0.01;
constexpr double kTextM = 0.08;
constexpr float kBoxAlpha = 0.35f;
constexpr char kBoxes[] = "boxes";
constexpr char kFootprints[] = "footprints";
constexpr char kNames[] = "names";

// Marker ids are 32 bits; objects are numbered from 1 and are far fewer.
Marker MakeMarker(const std_msgs::Header& header, const char* ns, ObjectId id) {
  Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = static_cast<std::int32_t>(id);
  marker.pose.orientation.w = 1.0;
  return marker;
}

std_msgs::ColorRGBA Colour(const LabelClass& label, float alpha) {
  std_msgs::ColorRGBA colour;
  colour.r = static_cast<float>(label.rgb[0]) / 255.0f;
  colour.g = static_cast<float>(label.rgb[1]) / 255.0f;
  colour.b = static_cast<float>(label.rgb[2]) / 255.0f;
  colour.a = alpha;
  return colour;
}

Marker BoxOf(const MapObject& object, const LabelClass& label, const std_msgs::Header& header) {
  Marker marker = MakeMarker(header, kBoxes, object.id);
  marker.type = Marker::CUBE;
  marker.pose = ToPose(object.T_map_box);
  // rviz refuses a scale of zero.
  marker.scale.x = std::max(object.box_size_m.x(), kLineM);
  marker.scale.y = std::max(object.box_size_m.y(), kLineM);
  marker.scale.z = std::max(object.box_size_m.z(), kLineM);
  marker.color = Colour(label, kBoxAlpha);
  return marker;
}

Marker FootprintOf(const MapObject& object, const LabelClass& label,
                   const std_msgs::Header& header) {
  Marker marker = MakeMarker(header, kFootprints, object.id);
  marker.type = Marker::LINE_STRIP;
  marker.scale.x = kLineM;
  marker.color = Colour(label, 1.0f);
  for (std::size_t i = 0; i <= object.footprint_m.size() && !object.footprint_m.empty(); ++i) {
    const Eigen::Vector2d& corner = object.footprint_m[i % object.footprint_m.size()];
    geometry_msgs::Point point;
    point.x = corner.x();
    point.y = corner.y();
    point.z = object.min_height_m;
    marker.points.push_back(point);
  }
  return marker;
}

Marker NameOf(const MapObject& object, const LabelClass& label, const std_msgs::Header& header) {
  Marker marker = MakeMarker(header, kNames, object.id);
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.pose.position.x = object.T_map_box.translation().x();
  marker.pose.position.y = object.T_map_box.translation().y();
  marker.pose.position.z = object.max_height_m + kTextM;
  marker.scale.z = kTextM;
  marker.color.r = marker.color.g = marker.color.b = marker.color.a = 1.0f;
  char probability[16];
  std::snprintf(probability, sizeof(probability), " %.2f", object.labels.front().probability);
  marker.text = label.name + probability;
  return marker;
}

}  // namespace

MarkerArray ObjectMarkers::Draw(const semantic_slam::ObjectMap& map,
                                const LabelVocabulary& vocabulary, const std::string& map_frame) {
  const std_msgs::Header header = MakeHeader(map.stamp, map_frame);
  MarkerArray markers;
  std::set<ObjectId> gone;
  gone.swap(drawn_);
  for (const MapObject& object : map.objects) {
    const LabelClass& label = vocabulary[object.labels.front().label];
    markers.markers.push_back(BoxOf(object, label, header));
    markers.markers.push_back(FootprintOf(object, label, header));
    markers.markers.push_back(NameOf(object, label, header));
    drawn_.insert(object.id);
    gone.erase(object.id);
  }
  for (const ObjectId id : gone) {
    for (const char* ns : {kBoxes, kFootprints, kNames}) {
      markers.markers.push_back(MakeMarker(header, ns, id));
      markers.markers.back().action = Marker::DELETE;
    }
  }
  return markers;
}

}  // namespace semantic_slam_ros
