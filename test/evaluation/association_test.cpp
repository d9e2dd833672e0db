#include "semantic_slam/evaluation/association.h"

#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

// Poses that say in x which they are: their own stamp.
Trajectory At(const std::vector<double>& stamps_s) {
  Trajectory trajectory;
  for (const double stamp_s : stamps_s) {
    StampedPose stamped{Stamp::FromSeconds(stamp_s), Rigid3d::Identity()};
    stamped.pose.translation().x() = stamp_s;
    trajectory.push_back(stamped);
  }
  return trajectory;
}

// The stamps (reference, estimate) of what matches.
Pairs Matched(const std::vector<double>& reference_s, const std::vector<double>& estimate_s,
              const AssociationOptions& options = {}) {
  Pairs pairs;
  for (const MatchedPose& match : AssociateTrajectories(At(reference_s), At(estimate_s), options)) {
    EXPECT_EQ(match.stamp, Stamp::FromSeconds(match.T_estimate_sensor.translation().x()));
    pairs.emplace_back(match.T_reference_sensor.translation().x(),
                       match.T_estimate_sensor.translation().x());
  }
  return pairs;
}

TEST(AssociationTest, PairsTheNearestStamps) {
  EXPECT_EQ(Matched({1.00, 1.01, 1.02, 1.03}, {1.004, 1.029}),
            (Pairs{{1.00, 1.004}, {1.03, 1.029}}));
}

TEST(AssociationTest, LeavesOutWhatHasNoPartner) {
  EXPECT_EQ(Matched({1.0, 2.0, 3.0}, {1.01, 2.5, 3.01, 4.0}), (Pairs{{1.0, 1.01}, {3.0, 3.01}}));
  EXPECT_TRUE(Matched({1.0}, {}).empty());
  EXPECT_TRUE(Matched({}, {1.0}).empty());
}

TEST(AssociationTest, IsOneToOneAndTheNearerPairGoesFirst) {
  // Both are nearest to 1.000; the farther one has to take 1.020, or nothing if that is not there.
  EXPECT_EQ(Matched({1.000, 1.020}, {1.002, 1.008}), (Pairs{{1.000, 1.002}, {1.020, 1.008}}));
  EXPECT_EQ(Matched({1.000}, {1.002, 1.008}), (Pairs{{1.000, 1.002}}));
  EXPECT_EQ(Matched({1.002, 1.008}, {1.000}), (Pairs{{1.002, 1.000}}));
}

TEST(AssociationTest, OfEquallyNearOnesTheEarlierMatches) {
  AssociationOptions options;
  options.max_dt_s = 0.25;  // like the stamps here, exact in binary
  EXPECT_EQ(Matched({1.0, 1.5}, {1.25}, options), (Pairs{{1.0, 1.25}}));
  EXPECT_EQ(Matched({1.25}, {1.0, 1.5}, options), (Pairs{{1.25, 1.0}}));
  // A chain of ties: 1.25 takes 1.0 and so leaves 1.5 to 1.75.
  EXPECT_EQ(Matched({1.0, 1.5}, {1.25, 1.75}, options), (Pairs{{1.0, 1.25}, {1.5, 1.75}}));
}

TEST(AssociationTest, MatchesUpToAndIncludingTheLargestDifference) {
  AssociationOptions options;
  options.max_dt_s = 0.25;
  EXPECT_EQ(Matched({1.0}, {1.25}, options).size(), 1u);
  EXPECT_EQ(Matched({1.25}, {1.0}, options).size(), 1u);
  EXPECT_EQ(Matched({1.0}, {1.250001}, options).size(), 0u);
  options.max_dt_s = 0.0;
  EXPECT_EQ(Matched({1.0, 2.0}, {1.0, 2.000001}, options), (Pairs{{1.0, 1.0}}));
}

TEST(AssociationTest, AddsTheOffsetToTheEstimatesStampsButKeepsThem) {
  AssociationOptions options;
  options.offset_s = 5.0;
  EXPECT_EQ(Matched({1.0, 6.01}, {1.0}, options), (Pairs{{6.01, 1.0}}));
  options.offset_s = -5.0;
  EXPECT_EQ(Matched({1.0, 6.0}, {6.01}, options), (Pairs{{1.0, 6.01}}));
}

TEST(AssociationTest, SortsByTheEstimatesStamp) {
  AssociationOptions options;
  options.max_dt_s = 10.0;
  // 5.0 and 5.1 match first; what is left crosses them.
  EXPECT_EQ(Matched({5.1, 9.0}, {1.0, 5.0}, options), (Pairs{{9.0, 1.0}, {5.1, 5.0}}));
}

TEST(AssociationTest, RefusesOptionsThatAreOutOfRange) {
  AssociationOptions options;
  options.max_dt_s = -1.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { AssociateTrajectories({}, {}, options); }),
            "max_dt_s = -1, but must be in [0, 10]");
  options = {};
  options.offset_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(MessageOf<ConfigError>([&] { AssociateTrajectories({}, {}, options); }),
            "offset_s = nan, but must be in [-1e+10, 1e+10]");
}

TEST(AssociationTest, RoundedSecondsAreWhatOthersReadFromTheSameText) {
  EXPECT_EQ(RoundedSeconds(Stamp{1305031453359684000}), 1305031453.359684);
  EXPECT_EQ(RoundedSeconds(Stamp{-1'500'000'000}), -1.5);
  std::mt19937_64 random(1);
  for (const double longest_s : {1.0, 1e3, 1e6, 1e7, 1e8, 2e9}) {
    std::uniform_real_distribution<double> seconds(-longest_s, longest_s);
    for (int i = 0; i < 10'000; ++i) {  // a second rounding shows in one of a few thousand
      const Stamp stamp = Stamp::FromSeconds(seconds(random));
      const Stamp to_microseconds{stamp.ns / 1000 * 1000};
      EXPECT_EQ(RoundedSeconds(stamp), std::stod(ToString(stamp)));
      EXPECT_EQ(RoundedSeconds(to_microseconds), std::stod(ToString(to_microseconds)));
    }
  }
}

}  // namespace
}  // namespace semantic_slam
