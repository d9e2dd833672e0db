#include "semantic_slam/dataset/tum_folder.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr int kWidth = 16, kHeight = 12;

CameraConfig SmallCamera() {
  CameraConfig camera;
  camera.intrinsics = {kWidth, kHeight, 20.0, 20.0, 8.0, 6.0, {}};
  return camera;
}

// Three pairs at 0.0, 0.1 and 0.2 s, depth 5 ms later, as a folder that tests then damage.
class TumFolderTest : public testing::Test {
 protected:
  TumFolderTest() {
    std::string colour_list, depth_list;
    for (int i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i);
      colour_list += "0." + n + " rgb/" + n + ".png\n";
      depth_list += "0." + n + "05 depth/" + n + ".png\n";
      WriteImage("rgb/" + n + ".png", cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(255, 10, i)));
      WriteImage("depth/" + n + ".png", cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(5000 * i)));
    }
    folder_.Write("rgb.txt", colour_list);
    folder_.Write("depth.txt", depth_list);
  }

  void WriteImage(const std::string& name, const cv::Mat& image) {
    const std::string path = folder_ / name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    cv::imwrite(path, image);
  }

  TumFolder Open() const { return TumFolder(folder_.path(), SmallCamera()); }
  std::string OpenError() const {
    return MessageOf<InputError>([this] { Open(); });
  }

  // Reads to the end and expects the pair in the middle to be left out with this reason.
  void ExpectMiddleDropped(std::initializer_list<const char*> reason) const {
    TumFolder source = Open();
    ASSERT_EQ(source.Next()->stamp, Stamp{0});
    ASSERT_EQ(source.Next()->stamp, Stamp{200'000'000});
    ASSERT_FALSE(source.Next());
    EXPECT_EQ(source.dropped(), 1u);
    ASSERT_EQ(source.problems().size(), 1u);
    ExpectOneLineWith(source.problems()[0], reason);
  }

  const TemporaryFolder folder_;
};

TEST_F(TumFolderTest, ReadsPairsInOrder) {
  TumFolder source = Open();
  EXPECT_EQ(source.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    const auto image = source.Next();
    ASSERT_TRUE(image);
    EXPECT_NO_THROW(CheckRgbdImage(*image));
    EXPECT_EQ(image->stamp.ns, i * 100'000'000);
    EXPECT_EQ(image->depth_stamp.ns, i * 100'000'000 + 5'000'000);
    EXPECT_EQ(image->order, ColourOrder::kBgr);
    EXPECT_EQ(image->colour.at<cv::Vec3b>(0, 0), cv::Vec3b(255, 10, static_cast<uchar>(i)));
  }
  EXPECT_FALSE(source.Next());
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.dropped(), 0u);
  EXPECT_TRUE(source.accelerometer().empty());
  EXPECT_FALSE(source.R_camera_imu());
}

TEST_F(TumFolderTest, DepthIsMetresAndZeroIsNan) {
  TumFolder source = Open();
  EXPECT_TRUE(std::isnan(source.Next()->depth_m.at<float>(0, 0)));
  EXPECT_FLOAT_EQ(source.Next()->depth_m.at<float>(0, 0), 1.0f);
}

TEST_F(TumFolderTest, TheDepthFactorIsTheCameras) {
  CameraConfig camera = SmallCamera();
  camera.depth_png_factor = 1000.0;
  TumFolder source(folder_.path(), camera);
  source.Next();
  EXPECT_FLOAT_EQ(source.Next()->depth_m.at<float>(0, 0), 5.0f);
}

TEST_F(TumFolderTest, ListsNeedNoOrder) {
  folder_.Write("rgb.txt", "0.2 rgb/2.png\n0.0 rgb/0.png\n0.1 rgb/1.png\n");
  TumFolder source = Open();
  EXPECT_EQ(source.Next()->stamp.ns, 0);
  EXPECT_EQ(source.Next()->stamp.ns, 100'000'000);
}

TEST_F(TumFolderTest, ReadsTheAccelerometerWhereThereIsOne) {
  folder_.Write("accelerometer.txt", "0.0 0 0 9.81\n");
  EXPECT_EQ(Open().accelerometer().size(), 1u);
}

TEST_F(TumFolderTest, KnowsAFolderOfItsKind) {
  EXPECT_TRUE(IsTumFolder(folder_.path()));
  EXPECT_FALSE(IsTumFolder(folder_ / "rgb"));
  EXPECT_FALSE(IsTumFolder(folder_ / "nowhere"));
}

TEST_F(TumFolderTest, RefusesAMissingFolderOrList) {
  EXPECT_EQ(MessageOf<InputError>([] { TumFolder("/nowhere", SmallCamera()); }),
            "no such folder: /nowhere");
  std::filesystem::remove(folder_ / "depth.txt");
  EXPECT_EQ(OpenError(), "cannot open " + (folder_ / "depth.txt"));
}

TEST_F(TumFolderTest, RefusesAGarbageLineByFileAndLine) {
  folder_.Write("depth.txt", "0.005 depth/0.png\n\x01\x02 garbage\n");
  ExpectOneLineWith(OpenError(), {"depth.txt:2: expected 'stamp filename'"});
  folder_.Write("depth.txt", "0.005 depth/0.png\n");
  folder_.Write("accelerometer.txt", "0.0 0 0\n");
  ExpectOneLineWith(OpenError(), {"accelerometer.txt:1: expected 'stamp ax ay az'"});
}

TEST_F(TumFolderTest, RefusesListsThatDoNotPair) {
  folder_.Write("depth.txt", "50.0 depth/0.png\n");
  EXPECT_EQ(OpenError(), folder_.path() +
                             ": none of 3 colour and 1 depth images are within 0.02 s of each "
                             "other");
  folder_.Write("depth.txt", "# empty\n");
  EXPECT_NE(OpenError(), "");
}

TEST_F(TumFolderTest, RefusesAnOptionOutOfRange) {
  ImagePairerOptions pairing;
  pairing.max_gap_s = std::nan("");
  EXPECT_THROW(TumFolder(folder_.path(), SmallCamera(), pairing), ConfigError);
}

TEST_F(TumFolderTest, DropsAMissingImage) {
  std::filesystem::remove(folder_ / "rgb/1.png");
  ExpectMiddleDropped({"no such file", "rgb/1.png"});
}

TEST_F(TumFolderTest, DropsAnEmptyImageFile) {
  folder_.Write("depth/1.png", "");
  ExpectMiddleDropped({"cannot decode", "depth/1.png", "0 bytes"});
}

TEST_F(TumFolderTest, DropsATruncatedImage) {
  const auto size = std::filesystem::file_size(folder_ / "rgb/1.png");
  std::filesystem::resize_file(folder_ / "rgb/1.png", size / 2);
  ExpectMiddleDropped({"cannot decode", "rgb/1.png"});
}

TEST_F(TumFolderTest, DropsDepthOfAnotherSize) {
  WriteImage("depth/1.png", cv::Mat(kHeight / 2, kWidth / 2, CV_16UC1, cv::Scalar(1)));
  ExpectMiddleDropped({"depth/1.png is [8 x 6], expected [16 x 12]"});
}

TEST_F(TumFolderTest, DropsColourOfAnotherSizeThanTheCameras) {
  WriteImage("rgb/1.png", cv::Mat(kHeight, 2 * kWidth, CV_8UC3, cv::Scalar::all(1)));
  ExpectMiddleDropped({"rgb/1.png is [32 x 12], expected [16 x 12]"});
}

TEST_F(TumFolderTest, DropsDepthOfAnotherType) {
  WriteImage("depth/1.png", cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(1)));
  ExpectMiddleDropped({"depth/1.png is CV_8UC1, expected a 16-bit depth image"});
}

TEST_F(TumFolderTest, DropsAStampThatAppearsTwice) {
  folder_.Write("rgb.txt", "0.0 rgb/0.png\n0.1 rgb/1.png\n0.1 rgb/2.png\n");
  const TumFolder source = Open();
  EXPECT_EQ(source.size(), 2u);
  EXPECT_EQ(source.dropped(), 1u);
  ExpectOneLineWith(source.problems().at(0), {"rgb.txt:3: stamp 0.100000 appears twice"});
}

TEST_F(TumFolderTest, RemembersOnlyTheFirstFewReasons) {
  std::string colour, depth;
  for (int i = 10; i < 60; ++i) {
    colour += std::to_string(i) + ".0 rgb/missing.png\n";
    depth += std::to_string(i) + ".0 depth/missing.png\n";
  }
  folder_.Write("rgb.txt", colour);
  folder_.Write("depth.txt", depth);
  TumFolder source = Open();
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.dropped(), 50u);
  EXPECT_EQ(source.problems().size(), 5u);
}

TEST(TumFolderOnRealDataTest, Freiburg1DeskHas573Pairs) {
  const auto folder = SharedData(kFreiburg1Desk);
  SEMANTIC_SLAM_SKIP_WITHOUT(folder, kFreiburg1Desk);
  TumFolder source(*folder, LoadCameraConfig(std::string(SEMANTIC_SLAM_SOURCE_DIR) +
                                             "/config/tum_freiburg1.yaml"));
  EXPECT_EQ(source.size(), 573u);
  EXPECT_GT(source.accelerometer().size(), 1000u);
  const auto image = source.Next();
  ASSERT_TRUE(image);
  EXPECT_EQ(ToString(image->stamp), "1305031453.359684");
  EXPECT_EQ(ToString(image->depth_stamp), "1305031453.374112");
  EXPECT_NO_THROW(CheckRgbdImage(*image));
}

}  // namespace
}  // namespace semantic_slam
