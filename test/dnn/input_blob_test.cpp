#include "semantic_slam/dnn/input_blob.h"

#include <gtest/gtest.h>
#include <opencv2/dnn/dnn.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

NetworkInput InputOf(int width, int height, FitMode fit) {
  NetworkInput input;
  input.width_px = width;
  input.height_px = height;
  input.fit = fit;
  return input;
}

cv::Mat Noise(cv::Size size) {
  cv::Mat image(size, CV_8UC3);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

float At(const cv::Mat& blob, int channel, int v, int u) {
  return blob.ptr<float>(0, channel, v)[u];
}

TEST(InputBlobTest, ScalesThenSubtractsThenDividesPerChannel) {
  NetworkInput input = InputOf(2, 1, FitMode::kStretch);
  input.scale = 0.5;
  input.mean = {1.0, 2.0, 3.0};
  input.std = {2.0, 4.0, 8.0};
  const cv::Mat image(1, 2, CV_8UC3, cv::Scalar(10, 20, 30));
  const cv::Mat blob = InputBlob(input).Make(image, ColourOrder::kRgb).clone();
  EXPECT_EQ(blob.dims, 4);
  EXPECT_FLOAT_EQ(At(blob, 0, 0, 1), (5.0f - 1.0f) / 2.0f);
  EXPECT_FLOAT_EQ(At(blob, 1, 0, 1), (10.0f - 2.0f) / 4.0f);
  EXPECT_FLOAT_EQ(At(blob, 2, 0, 1), (15.0f - 3.0f) / 8.0f);
}

TEST(InputBlobTest, OrdersTheChannelsAsTheNetworkWants) {
  NetworkInput input = InputOf(1, 1, FitMode::kStretch);
  const cv::Mat image(1, 1, CV_8UC3, cv::Scalar(10, 20, 30));
  input.colour = ColourOrder::kRgb;
  EXPECT_EQ(At(InputBlob(input).Make(image, ColourOrder::kRgb), 0, 0, 0), 10.0f);
  EXPECT_EQ(At(InputBlob(input).Make(image, ColourOrder::kBgr), 0, 0, 0), 30.0f);
  input.colour = ColourOrder::kBgr;
  EXPECT_EQ(At(InputBlob(input).Make(image, ColourOrder::kBgr), 0, 0, 0), 10.0f);
  EXPECT_EQ(At(InputBlob(input).Make(image, ColourOrder::kRgb), 2, 0, 0), 10.0f);
}

TEST(InputBlobTest, AgreesWithOpenCvWhereThatCanDoTheSame) {
  NetworkInput input = InputOf(48, 32, FitMode::kStretch);
  input.scale = 1.0 / 255.0;
  const cv::Mat image = Noise({100, 77});
  const cv::Mat ours = InputBlob(input).Make(image, ColourOrder::kBgr).clone();
  const cv::Mat theirs =
      cv::dnn::blobFromImage(image, 1.0 / 255.0, input.size(), cv::Scalar(), true);
  // They scale in single precision; grey levels up to 1 then differ in the last bits.
  EXPECT_LT(cv::norm(ours.reshape(1, 1), theirs.reshape(1, 1), cv::NORM_INF), 1e-6);
}

TEST(InputBlobTest, PadsAroundALetterboxedImage) {
  NetworkInput input = InputOf(8, 8, FitMode::kLetterbox);
  input.pad = 114;
  InputBlob maker(input);
  const cv::Mat wide(4, 8, CV_8UC3, cv::Scalar::all(200));
  const cv::Mat tall(8, 4, CV_8UC3, cv::Scalar::all(200));
  // Twice by turns: nothing of the image before remains in the padding.
  for (int i = 0; i < 2; ++i) {
    const cv::Mat& blob = maker.Make(wide, ColourOrder::kRgb);
    EXPECT_EQ(At(blob, 1, 1, 0), 114.0f);
    EXPECT_EQ(At(blob, 1, 2, 0), 200.0f);
    EXPECT_EQ(At(blob, 1, 5, 7), 200.0f);
    EXPECT_EQ(At(blob, 1, 6, 7), 114.0f);
    maker.Make(tall, ColourOrder::kRgb);
    EXPECT_EQ(At(blob, 1, 0, 1), 114.0f);
    EXPECT_EQ(At(blob, 1, 0, 2), 200.0f);
  }
}

TEST(InputBlobTest, RefusesWhatIsNoColourImage) {
  InputBlob maker(InputOf(8, 8, FitMode::kStretch));
  EXPECT_EQ(MessageOf<InputError>([&] { maker.Make(cv::Mat(), ColourOrder::kRgb); }),
            "network input: the image is CV_8UC1 of 0 x 0 px, expected CV_8UC3 with pixels");
  EXPECT_EQ(MessageOf<InputError>([&] { maker.Make(cv::Mat(2, 3, CV_16UC1), ColourOrder::kRgb); }),
            "network input: the image is CV_16UC1 of 3 x 2 px, expected CV_8UC3 with pixels");
}

}  // namespace
}  // namespace semantic_slam
