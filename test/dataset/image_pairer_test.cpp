#include "semantic_slam/dataset/image_pairer.h"

#include <memory>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_images.h"
#include "testing/shared_data.h"

namespace semantic_slam {
namespace {

Stamp Ms(std::int64_t ms) {
  return {ms * 1'000'000};
}

std::vector<Stamp> StampsOf(std::initializer_list<std::int64_t> all_ms) {
  std::vector<Stamp> stamps;
  for (const std::int64_t ms : all_ms) stamps.push_back(Ms(ms));
  return stamps;
}

// "0-1 2-0": colour 0 with depth 1, colour 2 with depth 0.
std::string ToText(const std::vector<PairIndices>& pairs) {
  std::string text;
  for (const auto& [colour, depth] : pairs) {
    text += (text.empty() ? "" : " ") + std::to_string(colour) + "-" + std::to_string(depth);
  }
  return text;
}

std::string Paired(const std::vector<Stamp>& colour, const std::vector<Stamp>& depth) {
  return ToText(PairStamps(colour, depth, 0.02));
}

TEST(PairStampsTest, TakesTheGloballyNearestFirst) {
  // Colour 0 comes first and is within 20 ms of depth 0, but colour 1 is nearer to it.
  EXPECT_EQ(Paired(StampsOf({100, 115}), StampsOf({112})), "1-0");
}

TEST(PairStampsTest, IsOneToOneAndOrderedByColour) {
  EXPECT_EQ(Paired(StampsOf({0, 33, 66}), StampsOf({2, 30, 70})), "0-0 1-1 2-2");
}

TEST(PairStampsTest, GivesTheLoserItsNextNearest) {
  // Depth 0 goes to colour 1 (5 ms); colour 0 takes depth 1 although it is 12 ms away.
  EXPECT_EQ(Paired(StampsOf({100, 115}), StampsOf({110, 112})), "0-0 1-1");
  EXPECT_EQ(Paired(StampsOf({100, 109}), StampsOf({108, 112})), "0-1 1-0");
}

TEST(PairStampsTest, TheGapIsInclusive) {
  EXPECT_EQ(Paired(StampsOf({0, 100}), StampsOf({20, 121})), "0-0");
}

TEST(PairStampsTest, OfEqualGapsTheEarlierWins) {
  EXPECT_EQ(Paired(StampsOf({0, 10}), StampsOf({5})), "0-0");
  EXPECT_EQ(Paired(StampsOf({5}), StampsOf({0, 10})), "0-0");
}

TEST(PairStampsTest, EmptyListsHaveNoPairs) {
  EXPECT_TRUE(PairStamps({}, StampsOf({1}), 0.02).empty());
  EXPECT_TRUE(PairStamps(StampsOf({1}), {}, 0.02).empty());
}

using Pairer = ImagePairer<int>;

ImagePairerOptions Waiting() {
  ImagePairerOptions options;
  options.min_period_share = 0.0;
  return options;
}

TEST(ImagePairerTest, EqualStampsLeaveAtOnce) {
  Pairer pairer(Waiting());
  EXPECT_TRUE(pairer.AddColour(Ms(100), 1).pairs.empty());
  const auto pairs = pairer.AddDepth(Ms(100), 2).pairs;
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].colour, 1);
  EXPECT_EQ(pairs[0].depth, 2);
}

TEST(ImagePairerTest, CarriesBothStamps) {
  Pairer pairer;
  pairer.AddDepth(Ms(104), 2);
  pairer.AddColour(Ms(100), 1);
  const auto pairs = pairer.Flush();
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].stamp, Ms(100));
  EXPECT_EQ(pairs[0].depth_stamp, Ms(104));
}

TEST(ImagePairerTest, WaitsWhileANearerImageMayCome) {
  Pairer pairer(Waiting());
  pairer.AddColour(Ms(100), 0);
  EXPECT_TRUE(pairer.AddDepth(Ms(112), 0).pairs.empty());  // a colour image at 112 may still come
  const auto pairs = pairer.AddColour(Ms(115), 1).pairs;   // and at 115 it does
  EXPECT_TRUE(pairs.empty());  // one at 113 cannot come any more, but depth at 116 may
  const auto flushed = pairer.Flush();
  ASSERT_EQ(flushed.size(), 1u);
  EXPECT_EQ(flushed[0].colour, 1);
  EXPECT_EQ(pairer.counts().unpaired_colour, 1u);
}

// Feeds image `i` of a 30 Hz camera whose depth images are `gap_ms` late. True if the two leave as
// a pair with the second of them.
bool LeavesAtOnce(Pairer& pairer, int i, int gap_ms) {
  pairer.AddColour(Ms(33 * i), i);
  const auto pairs = pairer.AddDepth(Ms(33 * i + gap_ms), i).pairs;
  return !pairs.empty() && pairs.back().colour == i;
}

TEST(ImagePairerTest, KnowingThePeriodSparesTheWait) {
  Pairer pairer;
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(LeavesAtOnce(pairer, i, 8)) << i;
  // Ten gaps of 33 ms: no colour image is expected in the next 24 ms.
  for (int i = 10; i < 20; ++i) EXPECT_TRUE(LeavesAtOnce(pairer, i, 8)) << i;
  EXPECT_TRUE(LeavesAtOnce(pairer, 20, 12));
  EXPECT_FALSE(LeavesAtOnce(pairer, 21, 13)) << "a colour image 12 ms after depth may come";
}

TEST(ImagePairerTest, AShortGapMakesItWaitAgain) {
  Pairer pairer;
  for (int i = 0; i < 20; ++i) LeavesAtOnce(pairer, i, 8);
  pairer.AddColour(Ms(33 * 19 + 10), 100);  // 10 ms after the one before
  EXPECT_FALSE(LeavesAtOnce(pairer, 20, 8)) << "now one may come 7.5 ms after colour";
  EXPECT_TRUE(LeavesAtOnce(pairer, 21, 3));
}

TEST(ImagePairerTest, DropsAndCountsImagesWithoutPartner) {
  Pairer pairer;
  for (const int ms : {0, 33, 66, 100}) pairer.AddColour(Ms(ms), ms);
  std::vector<Pairer::Pair> pairs = pairer.AddDepth(Ms(100), 0).pairs;
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].colour, 100);
  EXPECT_EQ(pairer.counts().unpaired_colour, 3u);
  for (const int ms : {133, 166, 200}) pairer.AddDepth(Ms(ms), ms);
  pairer.AddColour(Ms(200), 0);
  EXPECT_EQ(pairer.counts().unpaired_depth, 2u);
}

TEST(ImagePairerTest, HoldsNoMoreThanItsCapacity) {
  ImagePairerOptions options;
  options.capacity = 3;
  ImagePairer<std::shared_ptr<int>> pairer(options);
  const auto image = std::make_shared<int>(0);
  for (int i = 0; i < 100; ++i) pairer.AddColour(Ms(33 * i), image);
  EXPECT_EQ(image.use_count(), 1 + 3);
  EXPECT_EQ(pairer.counts().unpaired_colour, 97u);
}

TEST(ImagePairerTest, LeavesOutWhatComesTwiceOrLate) {
  Pairer pairer;
  pairer.AddColour(Ms(500), 1);
  pairer.AddColour(Ms(500), 2);
  pairer.AddColour(Ms(467), 3);
  const auto pairs = pairer.AddDepth(Ms(500), 0).pairs;
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].colour, 1);
  EXPECT_EQ(pairer.counts().out_of_order, 2u);
}

// A pairer in the middle of a recording: both streams are at 10 s, and a colour image waits.
Pairer TenSecondsIn() {
  Pairer pairer;
  pairer.AddColour(Ms(10'000), 1);
  pairer.AddDepth(Ms(10'000), 1);
  pairer.AddColour(Ms(10'033), 2);
  return pairer;
}

TEST(ImagePairerTest, ForgetsAndSaysSoWhenTimeJumpsBack) {
  Pairer pairer = TenSecondsIn();
  for (const int ms : {0, 33}) {
    EXPECT_FALSE(pairer.AddColour(Ms(ms), ms).jumped_back);
    EXPECT_FALSE(pairer.AddDepth(Ms(ms), ms).jumped_back);
  }
  const auto jump = pairer.AddColour(Ms(66), 66);
  EXPECT_TRUE(jump.jumped_back);
  // Nothing of the new recording is lost, not even what came before the jump was certain.
  ASSERT_EQ(jump.pairs.size(), 2u);
  EXPECT_EQ(jump.pairs[0].stamp, Ms(0));
  EXPECT_EQ(jump.pairs[1].stamp, Ms(33));
  const auto next = pairer.AddDepth(Ms(66), 66);
  EXPECT_FALSE(next.jumped_back) << "both streams jumped, but it is one jump";
  ASSERT_EQ(next.pairs.size(), 1u);
  EXPECT_EQ(next.pairs[0].colour, 66);
  EXPECT_EQ(pairer.counts().jumps_back, 1u);
  EXPECT_EQ(pairer.counts().unpaired_colour, 1u);
  EXPECT_EQ(pairer.counts().out_of_order, 0u);
}

TEST(ImagePairerTest, StrayImagesAreNoJumpBack) {
  Pairer pairer = TenSecondsIn();
  pairer.AddColour(Ms(0), 0);
  pairer.AddColour(Ms(33), 0);
  // Two in a row, and the stream goes on as before: colour at 10.033 s is still waiting.
  ASSERT_EQ(pairer.AddDepth(Ms(10'033), 2).pairs.size(), 1u);
  EXPECT_FALSE(pairer.AddColour(Ms(10'066), 3).jumped_back);
  EXPECT_EQ(pairer.counts().out_of_order, 2u);
  EXPECT_FALSE(pairer.AddColour(Ms(66), 0).jumped_back) << "the third, but not in a row";
  ASSERT_EQ(pairer.AddDepth(Ms(10'066), 3).pairs.size(), 1u);
}

TEST(ImagePairerTest, OldImagesInNoOrderAreNoJumpBack) {
  Pairer pairer = TenSecondsIn();
  for (const int ms : {5000, 4000, 3000, 3000, 2000, 1000, 1033}) {
    EXPECT_FALSE(pairer.AddColour(Ms(ms), 0).jumped_back) << ms;
  }
  EXPECT_TRUE(pairer.AddColour(Ms(1066), 0).jumped_back);
  EXPECT_EQ(pairer.counts().out_of_order, 5u);
}

TEST(ImagePairerTest, EachStreamMustShowTheJumpByItself) {
  Pairer pairer = TenSecondsIn();
  for (const int ms : {0, 33}) {
    EXPECT_FALSE(pairer.AddColour(Ms(ms), ms).jumped_back);
    EXPECT_FALSE(pairer.AddDepth(Ms(ms), ms).jumped_back);
  }
  ASSERT_EQ(pairer.AddDepth(Ms(10'033), 2).pairs.size(), 1u) << "four strays, two of each stream";
  pairer.Flush();
  EXPECT_EQ(pairer.counts().out_of_order, 4u);
  EXPECT_EQ(pairer.counts().jumps_back, 0u);
}

TEST(ImagePairerTest, AJumpBackKeepsToTheCapacity) {
  ImagePairerOptions options;
  options.capacity = 1;
  ImagePairer<std::shared_ptr<int>> pairer(options);
  const auto image = std::make_shared<int>(0);
  for (const int ms : {10'000, 0, 33, 66}) pairer.AddColour(Ms(ms), image);
  EXPECT_EQ(pairer.counts().jumps_back, 1u);
  EXPECT_EQ(image.use_count(), 1 + 1);
  EXPECT_EQ(pairer.counts().unpaired_colour, 3u);
}

TEST(ImagePairerTest, RefusesOptionsOutOfRange) {
  ImagePairerOptions options;
  options.max_gap_s = -1.0;
  EXPECT_THROW(Pairer{options}, ConfigError);
}

// 30 Hz with jitter and gaps; strictly ascending.
std::vector<Stamp> JitteryStream(std::mt19937& random) {
  std::uniform_int_distribution<int> step_ms(1, 45);
  std::vector<Stamp> stamps;
  std::int64_t ms = 1000;
  for (int i = 0; i < 200; ++i) stamps.push_back(Ms(ms += step_ms(random)));
  return stamps;
}

// 30 Hz with a camera's jitter, and now and then an image lost. No gap is shorter than 29 ms, and
// that is more than three quarters of any gap between neighbours.
std::vector<Stamp> CameraStream(std::mt19937& random) {
  std::uniform_int_distribution<int> jitter_ms(-4, 4), is_lost(0, 19);
  std::vector<Stamp> stamps;
  std::int64_t ms = 1000 + 4 * jitter_ms(random);
  while (stamps.size() < 200) {
    ms += 33 + jitter_ms(random);
    if (is_lost(random) > 0) stamps.push_back(Ms(ms));
  }
  return stamps;
}

// Feeds both streams in an order in which they could arrive: by stamp, each delayed on its own.
std::string PairedAsTheyArrive(const std::vector<Stamp>& colour, const std::vector<Stamp>& depth,
                               std::int64_t depth_delay_ms, ImagePairerOptions options) {
  options.capacity = 200;
  ImagePairer<std::size_t> pairer(options);
  std::vector<PairIndices> indices;
  const auto keep = [&](const std::vector<ImagePairer<std::size_t>::Pair>& pairs) {
    for (const auto& pair : pairs) indices.push_back({pair.colour, pair.depth});
  };
  std::size_t c = 0, d = 0;
  while (c < colour.size() || d < depth.size()) {
    const bool colour_next =
        d == depth.size() ||
        (c < colour.size() && colour[c].ns <= depth[d].ns + Ms(depth_delay_ms).ns);
    keep(colour_next ? pairer.AddColour(colour[c], c).pairs : pairer.AddDepth(depth[d], d).pairs);
    ++(colour_next ? c : d);
  }
  keep(pairer.Flush());
  const auto counts = pairer.counts();
  EXPECT_EQ(counts.unpaired_colour + indices.size(), colour.size());
  EXPECT_EQ(counts.unpaired_depth + indices.size(), depth.size());
  return ToText(indices);
}

TEST(ImagePairerTest, StreamsGiveThePairsOfTheWholeLists) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const auto colour = JitteryStream(random);
    const auto depth = JitteryStream(random);
    const std::string expected = Paired(colour, depth);
    for (const int delay_ms : {-300, 0, 100}) {
      ASSERT_EQ(PairedAsTheyArrive(colour, depth, delay_ms, Waiting()), expected)
          << "streams " << i;
    }
  }
}

TEST(ImagePairerTest, CamerasGiveThePairsOfTheWholeListsWithoutWaiting) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const auto colour = CameraStream(random);
    const auto depth = CameraStream(random);
    const std::string expected = Paired(colour, depth);
    for (const int delay_ms : {-300, 0, 100}) {
      ASSERT_EQ(PairedAsTheyArrive(colour, depth, delay_ms, ImagePairerOptions()), expected)
          << "streams " << i;
    }
  }
}

std::vector<Stamp> StampsOfList(const std::string& folder, const std::string& list) {
  ProblemLog problems;
  std::vector<Stamp> stamps;
  for (const ImageFile& file : ReadImageList(folder, list, problems)) stamps.push_back(file.stamp);
  return stamps;
}

TEST(ImagePairerOnRealDataTest, Freiburg1DeskGivesThePairsOfTheWholeListsWithoutWaiting) {
  const auto folder = SharedData(kFreiburg1Desk);
  SEMANTIC_SLAM_SKIP_WITHOUT(folder, kFreiburg1Desk);
  const auto colour = StampsOfList(*folder, "rgb.txt"), depth = StampsOfList(*folder, "depth.txt");
  for (const int delay_ms : {-30, 0, 30}) {
    EXPECT_EQ(PairedAsTheyArrive(colour, depth, delay_ms, ImagePairerOptions()),
              Paired(colour, depth));
  }
}

}  // namespace
}  // namespace semantic_slam
