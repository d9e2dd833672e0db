#include "semantic_slam/object_mapping/object_query.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kTable = 7, kChair = 5;

MapObject Object(ObjectId id, LabelId label, double x, double yaw_rad = 0.0) {
  MapObject object;
  object.id = id;
  object.labels = {{label, 0.8f}};
  object.T_map_box = Eigen::Translation3d(x, 0.0, 0.5) *
                     Rigid3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
  object.box_size_m = {1.0, 1.0, 1.0};
  object.max_height_m = 1.0;
  return object;
}

std::vector<ObjectId> Ids(const std::vector<MapObject>& objects) {
  std::vector<ObjectId> ids;
  for (const MapObject& object : objects) ids.push_back(object.id);
  return ids;
}

ObjectMap Map() {
  ObjectMap map;
  map.objects = {Object(1, kTable, 0.0), Object(2, kChair, 2.0), Object(3, kTable, 4.0, M_PI / 4)};
  return map;
}

Eigen::AlignedBox3d Box(double x0, double x1, double y0 = -0.1, double y1 = 0.1, double z0 = 0.0,
                        double z1 = 1.0) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

using Found = std::vector<ObjectId>;

TEST(FindObjectsTest, ByClassByPlaceAndByBoth) {
  EXPECT_EQ(Ids(FindObjects(Map(), std::nullopt, std::nullopt)), (Found{1, 2, 3}));
  EXPECT_EQ(Ids(FindObjects(Map(), kTable, std::nullopt)), (Found{1, 3}));
  EXPECT_EQ(Ids(FindObjects(Map(), std::nullopt, Box(0.2, 1.6))), (Found{1, 2}));
  EXPECT_EQ(Ids(FindObjects(Map(), kTable, Box(0.2, 1.6))), (Found{1}));
  EXPECT_TRUE(FindObjects(Map(), LabelId{9}, std::nullopt).empty());
  EXPECT_TRUE(FindObjects({}, kTable, Box(0, 1)).empty());
}

TEST(FindObjectsTest, TouchingIsMeeting) {
  EXPECT_EQ(Ids(FindObjects(Map(), std::nullopt, Box(0.5, 1.0))), (Found{1}));
  EXPECT_TRUE(FindObjects(Map(), std::nullopt, Box(0.51, 1.0)).empty());
  EXPECT_EQ(Ids(FindObjects(Map(), std::nullopt, Box(0.0, 0.0, 0.0, 0.0, 1.0, 1.0))), (Found{1}));
  EXPECT_TRUE(FindObjects(Map(), std::nullopt, Box(-1, 5, -1, 1, 1.1, 2.0)).empty());
}

TEST(FindObjectsTest, ATurnedBoxIsNotItsBoundingBox) {
  // The corner of the third object's bounding box, half a diagonal from its middle in x and in y.
  EXPECT_TRUE(FindObjects(Map(), std::nullopt, Box(4.45, 4.7, 0.45, 0.7)).empty());
  EXPECT_EQ(Ids(FindObjects(Map(), std::nullopt, Box(4.3, 4.7, 0.3, 0.7))), (Found{3}));
}

}  // namespace
}  // namespace semantic_slam
