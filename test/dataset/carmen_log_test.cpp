#include "semantic_slam/dataset/carmen_log.h"

#include <fstream>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr char kLine[] = "FLASER 3 1.5 81.91 2 9 9 9 1 2 0.5 1216.630413 nohost 0.1\n";

class CarmenLogTest : public testing::Test {
 protected:
  std::string Write(const std::string& text) const {
    const std::string path = folder_ / "laser.log";
    std::ofstream(path) << text;
    return path;
  }
  std::string ErrorOf(const std::string& text) const {
    const std::string path = Write(text);
    return MessageOf<InputError>([&] { ReadCarmenLog(path); });
  }

  const TemporaryFolder folder_;
};

TEST_F(CarmenLogTest, ReadsRangesOdometryAndStamp) {
  const auto readings = ReadCarmenLog(Write(std::string("# a comment\nODOM 1 2 3\n") + kLine));
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].ranges_m, (std::vector<float>{1.5f, 81.91f, 2.0f}));
  EXPECT_TRUE(readings[0].T_odom_robot.isApprox(MakeRigid2d({1.0, 2.0}, 0.5), 1e-12));
  EXPECT_EQ(readings[0].stamp.ns, 1'216'630'413'000);
}

TEST_F(CarmenLogTest, NamesALineThatIsCutOrBroken) {
  for (const char* broken :
       {"FLASER\n", "FLASER 3 1.5 81.91\n", "FLASER 3 1 2 3 9 9 9 1 2 nan 5.0 h 1\n",
        "FLASER -1 1 2 3\n", "FLASER 999999999 1\n", "FLASER 1 2 9 9 9 1 2 3 soon h 1\n"}) {
    ExpectOneLineWith(ErrorOf(kLine + std::string(broken)), {"laser.log:2", "FLASER"});
  }
}

TEST_F(CarmenLogTest, RefusesAFileWithoutReadings) {
  ExpectOneLineWith(ErrorOf("ODOM 1 2 3\n"), {"laser.log", "no FLASER line"});
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadCarmenLog(folder_ / "missing.log"); }),
                    {"cannot open", "missing.log"});
}

TEST_F(CarmenLogTest, ReadsARecordedLog) {
  const auto path = SharedData("data/laser2d/fr079/fr079_noisy_odometry.log");
  SEMANTIC_SLAM_SKIP_WITHOUT(path, "the laser log fr079");
  const auto readings = ReadCarmenLog(*path);
  EXPECT_EQ(readings.size(), 4791u);
  EXPECT_EQ(readings.front().ranges_m.size(), 360u);
}

}  // namespace
}  // namespace semantic_slam
