#include "semantic_slam/map/map_check.h"

#include <limits>

#include <gtest/gtest.h>

#include "map/small_maps.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

// Keyframes by their place in the contents: 0 to 3 are dormant, 4 to 6 are 4, 6 and 7.
class MapCheckTest : public testing::Test {
 protected:
  std::string Refusal() const {
    return MessageOf<InputError>([&] { CheckMapContents(contents_); });
  }

  MapContents contents_ = SmallMaps().map.Contents();
};

TEST_F(MapCheckTest, FindsNothingWrongWithASoundMap) {
  EXPECT_EQ(Refusal(), "");
}

TEST_F(MapCheckTest, RefusesAMapWithoutKeyframes) {
  contents_.keyframes.resize(4);  // those of the dormant one
  EXPECT_EQ(Refusal(), "its map has no keyframe");
}

TEST_F(MapCheckTest, RefusesIdsOutOfOrder) {
  contents_.keyframes[1].id = 0;
  EXPECT_EQ(Refusal(), "keyframe 0 is out of order");
}

TEST_F(MapCheckTest, RefusesIdsThatMayBeGivenAwayAgain) {
  contents_.next_keyframe = 7;
  EXPECT_EQ(Refusal(), "keyframe 7 is out of order");
}

TEST_F(MapCheckTest, RefusesIdsThatWouldRunOut) {
  contents_.next_keyframe = std::numeric_limits<KeyframeId>::max();
  EXPECT_EQ(Refusal(), "its next keyframe would be 9223372036854775807");
}

TEST_F(MapCheckTest, RefusesAMapThatHasNotBegun) {
  contents_.keyframes[2].map_id = 3;
  EXPECT_EQ(Refusal(), "keyframe 2 is of map 3, which is none");
}

TEST_F(MapCheckTest, RefusesAParentThatIsNotThere) {
  contents_.keyframes[6].parent = 5;  // culled
  EXPECT_EQ(Refusal(), "keyframe 7 has a parent that is not there");
  contents_.keyframes[6].parent = 3;  // of another map
  EXPECT_EQ(Refusal(), "keyframe 7 has a parent that is not there");
}

TEST_F(MapCheckTest, RefusesParentsInACircle) {
  contents_.keyframes[4].parent = 7;
  contents_.keyframes[6].parent = 4;
  EXPECT_EQ(Refusal(), "keyframe 4 is among its own ancestors");
}

TEST_F(MapCheckTest, RefusesAPoseThatIsNone) {
  contents_.keyframes[0].T_map_camera.matrix()(0, 0) = 2.0;
  EXPECT_EQ(Refusal(), "keyframe 0 has a pose that is none");
  contents_ = SmallMaps().map.Contents();
  contents_.culled[0].T_parent_keyframe.translation().x() =
      std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Refusal(), "culled keyframe 5 has a pose that is none");
}

TEST_F(MapCheckTest, RefusesACulledKeyframeThatCannotMove) {
  contents_.culled[0].parent = 5;
  EXPECT_EQ(Refusal(), "culled keyframe 5 has a parent that is not there");
  contents_.culled[0].id = 6;  // lives
  EXPECT_EQ(Refusal(), "culled keyframe 6 is out of order");
}

TEST_F(MapCheckTest, RefusesAViewOfNothing) {
  contents_.keyframes[0].points[0] = static_cast<PointId>(contents_.points.size());
  EXPECT_EQ(Refusal(), "keyframe 0 shows a point that is not there");
  contents_.keyframes[0].points[0] = -2;
  EXPECT_EQ(Refusal(), "keyframe 0 shows a point that is not there");
  contents_.keyframes[0].points[0] = contents_.keyframes[6].points[0];  // of another map
  EXPECT_EQ(Refusal(), "keyframe 0 shows a point that is not there");
}

TEST_F(MapCheckTest, RefusesAPointThatIsSeenTwiceOrNever) {
  const PointId first = contents_.keyframes[0].points[0];
  contents_.keyframes[0].points[1] = first;
  EXPECT_EQ(Refusal(), "keyframe 0 shows a point twice");
  contents_ = SmallMaps().map.Contents();
  for (Keyframe& keyframe : contents_.keyframes) {
    for (PointId& point : keyframe.points) {
      if (point == first) point = kNoPoint;
    }
  }
  EXPECT_EQ(Refusal(), "a point is seen by no keyframe");
}

TEST_F(MapCheckTest, RefusesFeaturesOfWhichItDoesNotKnowWhatTheyShow) {
  contents_.keyframes[0].points.pop_back();
  EXPECT_EQ(Refusal(), "keyframe 0 does not say of each feature which point it shows");
}

TEST_F(MapCheckTest, RefusesAPointThatLiesNowhere) {
  contents_.points[3].position.z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Refusal(), "point 3 lies nowhere");
  contents_.points[3] = contents_.points[2];
  EXPECT_EQ(Refusal(), "point 3 is out of order");
  contents_.points[3].id = 3;
  contents_.points[3].reference = 99;
  EXPECT_EQ(Refusal(), "point 3 has no reference keyframe");
}

TEST_F(MapCheckTest, RefusesALoopBetweenMaps) {
  contents_.loop_edges[0].a = 0;
  EXPECT_EQ(Refusal(), "a loop ties keyframes that are not there");
}

}  // namespace
}  // namespace semantic_slam
