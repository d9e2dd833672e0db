#include "semantic_slam/plane_projection/hollowness.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const ConvexPolygon kTop{{0, 0}, {1, 0}, {1, 1}, {0, 1}};  // at 0.75 m
constexpr double kHeightM = 0.75;
const Eigen::Vector3f kEye(-2.0f, 0.5f, 0.9f);  // in front, looking below the top

// A fan of lines of sight that end on the wall behind the table, where it begins to be hidden by
// the top, and below; or, with `front`, on a board that closes the front of it.
std::vector<Sight> Fan(bool front) {
  std::vector<Sight> sights;
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 40; ++j) {
      const Eigen::Vector3f at_front(0.0f, i / 60.0f, 0.65f * j / 40.0f);
      const Eigen::Vector3f ray = at_front - kEye;
      // Beyond the front a line goes on to the floor.
      const float to_floor = -kEye.z() / ray.z();
      const Eigen::Vector3f floor = kEye + to_floor * ray;
      sights.push_back({front ? at_front : floor, front});
    }
  }
  return sights;
}

TEST(HollownessTest, ATableIsOpenBelowItsTop) {
  const SpaceBelow below = LookBelow(kTop, kHeightM, kEye, Fan(false), {});
  EXPECT_EQ(below.free_columns + below.occupied_columns + below.unseen_columns, 400);  // of 5 cm
  EXPECT_EQ(below.occupied_columns, 0);
  EXPECT_GT(below.free_columns, 380);  // lines of sight are at most 3 cm apart
  EXPECT_EQ(JudgeHollowness(below, true, {}), Hollowness::kFull);
  EXPECT_EQ(JudgeHollowness(below, false, {}), Hollowness::kPartly);
}

TEST(HollownessTest, ACabinetIsNot) {
  const SpaceBelow below = LookBelow(kTop, kHeightM, kEye, Fan(true), {});
  EXPECT_EQ(below.free_columns, 0);
  EXPECT_EQ(below.occupied_columns, 20);  // the front
  EXPECT_EQ(below.unseen_columns, 380);
  EXPECT_EQ(JudgeHollowness(below, false, {}), Hollowness::kNo);
}

TEST(HollownessTest, FromAboveNothingIsSeenBelow) {
  std::vector<Sight> sights;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) sights.push_back({{0.02f * i, 0.02f * j, 0.75f}, true});
  }
  sights.push_back({{-0.3f, 0.5f, 0.0f}, false});  // the floor beside it
  const SpaceBelow below = LookBelow(kTop, kHeightM, {0.5f, 0.5f, 2.0f}, sights, {});
  EXPECT_EQ(below.unseen_columns, 400);
  EXPECT_EQ(JudgeHollowness(below, true, {}), Hollowness::kPartly);  // as the class is
  EXPECT_EQ(JudgeHollowness(below, false, {}), Hollowness::kNo);
}

TEST(HollownessTest, WhereNothingIsSeenFarBelowThereIsNoRoom) {
  // A cup of 10 cm, and its table all around.
  const ConvexPolygon rim{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}};
  std::vector<Sight> sights;
  for (int i = -10; i < 20; ++i) {
    for (int j = -10; j < 20; ++j) sights.push_back({{0.01f * i, 0.01f * j, 0.75f}, false});
  }
  const SpaceBelow below = LookBelow(rim, 0.85, kEye, sights, {});
  EXPECT_EQ(below.free_columns + below.unseen_columns, 0);
}

TEST(HollownessTest, BetweenOpenAndClosedItIsPartlyOpen) {
  SpaceBelow below;
  below.free_columns = 50, below.occupied_columns = 50;
  EXPECT_EQ(JudgeHollowness(below, true, {}), Hollowness::kPartly);
  EXPECT_EQ(JudgeHollowness(below, false, {}), Hollowness::kNo);
  below.free_columns = 10, below.occupied_columns = 90;
  EXPECT_EQ(JudgeHollowness(below, true, {}), Hollowness::kNo);
}

TEST(HollownessTest, ViewsAddUp) {
  SpaceBelow sum = LookBelow(kTop, kHeightM, kEye, Fan(false), {});
  const SpaceBelow once = sum;
  sum += once;
  EXPECT_EQ(sum.free_columns, 2 * once.free_columns);
  EXPECT_EQ(sum.unseen_columns, 2 * once.unseen_columns);
}

TEST(HollownessTest, NothingSeenIsNothingCounted) {
  EXPECT_EQ(LookBelow({}, kHeightM, kEye, Fan(false), {}).free_columns, 0);
  EXPECT_EQ(LookBelow(kTop, kHeightM, kEye, {}, {}).free_columns, 0);
  EXPECT_EQ(JudgeHollowness({}, false, {}), Hollowness::kNo);
}

TEST(HollownessTest, AHugeFootprintIsLookedAtCoarsely) {
  const ConvexPolygon huge{{-5e3, -5e3}, {5e3, -5e3}, {5e3, 5e3}, {-5e3, 5e3}};
  const SpaceBelow below = LookBelow(huge, kHeightM, kEye, Fan(false), {});
  EXPECT_LE(below.free_columns + below.occupied_columns + below.unseen_columns, 401 * 401);
}

}  // namespace
}  // namespace semantic_slam
