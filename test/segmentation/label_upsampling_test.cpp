#include "semantic_slam/segmentation/label_upsampling.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr FitMode kModes[] = {FitMode::kLetterbox, FitMode::kStretch};

LabelProbabilities Empty(cv::Size cells, const std::vector<LabelId>& labels) {
  LabelProbabilities probabilities;
  probabilities.labels = labels;
  probabilities.width = cells.width;
  probabilities.height = cells.height;
  probabilities.values.assign(cells.area() * labels.size(), 0.0f);
  return probabilities;
}

// Peaked, as networks are: in each cell most labels next to nothing, neighbours alike.
LabelProbabilities Peaked(cv::Size cells, int label_count, int seed) {
  std::vector<LabelId> labels;
  for (int i = 0; i < label_count; ++i) labels.push_back(static_cast<LabelId>(3 * i));
  LabelProbabilities probabilities = Empty(cells, labels);
  cv::RNG random(seed);
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      float* cell = &probabilities.values[(y * cells.width + x) * label_count];
      float sum = 0.0f;
      for (int i = 0; i < label_count; ++i) {
        const double wave = 6.0 * std::sin(0.7 * x + 1.9 * i) * std::cos(0.5 * y + 0.8 * i);
        sum += cell[i] = static_cast<float>(std::exp(wave + random.uniform(-1.0, 1.0)));
      }
      for (int i = 0; i < label_count; ++i) cell[i] /= sum;
    }
  }
  return probabilities;
}

// The same by definition: every label of every pixel, in double precision.
class NaiveUpsampler {
 public:
  NaiveUpsampler(const LabelProbabilities& probabilities, const ImageFit& fit, cv::Size image,
                 cv::Size input)
      : probabilities_(probabilities), content_(fit.content()), image_(image), input_(input) {}

  std::vector<double> At(int u, int v) const {
    const auto [x0, x1, wx] =
        Between(u, image_.width, content_.x, content_.width, input_.width, probabilities_.width);
    const auto [y0, y1, wy] = Between(v, image_.height, content_.y, content_.height, input_.height,
                                      probabilities_.height);
    std::vector<double> values;
    for (std::size_t i = 0; i < probabilities_.labels.size(); ++i) {
      const double top =
          (1 - wx) * probabilities_.Cell(x0, y0)[i] + wx * probabilities_.Cell(x1, y0)[i];
      const double low =
          (1 - wx) * probabilities_.Cell(x0, y1)[i] + wx * probabilities_.Cell(x1, y1)[i];
      values.push_back((1 - wy) * top + wy * low);
    }
    return values;
  }

 private:
  struct Place {
    int first, second;
    double weight;
  };
  static Place Between(int pixel, int pixels, int begin, int size, int input, int cells) {
    // Pixel to input to cell, always by way of centres; cells outside the content have no say.
    const double in_input = begin + (pixel + 0.5) * size / pixels;
    int lowest = cells, highest = -1;
    for (int cell = 0; cell < cells; ++cell) {
      const double centre = (cell + 0.5) * input / cells;
      if (centre < begin || centre > begin + size) continue;
      lowest = std::min(lowest, cell);
      highest = std::max(highest, cell);
    }
    const double at = std::clamp(in_input * cells / input - 0.5, static_cast<double>(lowest),
                                 static_cast<double>(highest));
    const int first = std::min(static_cast<int>(std::floor(at)), highest);
    return {first, std::min(first + 1, highest), at - first};
  }

  const LabelProbabilities& probabilities_;
  const cv::Rect content_;
  const cv::Size image_, input_;
};

// Every pixel's labels must be the naive ones, except where rounding may decide between two.
void ExpectAgreement(const LabelProbabilities& probabilities, FitMode mode, cv::Size image,
                     cv::Size input) {
  constexpr double kRounding = 1e-5;  // single precision, a few operations on values up to 1
  const ImageFit fit(image, input, mode);
  Segmentation found;
  LabelUpsampler(fit, image, input, {probabilities.width, probabilities.height})
      .Upsample(probabilities, found);
  ASSERT_EQ(found.size(), image);
  const NaiveUpsampler naive(probabilities, fit, image, input);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      std::vector<double> expected = naive.At(u, v);
      const std::vector<double> by_label = expected;
      std::sort(expected.begin(), expected.end(), std::greater<double>());
      for (int place = 0; place < kTopLabels; ++place) {
        const auto at = std::find(probabilities.labels.begin(), probabilities.labels.end(),
                                  found.labels[place].at<LabelId>(v, u));
        ASSERT_NE(at, probabilities.labels.end());
        const double value = by_label[at - probabilities.labels.begin()];
        ASSERT_NEAR(value, expected[place], kRounding) << u << ", " << v << ", place " << place;
        ASSERT_NEAR(found.confidences[place].at<std::uint8_t>(v, u), std::floor(255.0 * value),
                    1.0);
      }
    }
  }
}

TEST(LabelUpsamplerTest, AgreesWithTheDefinition) {
  for (const FitMode mode : kModes) {
    ExpectAgreement(Peaked({16, 12}, 9, 1), mode, {64, 48}, {64, 48});   // a stride of 4
    ExpectAgreement(Peaked({16, 12}, 9, 2), mode, {90, 30}, {64, 48});   // another shape
    ExpectAgreement(Peaked({16, 12}, 32, 3), mode, {33, 71}, {64, 48});  // odd sizes
    ExpectAgreement(Peaked({64, 48}, 5, 4), mode, {64, 48}, {64, 48});   // nothing to interpolate
    ExpectAgreement(Peaked({64, 48}, 5, 5), mode, {20, 10}, {64, 48});   // fewer pixels than cells
    ExpectAgreement(Peaked({1, 1}, 3, 6), mode, {5, 4}, {64, 48});
  }
}

TEST(LabelUpsamplerTest, OfEquallyProbableLabelsTheLowestIdsComeFirst) {
  LabelProbabilities probabilities = Empty({2, 2}, {4, 7, 9, 20, 31});
  std::fill(probabilities.values.begin(), probabilities.values.end(), 0.2f);
  Segmentation found;
  LabelUpsampler(ImageFit({8, 8}, {8, 8}, FitMode::kStretch), {8, 8}, {8, 8}, {2, 2})
      .Upsample(probabilities, found);
  const int expected[] = {4, 7, 9};
  for (int place = 0; place < kTopLabels; ++place) {
    EXPECT_EQ(cv::countNonZero(found.labels[place] != expected[place]), 0);
    EXPECT_EQ(cv::countNonZero(found.confidences[place] != 51), 0);
  }
}

TEST(LabelUpsamplerTest, ThePaddingOfALetterboxHasNoSay) {
  // An image of 8 x 4 in an input of 8 x 8: rows 0, 1, 6 and 7 of the input are padding.
  LabelProbabilities probabilities = Empty({8, 8}, {0, 1, 2});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      probabilities.values[(y * 8 + x) * 3 + (y < 2 || y > 5 ? 1 : 2)] = 1.0f;
    }
  }
  Segmentation found;
  LabelUpsampler(ImageFit({16, 8}, {8, 8}, FitMode::kLetterbox), {16, 8}, {8, 8}, {8, 8})
      .Upsample(probabilities, found);
  EXPECT_EQ(cv::countNonZero(found.labels[0] != 2), 0);
  EXPECT_EQ(cv::countNonZero(found.confidences[0] != 255), 0);
}

TEST(LabelUpsamplerTest, AnEdgeBetweenTwoCellsLiesHalfWay) {
  // Two cells over 8 pixels: the edge is between pixels 3 and 4.
  LabelProbabilities probabilities = Empty({2, 1}, {1, 2, 3});
  probabilities.values = {1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f};
  Segmentation found;
  LabelUpsampler(ImageFit({8, 1}, {8, 1}, FitMode::kStretch), {8, 1}, {8, 1}, {2, 1})
      .Upsample(probabilities, found);
  for (int u = 0; u < 8; ++u) EXPECT_EQ(found.labels[0].at<LabelId>(0, u), u < 4 ? 1 : 2) << u;
  // Centres of cells are at 1.5 and 5.5: pixel 3 is 3/8 of the way.
  EXPECT_EQ(found.confidences[0].at<std::uint8_t>(0, 3), static_cast<int>(255 * 0.625));
  EXPECT_EQ(found.labels[1].at<LabelId>(0, 3), 2);
  EXPECT_EQ(found.confidences[1].at<std::uint8_t>(0, 3), static_cast<int>(255 * 0.375));
  EXPECT_EQ(found.confidences[0].at<std::uint8_t>(0, 0), 255);
}

}  // namespace
}  // namespace semantic_slam
