#include "semantic_slam_ros/object_markers.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::LabelClass;
using semantic_slam::LabelVocabulary;
using semantic_slam::MapObject;
using semantic_slam::ObjectMap;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

LabelVocabulary Vocabulary() {
  LabelClass unknown, table;
  unknown.name = "unknown";
  table.id = 7;
  table.name = "table";
  table.rgb = {255, 0, 51};
  return LabelVocabulary({unknown, table});
}

MapObject Table(semantic_slam::ObjectId id) {
  MapObject table;
  table.id = id;
  table.labels = {{7, 0.875f}};
  table.T_map_box.translation() << 1.0, 2.0, 0.5;
  table.box_size_m = {1.2, 0.8, 0.0};
  table.min_height_m = 0.25;
  table.max_height_m = 0.75;
  table.footprint_m = {{0, 0}, {1, 0}, {1, 1}};
  return table;
}

ObjectMap MapOf(const std::vector<MapObject>& objects) {
  ObjectMap map;
  map.stamp = semantic_slam::Stamp{5'000'000'000};
  map.objects = objects;
  return map;
}

const Marker& Find(const MarkerArray& markers, const std::string& ns, int id) {
  const auto at = std::find_if(markers.markers.begin(), markers.markers.end(),
                               [&](const Marker& m) { return m.ns == ns && m.id == id; });
  EXPECT_NE(at, markers.markers.end()) << ns << id;
  return *at;
}

TEST(ObjectMarkersTest, ShowBoxFootprintAndName) {
  const MarkerArray markers = ObjectMarkers().Draw(MapOf({Table(3)}), Vocabulary(), "map");
  ASSERT_EQ(markers.markers.size(), 3u);
  for (const Marker& marker : markers.markers) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.header.stamp, ros::Time(5, 0));
    EXPECT_EQ(marker.action, Marker::ADD);
    EXPECT_GT(marker.color.a, 0.0f);
    EXPECT_EQ(marker.pose.orientation.w, 1.0);
  }
  const Marker& box = Find(markers, "boxes", 3);
  EXPECT_EQ(box.type, Marker::CUBE);
  EXPECT_EQ(box.pose.position.y, 2.0);
  EXPECT_EQ(box.scale.x, 1.2);
  EXPECT_GT(box.scale.z, 0.0);  // rviz refuses none
  EXPECT_FLOAT_EQ(box.color.b, 0.2f);
  const Marker& footprint = Find(markers, "footprints", 3);
  ASSERT_EQ(footprint.points.size(), 4u);  // closed
  EXPECT_EQ(footprint.points[0].x, footprint.points[3].x);
  EXPECT_EQ(footprint.points[0].z, 0.25);
  EXPECT_EQ(Find(markers, "names", 3).text, "table 0.88");
}

TEST(ObjectMarkersTest, ObjectsThatAreGoneAreTakenAwayOnce) {
  ObjectMarkers markers;
  markers.Draw(MapOf({Table(1), Table(2)}), Vocabulary(), "map");
  const MarkerArray second = markers.Draw(MapOf({Table(2)}), Vocabulary(), "map");
  EXPECT_EQ(Find(second, "boxes", 1).action, Marker::DELETE);
  EXPECT_EQ(Find(second, "footprints", 1).action, Marker::DELETE);
  EXPECT_EQ(Find(second, "names", 1).action, Marker::DELETE);
  EXPECT_EQ(Find(second, "boxes", 2).action, Marker::ADD);
  EXPECT_EQ(second.markers.size(), 6u);
  EXPECT_EQ(markers.Draw(MapOf({Table(2)}), Vocabulary(), "map").markers.size(), 3u);
}

TEST(ObjectMarkersTest, AnObjectWithoutFootprintIsDrawnAllTheSame) {
  MapObject point = Table(1);
  point.footprint_m.clear();
  EXPECT_TRUE(Find(ObjectMarkers().Draw(MapOf({point}), Vocabulary(), "map"), "footprints", 1)
                  .points.empty());
}

}  // namespace
}  // namespace semantic_slam_ros
