#include "semantic_slam/evaluation/trajectory.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr char kExpected[] = "expected 8: stamp tx ty tz qx qy qz qw";

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class TrajectoryTest : public testing::Test {
 protected:
  Trajectory Read(const std::string& content) {
    return ReadTumTrajectory(folder_.Write("poses.txt", content));
  }

  // What is wrong with the third line, where `line` stands after a comment and a good pose.
  std::string ErrorOf(const std::string& line) {
    const std::string content = "# stamp tx ty tz qx qy qz qw\n1 0 0 0 0 0 0 1\n" + line + "\n";
    const std::string message = MessageOf<InputError>([&] { Read(content); });
    const std::string place = folder_ / "poses.txt:3: ";
    if (message.compare(0, place.size(), place) != 0) return "not about line 3: " + message;
    return message.substr(place.size());
  }

  TemporaryFolder folder_;
};

TEST_F(TrajectoryTest, ReadsStampPositionAndOrientation) {
  const auto poses = Read("1305031453.359684 1.5 -2 0.25 0 0 0.6 0.8\n");
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].stamp.ns, 1305031453359684000);
  EXPECT_EQ(poses[0].pose.translation(), Eigen::Vector3d(1.5, -2.0, 0.25));
  // A turn about z by 2 atan(0.6 / 0.8) takes x to (0.28, 0.96). Only rounding is between.
  EXPECT_TRUE(poses[0].pose.linear().col(0).isApprox(Eigen::Vector3d(0.28, 0.96, 0.0), 1e-14));
}

TEST_F(TrajectoryTest, TakesCommentsCommasTabsBlankLinesAndAnyLineEnd) {
  const auto poses = Read(
      "# comment, 1 2 3\n\n  \t\r\n1,0,0,0,0,0,0,1\r\n\t2 0 0\t0 0 0 0 1 # the second\n"
      "  # indented\n3, 0, 0, 0, 0, 0, 0, 1");
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_EQ(poses[0].stamp.ns, 1'000'000'000);
  EXPECT_EQ(poses[1].stamp.ns, 2'000'000'000);
  EXPECT_EQ(poses[2].stamp.ns, 3'000'000'000);
}

TEST_F(TrajectoryTest, SortsByStampAndKeepsTheOrderOfEqualOnes) {
  const auto poses =
      Read("3 1 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n2 4 0 0 0 0 0 1\n3 5 0 0 0 0 0 1\n");
  std::vector<double> x;
  for (const StampedPose& stamped : poses) x.push_back(stamped.pose.translation().x());
  EXPECT_EQ(x, (std::vector<double>{2.0, 4.0, 1.0, 3.0, 5.0}));
}

TEST_F(TrajectoryTest, ReadsStampsAsOtherToolsWriteThem) {
  const auto poses = Read(
      "-0.5 0 0 0 0 0 0 1\n1.25e0 0 0 0 0 0 0 1\n2.0000000004 0 0 0 0 0 0 1\n"
      "1.305031453e+09 0 0 0 0 0 0 1\n");
  ASSERT_EQ(poses.size(), 4u);
  EXPECT_EQ(poses[0].stamp.ns, -500'000'000);
  EXPECT_EQ(poses[1].stamp.ns, 1'250'000'000);
  EXPECT_EQ(poses[2].stamp.ns, 2'000'000'000);  // rounded to a nanosecond
  EXPECT_EQ(poses[3].stamp.ns, 1'305'031'453'000'000'000);
}

TEST_F(TrajectoryTest, TakesQuaternionsOfAnyLength) {
  for (const char* length : {"1", "0.001", "1000", "-1"}) {
    const auto poses = Read(std::string("1 0 0 0 ") + length + " 0 0 0\n");  // half a turn about x
    EXPECT_TRUE(poses[0].pose.linear().isApprox(
        Eigen::Matrix3d(Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal()), 1e-14))
        << length;
  }
}

TEST_F(TrajectoryTest, NamesFileAndLineOfALineThatIsNoPose) {
  EXPECT_EQ(ErrorOf("garbage"), std::string("found 1 values, ") + kExpected);
  EXPECT_EQ(ErrorOf("2 0 0 0 0 0 1"), std::string("found 7 values, ") + kExpected);
  EXPECT_EQ(ErrorOf("2 0 0 0 0 0 0 1 5"), std::string("found 9 values, ") + kExpected);
  EXPECT_EQ(ErrorOf("2 0 0 0 0 # 0 0 1"), std::string("found 5 values, ") + kExpected);
}

TEST_F(TrajectoryTest, NamesTheValueThatIsNoNumber) {
  EXPECT_EQ(ErrorOf("now 0 0 0 0 0 0 1"), "stamp = now, expected seconds");
  EXPECT_EQ(ErrorOf("nan 0 0 0 0 0 0 1"), "stamp = nan, expected seconds");
  EXPECT_EQ(ErrorOf("1e300 0 0 0 0 0 0 1"), "stamp = 1e300, expected seconds");
  EXPECT_EQ(ErrorOf("2 nan 0 0 0 0 0 1"), "tx = nan, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(ErrorOf("2 0 -inf 0 0 0 0 1"), "ty = -inf, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(ErrorOf("2 0 0 1.5m 0 0 0 1"), "tz = 1.5m, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(ErrorOf("2 0 0 0 0x1 0 0 1"), "qx = 0x1, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(ErrorOf("2 0 0 0 0 0 0 NaN"), "qw = NaN, expected a number in [-1e9, 1e9]");
}

// Their squares would overflow; nothing we measure is a million kilometres away.
TEST_F(TrajectoryTest, RefusesNumbersThatCannotBeMeant) {
  EXPECT_EQ(ErrorOf("2 1e17 0 0 0 0 0 1"), "tx = 1e17, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(ErrorOf("2 0 0 0 1e200 0 0 0"), "qx = 1e200, expected a number in [-1e9, 1e9]");
  EXPECT_EQ(Read("2 1e9 -1e9 0 0 0 0 1\n").size(), 1u);
}

TEST_F(TrajectoryTest, RefusesAQuaternionWithoutDirection) {
  EXPECT_EQ(ErrorOf("2 0 0 0 0 0 0 0"), "quaternion of zero length, expected length 1");
  EXPECT_EQ(ErrorOf("2 0 0 0 1e-9 0 0 0"), "quaternion of zero length, expected length 1");
}

TEST_F(TrajectoryTest, QuotesOnlyTheStartOfALongValue) {
  EXPECT_LT(ErrorOf("2 0 0 0 0 0 0 " + std::string(100'000, '1')).size(), 200u);
}

TEST_F(TrajectoryTest, RefusesAFileWithoutAPose) {
  for (const char* content : {"", "\n\n", "# stamp tx ty tz qx qy qz qw\n"}) {
    EXPECT_EQ(
        MessageOf<InputError>([&] { Read(content); }),
        (folder_ / "poses.txt") + ": no pose in it, expected lines of stamp tx ty tz qx qy qz qw");
  }
}

TEST_F(TrajectoryTest, NamesAFileThatIsMissingOrAFolder) {
  EXPECT_EQ(MessageOf<InputError>([&] { ReadTumTrajectory(folder_ / "no.txt"); }),
            "cannot open trajectory " + (folder_ / "no.txt"));
  EXPECT_EQ(MessageOf<InputError>([&] { ReadTumTrajectory(folder_.path()); }),
            "cannot read trajectory " + folder_.path());
}

TEST_F(TrajectoryTest, WritesNineDecimalsAndAPositiveQw) {
  Rigid3d pose = Rigid3d::Identity();
  pose.translation() << 1.0, -0.25, 1.0 / 3.0;
  // 240 degrees about the space diagonal; the quaternion is this or the negative of it.
  pose.rotate(Eigen::Quaterniond(-0.5, 0.5, 0.5, 0.5));
  const std::string path = folder_ / "new/poses.txt";
  WriteTumTrajectory({{Stamp{1305031453359684000}, pose}, {Stamp{1305031453359684001}, pose}},
                     path);
  const std::string expected =
      " 1.000000000 -0.250000000 0.333333333 -0.500000000 -0.500000000 -0.500000000 0.500000000\n";
  EXPECT_EQ(Content(path), "# stamp tx ty tz qx qy qz qw\n1305031453.359684" + expected +
                               "1305031453.359684001" + expected);
}

TEST_F(TrajectoryTest, ReadsBackWhatItWrites) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Trajectory written;
  for (int i = 0; i < 100; ++i) {
    StampedPose stamped{Stamp{1305031453000000000 + 33'333'333 * static_cast<std::int64_t>(i)},
                        Rigid3d::Identity()};
    stamped.pose.translation() << 10.0 * uniform(random), 10.0 * uniform(random), uniform(random);
    stamped.pose.linear() =
        ExpSo3(M_PI * Eigen::Vector3d(uniform(random), uniform(random), uniform(random)));
    written.push_back(stamped);
  }
  const std::string path = folder_ / "poses.txt";
  WriteTumTrajectory(written, path);
  const Trajectory read = ReadTumTrajectory(path);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].stamp.ns, written[i].stamp.ns);
    // Nine decimals: half of 1e-9 per number, a few of which make an element of the matrix.
    EXPECT_LT((read[i].pose.matrix() - written[i].pose.matrix()).cwiseAbs().maxCoeff(), 3e-9);
  }
}

// An estimate that diverged must still make lines of eight values.
TEST_F(TrajectoryTest, WritesHugePositionsInFull) {
  Rigid3d pose = Rigid3d::Identity();
  pose.translation().setConstant(-std::numeric_limits<double>::max());
  const std::string path = folder_ / "poses.txt";
  WriteTumTrajectory({{Stamp{0}, pose}}, path);
  const std::string content = Content(path);
  EXPECT_EQ(content.substr(content.size() - 13), " 1.000000000\n");
}

TEST_F(TrajectoryTest, NamesAPathThatCannotBeWritten) {
  folder_.Write("file", "not a folder");
  const std::string path = folder_ / "file/poses.txt";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteTumTrajectory({}, path); }),
                    {"cannot write", path.c_str()});
}

}  // namespace
}  // namespace semantic_slam
