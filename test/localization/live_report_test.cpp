#include "semantic_slam/localization/live_report.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

// Poses after 1, 2, ... `count` ms.
std::vector<PoseDelay> Delays(int count) {
  std::vector<PoseDelay> delays;
  for (int i = count; i > 0; --i) delays.push_back({Stamp{i}, static_cast<double>(i)});
  return delays;
}

TEST(LiveReportTest, CountsWhatCameInTimeAndWhatDidNot) {
  const auto json = LiveJson({Delays(40), 0.0, 0.0}, 50);
  EXPECT_EQ(json["in_time"], 33);  // 33 ms itself is in time
  EXPECT_EQ(json["late"], 7);
  EXPECT_EQ(json["latest_ms"], 33.0);
}

TEST(LiveReportTest, QuantilesAreDelaysThatWere) {
  const auto json = LiveJson({Delays(40), 0.0, 0.0}, 40);
  EXPECT_EQ(json["delay_median_ms"], 20.0);
  EXPECT_EQ(json["delay_p95_ms"], 38.0);
}

TEST(LiveReportTest, DecodingIsApartFromTheRest) {
  const auto json = LiveJson({Delays(4), 3.0, 1.0}, 100);
  EXPECT_DOUBLE_EQ(json["cpu_ms_per_image"], 20.0);
  EXPECT_DOUBLE_EQ(json["decoding_ms_per_image"], 10.0);
}

TEST(LiveReportTest, ARunWithoutImagesHasZeros) {
  const auto json = LiveJson({}, 0);
  EXPECT_EQ(json["in_time"], 0);
  EXPECT_EQ(json["late"], 0);
  EXPECT_EQ(json["delay_median_ms"], 0.0);
  EXPECT_EQ(json["cpu_ms_per_image"], 0.0);
}

TEST(LiveReportTest, WritesALinePerPose) {
  const TemporaryFolder folder;
  WriteDelays({{Stamp{1'500'000'000}, 7.25}, {Stamp{2'000'000'000}, 41.0}}, folder / "delays.csv");
  std::ifstream file(folder / "delays.csv");
  const std::string content{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(content, "stamp,delay_ms\n1.500000,7.250\n2.000000,41.000\n");
}

TEST(LiveReportTest, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("occupied", "") + "/delays.csv";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteDelays({}, path); }), {path.c_str()});
}

}  // namespace
}  // namespace semantic_slam
