#include "semantic_slam/place_recognition/place_index.h"

#include <string>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

std::shared_ptr<const FrameFeatures> RoomView(double t_s) {
  return SmallRoomFeatures(HandheldPath::T_world_camera(t_s),
                           Stamp{static_cast<std::int64_t>(1e9 * (1000.0 + t_s))});
}

TEST(PlaceIndexTest, KnowsNothingAtFirst) {
  const PlaceIndex index{PlaceIndexOptions()};
  EXPECT_TRUE(index.Query(*SquaresFeatures(1)).empty());
  EXPECT_TRUE(index.Keyframes().empty());
}

TEST(PlaceIndexTest, FindsAViewFromNearby) {
  PlaceIndex index{PlaceIndexOptions()};
  for (std::uint32_t seed = 1; seed <= 10; ++seed) index.Add(seed, SquaresFeatures(seed));
  index.Add(20, RoomView(3.0));
  const auto places = index.Query(*RoomView(3.2));  // a few centimetres and degrees on
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.front().keyframe, 20);
  for (std::size_t i = 1; i < places.size(); ++i) {
    EXPECT_LE(places[i].score, places[i - 1].score);
    EXPECT_LT(places[i].score, 0.2 * places.front().score) << places[i].keyframe;
  }
}

TEST(PlaceIndexTest, WhatEveryPlaceShowsSaysLittle) {
  PlaceIndex index{PlaceIndexOptions()};
  for (KeyframeId id = 0; id < 5; ++id) index.Add(id, SquaresFeatures(1));
  index.Add(5, SquaresFeatures(2));
  const double common = index.Query(*SquaresFeatures(1)).front().score;
  const double rare = index.Query(*SquaresFeatures(2)).front().score;
  EXPECT_GT(rare, 3.0 * common);  // log(7 / 1) against log(7 / 5), about as many features
}

TEST(PlaceIndexTest, ForgetsWhatIsRemoved) {
  PlaceIndex index{PlaceIndexOptions()};
  index.Add(1, SquaresFeatures(1));
  index.Add(2, SquaresFeatures(2));
  index.Remove(1);
  index.Remove(7);  // was never there
  EXPECT_EQ(index.Keyframes(), std::set<KeyframeId>{2});
  for (const PlaceScore& place : index.Query(*SquaresFeatures(1))) EXPECT_EQ(place.keyframe, 2);
  index.Add(3, SquaresFeatures(3));  // takes the free place
  EXPECT_EQ(index.Query(*SquaresFeatures(3)).front().keyframe, 3);
  index.Clear();
  EXPECT_TRUE(index.Query(*SquaresFeatures(3)).empty());
}

TEST(PlaceIndexTest, AddingTwiceChangesNothing) {
  PlaceIndex once{PlaceIndexOptions()}, twice{PlaceIndexOptions()};
  once.Add(1, SquaresFeatures(1));
  for (int i = 0; i < 2; ++i) twice.Add(1, SquaresFeatures(1));
  EXPECT_EQ(once.Query(*SquaresFeatures(1)).front().score,
            twice.Query(*SquaresFeatures(1)).front().score);
}

TEST(PlaceIndexTest, TakesImagesWithoutFeatures) {
  const auto blank = std::make_shared<const FrameFeatures>(BlankImage(Stamp{1}), *SmallCamera(),
                                                           SmallExtractor());
  PlaceIndex index{PlaceIndexOptions()};
  index.Add(1, blank);
  EXPECT_TRUE(index.Query(*blank).empty());
  index.Remove(1);
  EXPECT_TRUE(index.Keyframes().empty());
}

TEST(PlaceIndexTest, RefusesOptionsByName) {
  PlaceIndexOptions options;
  options.max_distance = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { PlaceIndex index(options); }).substr(0, 16),
            "max_distance = 0");
}

}  // namespace
}  // namespace semantic_slam
