#include "semantic_slam/map/map_encoding.h"

#include <cmath>

#include <gtest/gtest.h>

#include "map/small_maps.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

std::string Refusal(const std::string& bytes) {
  return MessageOf<InputError>([&] { DecodeMap(bytes); });
}

TEST(MapEncodingTest, WhatIsDecodedEncodesToTheSameBytes) {
  const std::string bytes = EncodeMap(SmallMaps().Stored());
  EXPECT_TRUE(EncodeMap(DecodeMap(bytes)) == bytes);
}

TEST(MapEncodingTest, NothingIsRounded) {
  StoredMap map = SmallMaps().Stored();
  map.camera.distortion = {0.25, -0.9, -0.005, 0.003, 1.1};
  map.camera.readout_s = 0.02;
  const StoredMap back = DecodeMap(EncodeMap(map));
  EXPECT_TRUE(back.camera == map.camera);
  EXPECT_EQ(back.scales, map.scales);
  EXPECT_EQ(back.contents.map_id, SmallMaps::kPresent);
  EXPECT_EQ(back.contents.next_keyframe, SmallMaps::kNext);
  ASSERT_EQ(back.contents.keyframes.size(), map.contents.keyframes.size());
  const FrameFeatures& features = *map.contents.keyframes[0].features;
  const FrameFeatures& again = *back.contents.keyframes[0].features;
  EXPECT_EQ(again.stamp(), features.stamp());
  EXPECT_EQ(again.descriptors(), features.descriptors());
  ASSERT_EQ(again.size(), features.size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    EXPECT_EQ(again[i].raw, features[i].raw);
    EXPECT_EQ(again[i].exposed, features[i].exposed);
    EXPECT_EQ(again[i].pixel, features[i].pixel);
    EXPECT_EQ(again[i].depth_m, features[i].depth_m);
    EXPECT_EQ(again[i].angle_rad, features[i].angle_rad);
    EXPECT_EQ(again[i].octave, features[i].octave);
    EXPECT_EQ(again[i].rgb, features[i].rgb);
  }
}

TEST(MapEncodingTest, RefusesBytesThatEndAnywhere) {
  const std::string whole = EncodeMap(SmallMaps().Stored());
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 7) {
    EXPECT_NE(Refusal(whole.substr(0, size)), "") << size;
  }
  EXPECT_NE(Refusal(whole.substr(0, whole.size() - 1)), "");
  EXPECT_EQ(Refusal(whole + "x"), "it has bytes that belong to nothing");
}

// Whatever the bytes are, the reader does not crash and does not ask for memory without end; what
// changes a colour or a descriptor is not noticed.
TEST(MapEncodingTest, NoDamageEndsTheProgram) {
  const std::string whole = EncodeMap(SmallMaps().Stored());
  int noticed = 0;
  for (std::size_t i = 0; i < whole.size(); i += i < 500 ? 1 : 997) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xff);
    noticed += !Refusal(damaged).empty();
  }
  EXPECT_GT(noticed, 50);
}

TEST(MapEncodingTest, RefusesACameraThatIsNone) {
  StoredMap map = SmallMaps().Stored();
  map.camera.fx_px = 0.0;
  ExpectOneLineWith(Refusal(EncodeMap(map)), {"camera fx_px = 0"});
}

TEST(MapEncodingTest, RefusesFeaturesThatCannotBe) {
  StoredMap map = SmallMaps().Stored();
  map.scales.resize(1);
  EXPECT_EQ(Refusal(EncodeMap(map)), "it has a feature that cannot be");
  map.scales.clear();
  EXPECT_EQ(Refusal(EncodeMap(map)), "its pyramid is none");
}

}  // namespace
}  // namespace semantic_slam
