#include "semantic_slam/tracking/semantic_mask.h"

#include <string>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr LabelId kPerson = 31;
constexpr LabelId kWall = 1;

Stamp At(int ms) {
  return {1'000'000'000 + 1'000'000LL * ms};
}

// The person stands in the columns 100 to 139.
LabelImage Person(Stamp stamp) {
  LabelImage image{stamp, cv::Mat(240, 320, CV_8UC1, cv::Scalar::all(kWall)), {kPerson}};
  image.labels.colRange(100, 140) = cv::Scalar::all(kPerson);
  return image;
}

// Features in the middle row, `depth_m` away.
FrameFeatures FeaturesAt(Stamp stamp, const std::vector<float>& columns, float depth_m = 2.0f) {
  std::vector<Feature> features;
  for (const float u : columns) {
    Feature feature{};
    feature.raw = feature.exposed = feature.pixel = {u, 119.5f};
    feature.depth_m = depth_m;
    features.push_back(feature);
  }
  return FrameFeatures(stamp, features, std::vector<Descriptor>(features.size()), *SmallCamera());
}

Rigid3d Shifted(double right_m) {
  Rigid3d T = Rigid3d::Identity();
  T.translation().x() = right_m;
  return T;
}

class SemanticMaskTest : public testing::Test {
 protected:
  SemanticMask Mask(int margin_px = 0) const {
    SemanticMaskOptions options;
    options.margin_px = margin_px;
    return SemanticMask(options);
  }
  const CameraModel& camera_ = *SmallCamera();
};

TEST_F(SemanticMaskTest, LeavesOutWhatTheImagesOwnLabelsShow) {
  SemanticMask mask = Mask();
  EXPECT_EQ(mask.Add(Person(At(0)), camera_), LabelImageFate::kUsed);
  const FrameFeatures features = FeaturesAt(At(0), {99, 100, 139, 140});
  EXPECT_EQ(mask.Find(features, Rigid3d::Identity(), camera_),
            (std::vector<bool>{false, true, true, false}));
}

TEST_F(SemanticMaskTest, TheMarginMakesItWider) {
  SemanticMask mask = Mask(8);
  mask.Add(Person(At(0)), camera_);
  EXPECT_EQ(mask.Find(FeaturesAt(At(0), {91, 92, 147, 148}), Rigid3d::Identity(), camera_),
            (std::vector<bool>{false, true, true, false}));
}

TEST_F(SemanticMaskTest, OlderLabelsFollowTheCameraByDepth) {
  SemanticMask mask = Mask();
  mask.AddPose(At(0), Rigid3d::Identity());
  EXPECT_EQ(mask.Add(Person(At(0)), camera_), LabelImageFate::kUsed);
  // The camera goes 0.2 m to the right: what is 2 m away goes 26 px to the left, what is 4 m away
  // 13 px. f = 260 px.
  EXPECT_EQ(mask.Find(FeaturesAt(At(100), {73, 75, 112, 115}), Shifted(0.2), camera_),
            (std::vector<bool>{false, true, true, false}));
  EXPECT_EQ(mask.Find(FeaturesAt(At(100), {86, 88, 125, 128}, 4.0f), Shifted(0.2), camera_),
            (std::vector<bool>{false, true, true, false}));
}

TEST_F(SemanticMaskTest, LabelsGoOutOfDate) {
  SemanticMask mask = Mask();
  mask.AddPose(At(0), Rigid3d::Identity());
  mask.Add(Person(At(0)), camera_);
  const auto left_out = [&](int ms) -> bool {
    return mask.Find(FeaturesAt(At(ms), {120}), Rigid3d::Identity(), camera_)[0];
  };
  EXPECT_TRUE(left_out(500));
  EXPECT_FALSE(left_out(501));
}

TEST_F(SemanticMaskTest, LabelsThatComeBeforeTheirImageWaitForIt) {
  SemanticMask mask = Mask();
  mask.AddPose(At(0), Rigid3d::Identity());
  mask.Add(Person(At(66)), camera_);
  EXPECT_FALSE(mask.Find(FeaturesAt(At(33), {120}), Rigid3d::Identity(), camera_)[0]);
  EXPECT_TRUE(mask.Find(FeaturesAt(At(66), {120}), Rigid3d::Identity(), camera_)[0]);
  // Their image was never tracked, so nobody knows where they were seen from.
  EXPECT_FALSE(mask.Find(FeaturesAt(At(99), {120}), Rigid3d::Identity(), camera_)[0]);
}

TEST_F(SemanticMaskTest, SaysWhyItCannotUseLabels) {
  SemanticMask mask = Mask();
  LabelImage small = Person(At(0));
  small.labels = small.labels.rowRange(0, 100);
  EXPECT_EQ(mask.Add(small, camera_), LabelImageFate::kBadSize);
  mask.AddPose(At(0), Rigid3d::Identity());
  mask.AddPose(At(600), Rigid3d::Identity());
  EXPECT_EQ(mask.Add(Person(At(0)), camera_), LabelImageFate::kLate);
  EXPECT_EQ(mask.Add(Person(At(300)), camera_), LabelImageFate::kNotTracked);
  EXPECT_EQ(mask.Add(Person(At(600)), camera_), LabelImageFate::kUsed);
  EXPECT_EQ(mask.Add(Person(At(600)), camera_), LabelImageFate::kOutOfOrder);
  mask.Reset();
  EXPECT_EQ(mask.Add(Person(At(0)), camera_), LabelImageFate::kUsed);
}

TEST_F(SemanticMaskTest, RefusesOptionsOutOfRange) {
  EXPECT_EQ(MessageOf<ConfigError>([&] { Mask(-1); }), "margin_px = -1, but must be in [0, 200]");
}

}  // namespace
}  // namespace semantic_slam
