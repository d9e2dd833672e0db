#include "semantic_slam_ros/tum_bag.h"

#include <filesystem>
#include <iterator>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam_ros/bag_source.h"
#include "testing/expect_error.h"
#include "testing/room_sequence.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"

namespace semantic_slam_ros {
namespace {

namespace fs = std::filesystem;
using semantic_slam::ExpectOneLineWith;
using semantic_slam::InputError;
using semantic_slam::MessageOf;
using semantic_slam::RgbdSource;
using semantic_slam::TemporaryFolder;
using semantic_slam::TumFolder;

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  const cv::Mat differ = (a != b) & ((a == a) | (b == b));  // NaN is as good as NaN
  return a.size() == b.size() && a.type() == b.type() && cv::countNonZero(differ.reshape(1)) == 0;
}

void ExpectSameImages(RgbdSource& expected, RgbdSource& bag) {
  while (const auto image = expected.Next()) {
    const auto from_bag = bag.Next();
    ASSERT_TRUE(from_bag);
    ASSERT_EQ(from_bag->stamp, image->stamp);
    ASSERT_EQ(from_bag->depth_stamp, image->depth_stamp);
    EXPECT_EQ(from_bag->order, semantic_slam::ColourOrder::kRgb);
    const cv::Vec3b bgr = image->colour.at<cv::Vec3b>(100, 200);
    EXPECT_EQ(from_bag->colour.at<cv::Vec3b>(100, 200), cv::Vec3b(bgr[2], bgr[1], bgr[0]));
    EXPECT_TRUE(SamePixels(from_bag->depth_m, image->depth_m));
  }
  EXPECT_FALSE(bag.Next());
}

class TumBagTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    semantic_slam::WriteRoomSequence(folder_->path() + "/room", 0.5);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  TumBagTest() { options_.camera = semantic_slam::Freiburg1Camera(); }

  static std::string Room() { return *folder_ / "room"; }
  static std::string BagPath() { return *folder_ / "room.bag"; }

  static std::unique_ptr<TemporaryFolder> folder_;
  TumBagOptions options_;
};
std::unique_ptr<TemporaryFolder> TumBagTest::folder_;

TEST_F(TumBagTest, TheBagReadsLikeTheFolder) {
  const TumBagReport report = WriteTumBag(Room(), BagPath(), options_);
  EXPECT_EQ(report.colour, 15u);
  EXPECT_EQ(report.depth, 15u);
  EXPECT_EQ(report.dropped, 0u);
  TumFolder folder(Room(), options_.camera);
  BagSource bag(BagPath());
  EXPECT_EQ(bag.size(), folder.size());
  EXPECT_TRUE(bag.Intrinsics() == options_.camera.intrinsics);
  ASSERT_EQ(bag.accelerometer().size(), folder.accelerometer().size());
  EXPECT_EQ(bag.accelerometer()[7].acceleration_imu, folder.accelerometer()[7].acceleration_imu);
  EXPECT_TRUE(bag.R_camera_imu()->isApprox(options_.camera.R_camera_imu, 1e-9));
  ExpectSameImages(folder, bag);
}

TEST_F(TumBagTest, TheTransformsComposeToTheGroundTruth) {
  WriteTumBag(Room(), BagPath(), options_);
  const auto expected = semantic_slam::ReadTumTrajectory(Room() + "/groundtruth.txt");
  const BagSource bag(BagPath());
  ASSERT_EQ(bag.ground_truth().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(bag.ground_truth()[i].stamp, expected[i].stamp);
    // Rounding of six products of rotations.
    EXPECT_TRUE(bag.ground_truth()[i].pose.isApprox(expected[i].pose, 1e-12));
  }
}

TEST_F(TumBagTest, WithoutGroundTruthTheCameraAndTheImuAreStillJoined) {
  const std::string copy = *folder_ / "without";
  fs::copy(Room(), copy, fs::copy_options::recursive);
  fs::remove(copy + "/groundtruth.txt");
  WriteTumBag(copy, BagPath(), options_);
  const BagSource bag(BagPath());
  EXPECT_TRUE(bag.ground_truth().empty());
  EXPECT_TRUE(bag.R_camera_imu());
}

TEST_F(TumBagTest, HasThePublishedTopicsAndIsInOrderOfTime) {
  WriteTumBag(Room(), BagPath(), options_);
  const rosbag::Bag bag(BagPath());
  std::set<std::string> topics;
  ros::Time before;
  rosbag::View view(bag);
  for (const rosbag::MessageInstance& message : view) {
    EXPECT_GE(message.getTime(), before);
    before = message.getTime();
    topics.insert(message.getTopic());
  }
  EXPECT_EQ(topics, (std::set<std::string>{"/camera/depth/camera_info", "/camera/depth/image",
                                           "/camera/rgb/camera_info", "/camera/rgb/image_color",
                                           "/imu", "/tf"}));
}

TEST_F(TumBagTest, WritesThePartAskedFor) {
  options_.start_s = 0.1;
  options_.duration_s = 0.2;
  std::size_t calls = 0, all = 0;
  const TumBagReport report =
      WriteTumBag(Room(), BagPath(), options_, [&](std::size_t done, std::size_t of) {
        EXPECT_EQ(done, ++calls);
        all = of;
      });
  EXPECT_EQ(calls, all);
  EXPECT_EQ(report.colour, 7u);  // 0.1 to 0.3 s at 30 images/s, ends included
  EXPECT_EQ(report.poses, 15u);  // a second around it is more than there is
}

TEST_F(TumBagTest, LeavesOutAndReportsUnreadableImages) {
  const std::string copy = *folder_ / "damaged";
  fs::copy(Room(), copy, fs::copy_options::recursive);
  fs::resize_file(fs::directory_iterator(copy + "/depth")->path(), 100);
  fs::remove(fs::directory_iterator(copy + "/rgb")->path());
  const TumBagReport report = WriteTumBag(copy, BagPath(), options_);
  EXPECT_EQ(report.colour, 14u);
  EXPECT_EQ(report.depth, 14u);
  EXPECT_EQ(report.dropped, 2u);
  EXPECT_EQ(report.problems.size(), 2u);
}

TEST_F(TumBagTest, RefusesAFolderOfWhichNoImageCanBeRead) {
  options_.camera.intrinsics.width_px = 320;
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteTumBag(Room(), BagPath(), options_); }),
                    {"no image could be read", "expected [320 x 480]"});
}

TEST_F(TumBagTest, LeavesNothingBehindWhenItFails) {
  const TemporaryFolder empty;
  const std::string bag = empty / "out/test.bag";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteTumBag("/nowhere", bag, options_); }),
                    {"no such folder: /nowhere"});
  options_.start_s = 100.0;
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteTumBag(Room(), bag, options_); }),
                    {"no images"});
  options_.start_s = 0.0;
  EXPECT_THROW(WriteTumBag(Room(), bag, options_,
                           [](std::size_t done, std::size_t) {
                             if (done == 10) throw std::runtime_error("interrupted");
                           }),
               std::runtime_error);
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(empty.path()), {}), 1);  // "out"
  const std::string unwritable = empty.Write("file", "") + "/below.bag";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteTumBag(Room(), unwritable, options_); }),
                    {"cannot write", "below.bag"});
}

TEST(TumBagOnRealDataTest, Freiburg1DeskGivesTheSame573Pairs) {
  const auto path = semantic_slam::SharedData(semantic_slam::kFreiburg1Desk);
  SEMANTIC_SLAM_SKIP_WITHOUT(path, semantic_slam::kFreiburg1Desk);
  const TemporaryFolder folder;
  TumBagOptions options;
  options.camera = semantic_slam::LoadCameraConfig(std::string(SEMANTIC_SLAM_SOURCE_DIR) +
                                                   "/config/tum_freiburg1.yaml");
  const TumBagReport report = WriteTumBag(*path, folder / "desk.bag", options);
  EXPECT_EQ(report.colour, 613u);
  EXPECT_EQ(report.depth, 595u);
  EXPECT_EQ(report.poses, 2335u);
  BagSource bag(folder / "desk.bag");
  EXPECT_EQ(bag.ground_truth().size(), 2335u);
  const TumFolder tum(*path, options.camera);
  std::size_t pairs = 0;
  while (bag.Next()) ++pairs;
  EXPECT_EQ(pairs, 573u);
  EXPECT_EQ(pairs, tum.size());
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
