#include "semantic_slam/simulation/label_errors.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/random_stream.h"

namespace semantic_slam {
namespace {

constexpr double kMinConfidence = 0.4;      // the first of three must be the greatest
constexpr double kWrongness = 0.75;         // how sure of itself a wrong label is, to a right one
constexpr double kSecondShare = 0.6;        // of what the first label leaves
constexpr double kThirdShare = 0.3;         // likewise; the rest is spread over all other classes
constexpr double kBorderConfidence = 0.55;  // of a label that has spilt over a border
constexpr double kBorderOther = 0.35;       // of the one that is really there
constexpr int kWobbleCellPx = 12;           // borders are displaced alike within about that

// Different things are drawn for different purposes.
enum Purpose : std::uint64_t { kPhase, kError, kWobble };

// Moves by random numbers of deviation 1 that change smoothly over the image.
cv::Mat SmoothNoise(cv::Size size, RandomStream& random) {
  cv::Mat coarse(size.height / kWobbleCellPx + 2, size.width / kWobbleCellPx + 2, CV_32FC2);
  for (int v = 0; v < coarse.rows; ++v) {
    for (int u = 0; u < coarse.cols; ++u) {
      const auto x = static_cast<float>(random.Gaussian());
      coarse.at<cv::Vec2f>(v, u) = {x, static_cast<float>(random.Gaussian())};
    }
  }
  cv::Mat noise;
  cv::resize(coarse, noise, size, 0.0, 0.0, cv::INTER_CUBIC);
  return noise;
}

template <typename Opinion>
Opinion AtBorder(const Opinion& seen, const Opinion& true_there) {
  if (seen.labels[0] == true_there.labels[0]) return seen;
  return {{seen.labels[0], true_there.labels[0], kUnknownLabel},
          {ToByte(kBorderConfidence), ToByte(kBorderOther), 0}};
}

}  // namespace

LabelErrors::LabelErrors(const LabelErrorOptions& options, const LabelVocabulary& vocabulary)
    : options_(Validated(options)), vocabulary_hash_(vocabulary.hash()), similar_(vocabulary) {}

Segmentation LabelErrors::Apply(const cv::Mat& labels, const cv::Mat& instances,
                                Stamp stamp) const {
  assert(labels.type() == CV_8UC1 && instances.type() == CV_16UC1 && !labels.empty() &&
         labels.size() == instances.size());
  const std::vector<Opinion> opinions = OpinionsOnInstances(labels, instances, stamp);
  const cv::Mat wobbled = Wobbled(instances, stamp);
  Segmentation segmentation;
  segmentation.stamp = stamp;
  segmentation.vocabulary_hash = vocabulary_hash_;
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i].create(labels.size(), CV_8UC1);
    segmentation.confidences[i].create(labels.size(), CV_8UC1);
  }
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      const InstanceId seen = wobbled.at<InstanceId>(v, u), there = instances.at<InstanceId>(v, u);
      const Opinion opinion =
          seen == there ? opinions[seen] : AtBorder(opinions[seen], opinions[there]);
      for (int i = 0; i < kTopLabels; ++i) {
        segmentation.labels[i].at<LabelId>(v, u) = opinion.labels[i];
        segmentation.confidences[i].at<std::uint8_t>(v, u) = opinion.confidences[i];
      }
    }
  }
  return segmentation;
}

// By instance; only of those in view.
std::vector<LabelErrors::Opinion> LabelErrors::OpinionsOnInstances(const cv::Mat& labels,
                                                                   const cv::Mat& instances,
                                                                   Stamp stamp) const {
  double largest = 0.0;
  cv::minMaxLoc(instances, nullptr, &largest);
  std::vector<Opinion> opinions(static_cast<std::size_t>(largest) + 1);
  std::vector<bool> known(opinions.size(), false);
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      const InstanceId instance = instances.at<InstanceId>(v, u);
      if (known[instance]) continue;
      opinions[instance] = OpinionOn(instance, labels.at<LabelId>(v, u), stamp);
      known[instance] = true;
    }
  }
  return opinions;
}

LabelErrors::Opinion LabelErrors::OpinionOn(InstanceId instance, LabelId label, Stamp stamp) const {
  const auto seed = static_cast<std::uint64_t>(options_.seed);
  // Things do not all change their looks at the same moment.
  const double phase = FractionOf(HashOf({seed, kPhase, instance}));
  const auto period =
      static_cast<std::int64_t>(std::floor(stamp.seconds() / options_.period_s + phase));
  RandomStream random(HashOf({seed, kError, instance, static_cast<std::uint64_t>(period)}));
  const bool is_unknown = random.Uniform() < options_.unknown_probability;
  const bool is_confused = random.Uniform() < options_.confusion_probability;
  const double right =
      std::clamp(options_.mean_confidence + options_.confidence_spread * random.Gaussian(),
                 kMinConfidence, 1.0);
  const double wrong = std::max(kMinConfidence, kWrongness * right);
  std::vector<LabelId> others = similar_.Of(label);
  if (!others.empty()) {
    std::rotate(others.begin(), others.begin() + random.Bits() % others.size(), others.end());
  }
  if (label == kUnknownLabel) return Ranked(label, wrong, {});
  if (is_unknown) return Ranked(kUnknownLabel, wrong, {label});
  if (!is_confused || others.empty()) return Ranked(label, right, others);
  const LabelId taken_for = others.front();
  others.front() = label;
  return Ranked(taken_for, wrong, others);
}

LabelErrors::Opinion LabelErrors::Ranked(LabelId first, double confidence,
                                         const std::vector<LabelId>& others) const {
  const std::array<double, kTopLabels> shares{1.0, kSecondShare, kThirdShare};
  Opinion opinion;
  opinion.labels[0] = first;
  opinion.confidences[0] = ToByte(static_cast<float>(confidence));
  for (std::size_t i = 1; i < kTopLabels && i <= others.size(); ++i) {
    opinion.labels[i] = others[i - 1];
    opinion.confidences[i] = ToByte(static_cast<float>(shares[i] * (1.0 - confidence)));
  }
  return opinion;
}

cv::Mat LabelErrors::Wobbled(const cv::Mat& instances, Stamp stamp) const {
  if (options_.border_wobble_px == 0.0) return instances;
  RandomStream random(HashOf(
      {static_cast<std::uint64_t>(options_.seed), kWobble, static_cast<std::uint64_t>(stamp.ns)}));
  cv::Mat from = SmoothNoise(instances.size(), random);
  for (int v = 0; v < from.rows; ++v) {
    for (int u = 0; u < from.cols; ++u) {
      cv::Vec2f& place = from.at<cv::Vec2f>(v, u);
      place = static_cast<float>(options_.border_wobble_px) * place +
              cv::Vec2f(static_cast<float>(u), static_cast<float>(v));
    }
  }
  cv::Mat wobbled;
  cv::remap(instances, wobbled, from, cv::noArray(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
  return wobbled;
}

}  // namespace semantic_slam
