#include "semantic_slam_ros/shared_pixels.h"

#include <vector>

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>
#include <boost/weak_ptr.hpp>

namespace semantic_slam_ros {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(SharedPixelsTest, LooksAtTheOwnersMemory) {
  const auto owner = boost::make_shared<const Bytes>(Bytes{1, 2, 0, 3, 4, 0});
  const cv::Mat image = SharePixels(owner, owner->data(), 2, 2, CV_8UC1, 3);
  EXPECT_EQ(image.data, owner->data());
  EXPECT_EQ(image.at<std::uint8_t>(0, 1), 2);
  EXPECT_EQ(image.at<std::uint8_t>(1, 0), 3);
}

TEST(SharedPixelsTest, LastImageLetsGoOfTheOwner) {
  auto owner = boost::make_shared<const Bytes>(Bytes(12, 7));
  const boost::weak_ptr<const Bytes> watched(owner);
  cv::Mat image = SharePixels(owner, owner->data(), 2, 2, CV_8UC3, 6);
  owner.reset();
  cv::Mat part = image(cv::Rect(1, 1, 1, 1));
  image.release();
  EXPECT_FALSE(watched.expired());
  EXPECT_EQ(part.at<cv::Vec3b>(0, 0)[2], 7);
  part.release();
  EXPECT_TRUE(watched.expired());
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
