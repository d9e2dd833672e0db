#include "semantic_slam/dataset/image_decoding.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::vector<std::uint8_t> Encoded(const std::string& extension) {
  cv::Mat image(48, 64, CV_8UC3);
  cv::randu(image, 0, 255);
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, image, bytes);
  return bytes;
}

class ImageDecodingTest : public testing::TestWithParam<const char*> {};

TEST_P(ImageDecodingTest, DecodesAWholeImage) {
  const auto bytes = Encoded(GetParam());
  const cv::Mat image = DecodeImage(bytes.data(), bytes.size(), cv::IMREAD_COLOR);
  EXPECT_EQ(image.size(), cv::Size(64, 48));
  EXPECT_EQ(image.type(), CV_8UC3);
}

TEST_P(ImageDecodingTest, RefusesATruncatedImage) {
  const auto bytes = Encoded(GetParam());
  for (const double share : {0.0, 0.1, 0.5, 0.99}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    EXPECT_TRUE(DecodeImage(bytes.data(), size, cv::IMREAD_COLOR).empty()) << share;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, ImageDecodingTest, testing::Values(".png", ".jpg"));

TEST(ImageDecodingTest, RefusesWhatIsNoImage) {
  const std::vector<std::uint8_t> noise(1000, 'x');
  EXPECT_TRUE(DecodeImage(noise.data(), noise.size(), cv::IMREAD_COLOR).empty());
  EXPECT_TRUE(DecodeImage(nullptr, 0, cv::IMREAD_UNCHANGED).empty());
}

TEST(ReadFileBytesTest, ReadsAFileAndNamesOneThatIsNot) {
  const TemporaryFolder folder;
  EXPECT_EQ(ReadFileBytes(folder.Write("empty", "")).size(), 0u);
  EXPECT_EQ(ReadFileBytes(folder.Write("two", "ab")).size(), 2u);
  for (const std::string& path : {folder / "missing", folder.path()}) {
    EXPECT_EQ(MessageOf<InputError>([&] { ReadFileBytes(path); }), "no such file: " + path);
  }
}

}  // namespace
}  // namespace semantic_slam
