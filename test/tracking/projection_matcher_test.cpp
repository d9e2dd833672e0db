#include "semantic_slam/tracking/projection_matcher.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// A point 2 m before a camera at the map's origin, seen there on level 0.
MapPoint PointAhead() {
  MapPoint point;
  point.position = {0.0, 0.0, 2.0};
  point.view_direction = {0.0, 0.0, -1.0};
  point.max_distance_m = 2.0;
  point.min_distance_m = 2.0 / SmallExtractor().scales().back();
  return point;
}

std::optional<PredictedView> ViewFrom(const Rigid3d& T_map_camera,
                                      const MapPoint& point = PointAhead()) {
  return PredictView(point, T_map_camera.inverse(), *SmallCamera(), SmallExtractor().scales());
}

Rigid3d Along(double x_m, double z_m) {
  return Rigid3d(Eigen::Translation3d(x_m, 0.0, z_m));
}

// 2 m from the point, turned about it by `angle_rad`, and looking at it.
Rigid3d AroundThePoint(double angle_rad) {
  return Along(0.0, 2.0) * Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()) *
         Along(0.0, -2.0);
}

TEST(PredictViewTest, FromWhereItWasSeenThePointLooksTheSame) {
  const auto view = ViewFrom(Rigid3d::Identity());
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->pixel.x(), 159.5, 1e-4);
  EXPECT_NEAR(view->pixel.y(), 119.5, 1e-4);
  EXPECT_NEAR(view->view_cosine, 1.0, 1e-12);
  EXPECT_EQ(view->octave, 0);
}

TEST(PredictViewTest, FromNearerItIsFoundFartherUpThePyramid) {
  // 1.2^-1.5 of the distance lies between levels 1 and 2.
  const auto view = ViewFrom(Along(0.0, 2.0 - 2.0 * std::pow(1.2, -1.5)));
  ASSERT_TRUE(view);
  EXPECT_EQ(view->octave, 2);
}

TEST(PredictViewTest, OnlyWithinTheDistancesOfItsScale) {
  // Seven levels of 1.2 and a margin of a fifth: from 2 * 1.2^-7 * 0.8 = 0.45 m to 2 * 1.2 = 2.4 m.
  EXPECT_FALSE(ViewFrom(Along(0.0, 2.0 - 0.44)));
  EXPECT_TRUE(ViewFrom(Along(0.0, 2.0 - 0.46)));
  EXPECT_TRUE(ViewFrom(Along(0.0, 2.0 - 2.39)));
  EXPECT_FALSE(ViewFrom(Along(0.0, 2.0 - 2.41)));
}

TEST(PredictViewTest, OnlyWithinTheImage) {
  // The right border is (319 - 159.5) / 260 * 2 m = 1.227 m off the axis.
  EXPECT_TRUE(ViewFrom(Along(-1.22, 0.0)));
  EXPECT_FALSE(ViewFrom(Along(-1.24, 0.0)));
  EXPECT_FALSE(ViewFrom(Along(1.24, 0.0)));
}

TEST(PredictViewTest, OnlyWithinSixtyDegreesOfItsDirection) {
  const auto view = ViewFrom(AroundThePoint(59.0 * M_PI / 180.0));
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->view_cosine, std::cos(59.0 * M_PI / 180.0), 1e-12);
  EXPECT_FALSE(ViewFrom(AroundThePoint(61.0 * M_PI / 180.0)));
}

TEST(PredictViewTest, NothingBehindTheCamera) {
  EXPECT_FALSE(ViewFrom(Along(0.0, 2.0)));
  EXPECT_FALSE(ViewFrom(Along(0.0, 4.0)));
}

class MatchByProjectionTest : public testing::Test {
 protected:
  // Looks for feature `i` of the frame exactly where and as it is.
  ProjectionCandidate CandidateFor(int i) const {
    const Feature& feature = (*frame_)[i];
    return {feature.pixel, 2.0f, 0, 7, feature.angle_rad, &frame_->descriptor(i)};
  }

  std::vector<ProjectionCandidate> AllCandidates() const {
    std::vector<ProjectionCandidate> candidates;
    for (int i = 0; i < static_cast<int>(frame_->size()); ++i)
      candidates.push_back(CandidateFor(i));
    return candidates;
  }

  std::vector<int> Match(const std::vector<ProjectionCandidate>& candidates,
                         const ProjectionMatchingOptions& options = {}) const {
    return MatchByProjection(candidates, *frame_, none_taken_, options);
  }

  // The nearest two features of one octave.
  std::pair<int, int> ClosestPair() const {
    std::pair<int, int> best;
    float nearest = 1e9f;
    for (int i = 0; i < static_cast<int>(frame_->size()); ++i) {
      for (int j = 0; j < i; ++j) {
        const Feature &a = (*frame_)[i], &b = (*frame_)[j];
        const float distance = (a.pixel - b.pixel).norm();
        if (a.octave != b.octave || distance >= nearest) continue;
        nearest = distance;
        best = {i, j};
      }
    }
    return best;
  }

  const std::shared_ptr<const FrameFeatures> frame_ = SquaresFeatures(1);
  const std::vector<bool> none_taken_ = std::vector<bool>(frame_->size(), false);
};

TEST_F(MatchByProjectionTest, EveryFeatureFindsItself) {
  const std::vector<int> matches = Match(AllCandidates());
  for (int i = 0; i < static_cast<int>(matches.size()); ++i) EXPECT_EQ(matches[i], i);
}

TEST_F(MatchByProjectionTest, NothingIsFoundElsewhere) {
  ProjectionCandidate candidate = CandidateFor(0);
  candidate.pixel += Eigen::Vector2f(3.0f, 0.0f);
  candidate.radius_px = 3.5f;
  EXPECT_EQ(Match({candidate})[0], 0);
  candidate.radius_px = 2.5f;
  EXPECT_NE(Match({candidate})[0], 0);
}

TEST_F(MatchByProjectionTest, NothingIsFoundOnAnotherOctave) {
  ProjectionCandidate candidate = CandidateFor(0);  // the first features are those of octave 0
  ASSERT_EQ((*frame_)[0].octave, 0);
  candidate.min_octave = 1;
  EXPECT_NE(Match({candidate})[0], 0);
}

TEST_F(MatchByProjectionTest, TakenFeaturesAreLeftAlone) {
  std::vector<bool> is_taken = none_taken_;
  is_taken[0] = true;
  EXPECT_NE(MatchByProjection({CandidateFor(0)}, *frame_, is_taken, {})[0], 0);
}

TEST_F(MatchByProjectionTest, DescriptorsThatDifferTooMuchDoNotMatch) {
  Descriptor changed = frame_->descriptor(0);
  changed[0] ^= 0xFFFF;  // 16 bits
  ProjectionCandidate candidate = CandidateFor(0);
  candidate.descriptor = &changed;
  candidate.max_octave = 0;
  ProjectionMatchingOptions options;
  options.max_distance = 16;
  EXPECT_EQ(Match({candidate}, options)[0], 0);
  options.max_distance = 15;
  EXPECT_EQ(Match({candidate}, options)[0], -1);
}

TEST_F(MatchByProjectionTest, OfTwoCandidatesTheBetterOneGetsTheFeature) {
  Descriptor changed = frame_->descriptor(0);
  changed[0] ^= 0xF;
  ProjectionCandidate worse = CandidateFor(0);
  worse.descriptor = &changed;
  worse.radius_px = 0.1f;
  worse.max_octave = 0;
  EXPECT_EQ(Match({worse, CandidateFor(0)}), (std::vector<int>{-1, 0}));
  EXPECT_EQ(Match({CandidateFor(0), worse}), (std::vector<int>{0, -1}));
}

TEST_F(MatchByProjectionTest, TheRatioTestRefusesWhatCouldBeEither) {
  const auto [a, b] = ClosestPair();
  // As far from one as from the other, within a bit.
  Descriptor between = frame_->descriptor(a);
  int to_flip = HammingDistance(frame_->descriptor(a), frame_->descriptor(b)) / 2;
  for (int bit = 0; bit < kMaxDescriptorDistance && to_flip > 0; ++bit) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    if (((between[bit / 64] ^ frame_->descriptor(b)[bit / 64]) & mask) == 0) continue;
    between[bit / 64] ^= mask;
    --to_flip;
  }
  ProjectionCandidate candidate = CandidateFor(a);
  candidate.descriptor = &between;
  candidate.radius_px = ((*frame_)[a].pixel - (*frame_)[b].pixel).norm() + 0.1f;
  candidate.min_octave = candidate.max_octave = (*frame_)[a].octave;
  ProjectionMatchingOptions options;
  options.max_distance = 256;
  EXPECT_GE(Match({candidate}, options)[0], 0);
  options.max_ratio = 0.8;
  EXPECT_EQ(Match({candidate}, options)[0], -1);
}

TEST_F(MatchByProjectionTest, MatchesThatTurnOtherwiseThanTheRestAreWrong) {
  auto candidates = AllCandidates();
  for (auto& candidate : candidates) candidate.angle_rad += 0.5f;  // the camera rolled
  candidates[10].angle_rad += 2.0f;
  ProjectionMatchingOptions options;
  EXPECT_EQ(Match(candidates, options)[10], 10);
  options.check_rotation = true;
  const std::vector<int> matches = Match(candidates, options);
  for (int i = 0; i < static_cast<int>(matches.size()); ++i) {
    EXPECT_EQ(matches[i], i == 10 ? -1 : i);
  }
}

TEST_F(MatchByProjectionTest, WithoutCandidatesThereIsNothingToMatch) {
  EXPECT_TRUE(Match({}).empty());
}

}  // namespace
}  // namespace semantic_slam
