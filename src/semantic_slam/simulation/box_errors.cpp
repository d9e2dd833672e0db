#include "semantic_slam/simulation/box_errors.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

constexpr double kMinConfidence = 0.05;
constexpr double kMaxConfidence = 0.99;
constexpr double kDoubt = 0.5;  // how sure of itself a wrong box is, to a right one
constexpr double kMinInventedPx = 15.0;
constexpr double kMaxInventedShare = 0.3;  // of the image's side
constexpr float kMinSidePx = 1.0f;

// A number with that mean (Knuth, The Art of Computer Programming, vol. 2, section 3.4.1).
int DrawPoisson(double mean, RandomStream& random) {
  const double limit = std::exp(-mean);
  int count = 0;
  for (double product = random.Uniform(); product > limit; product *= random.Uniform()) ++count;
  return count;
}

// From -0.5: there the image begins, see DetectedBox.
cv::Rect2f Clipped(float left, float top, float right, float bottom, cv::Size image) {
  left = std::max(left, -0.5f), top = std::max(top, -0.5f);
  right = std::min(right, static_cast<float>(image.width) - 0.5f);
  bottom = std::min(bottom, static_cast<float>(image.height) - 0.5f);
  return {left, top, right - left, bottom - top};
}

std::vector<LabelId> MovableLabels(const LabelVocabulary& vocabulary) {
  std::vector<LabelId> ids;
  for (const LabelClass& label : vocabulary.classes()) {
    if (label.movable) ids.push_back(label.id);
  }
  return ids;
}

}  // namespace

BoxErrors::BoxErrors(const BoxErrorOptions& options, const LabelVocabulary& vocabulary)
    : options_(Validated(options)), similar_(vocabulary), inventable_(MovableLabels(vocabulary)) {}

Detections BoxErrors::Apply(const Detections& truth) const {
  RandomStream random(HashOf(
      {static_cast<std::uint64_t>(options_.seed), static_cast<std::uint64_t>(truth.stamp.ns)}));
  Detections found{truth.stamp, truth.vocabulary_hash, truth.image_size, {}};
  for (const DetectedBox& box : truth.boxes) {
    if (const auto detected = Detect(box, truth.image_size, random)) {
      found.boxes.push_back(*detected);
    }
  }
  const int inventions =
      inventable_.empty() ? 0 : DrawPoisson(options_.false_positives_per_image, random);
  for (int i = 0; i < inventions; ++i) found.boxes.push_back(Invent(truth.image_size, random));
  std::stable_sort(
      found.boxes.begin(), found.boxes.end(),
      [](const DetectedBox& a, const DetectedBox& b) { return a.confidence > b.confidence; });
  return found;
}

std::optional<DetectedBox> BoxErrors::Detect(const DetectedBox& truth, cv::Size image_size,
                                             RandomStream& random) const {
  if (random.Uniform() < options_.miss_probability) return std::nullopt;
  const auto jitter = [&](float size_px) {
    const double sigma = std::hypot(options_.jitter_px, options_.jitter_share * size_px);
    return static_cast<float>(sigma * random.Gaussian());
  };
  const cv::Rect2f& box = truth.box;
  const float left = box.x + jitter(box.width), right = box.x + box.width + jitter(box.width);
  const float top = box.y + jitter(box.height), bottom = box.y + box.height + jitter(box.height);
  DetectedBox found{truth.label, DrawConfidence(options_.mean_confidence, random),
                    Clipped(left, top, right, bottom, image_size)};
  const std::vector<LabelId>& similar = similar_.Of(truth.label);
  if (random.Uniform() < options_.confusion_probability && !similar.empty()) {
    found.label = similar[random.Bits() % similar.size()];
    found.confidence = DrawConfidence(kDoubt * options_.mean_confidence, random);
  }
  if (found.box.width < kMinSidePx || found.box.height < kMinSidePx) return std::nullopt;
  return found;
}

DetectedBox BoxErrors::Invent(cv::Size image_size, RandomStream& random) const {
  const auto draw_side = [&](int image_px) {
    const double largest = std::max(kMinInventedPx, kMaxInventedShare * image_px);
    return std::min<double>(image_px,
                            kMinInventedPx + (largest - kMinInventedPx) * random.Uniform());
  };
  const double width = draw_side(image_size.width), height = draw_side(image_size.height);
  const double left = (image_size.width - width) * random.Uniform() - 0.5;
  const double top = (image_size.height - height) * random.Uniform() - 0.5;
  const LabelId label = inventable_[random.Bits() % inventable_.size()];
  return {label, DrawConfidence(kDoubt * options_.mean_confidence, random),
          cv::Rect2f(static_cast<float>(left), static_cast<float>(top), static_cast<float>(width),
                     static_cast<float>(height))};
}

float BoxErrors::DrawConfidence(double mean, RandomStream& random) const {
  const double confidence = mean + options_.confidence_spread * random.Gaussian();
  return static_cast<float>(std::clamp(confidence, kMinConfidence, kMaxConfidence));
}

}  // namespace semantic_slam
