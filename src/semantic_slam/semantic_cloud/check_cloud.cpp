#include "semantic_slam/semantic_cloud/check_cloud.h"

#include <algorithm>
#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam/semantic_cloud/point_lanes.h"

namespace semantic_slam {
namespace {

// Confidences may have been rounded by whoever sent them.
constexpr float kRounding = 1e-3f;

// Comparisons are written so that NaN fails them.
void CheckConfidences(const std::array<float, kTopLabels>& confidences) {
  float sum = 0.0f;
  for (const float confidence : confidences) {
    if (!(confidence >= 0.0f && confidence <= 1.0f)) {
      throw InputError("semantic cloud: confidence is " + std::to_string(confidence) +
                       ", expected 0 to 1");
    }
    sum += confidence;
  }
  if (sum > 1.0f + kRounding) {
    throw InputError("semantic cloud: confidences of a point sum up to " + std::to_string(sum) +
                     ", expected at most 1");
  }
}

// Looks through all points without branches, as clouds have hundreds of thousands: comparisons with
// NaN are false, and what is not finite times zero is NaN. Returns whether all are sound.
bool Survey(const std::vector<SemanticPoint>& points, const LabelVocabulary& vocabulary,
            CloudContents& contents) {
  std::array<bool, 256> is_known{}, is_there{};
  for (const LabelClass& label : vocabulary.classes()) is_known[label.id] = true;
  Floats4 low{}, high{};
  std::uint32_t last = 0;
  Ints4 sound{-1, -1, -1, -1};
  float highest = 0.0f;  // sum of confidences
  for (const SemanticPoint& point : points) {
    const PointLanes lanes(point);
    const Floats4 p = lanes.position(), c = lanes.confidences();
    low = p < low ? p : low;
    high = p > high ? p : high;
    sound &= (p * 0.0f == 0.0f) & (c >= 0.0f);
    highest = std::max(highest, c[1] + c[2] + c[3]);
    if (lanes.labels() == last) continue;  // as most neighbours have the same
    last = lanes.labels();
    for (const LabelId label : point.labels) is_there[label] = true;
  }
  bool all_known = true;
  for (unsigned label = 0; label < is_there.size(); ++label) {
    all_known &= !is_there[label] || is_known[label];
    contents.labels[label] = is_there[label];
  }
  contents.around_m = {Eigen::Vector3f(low[0], low[1], low[2]),
                       Eigen::Vector3f(high[0], high[1], high[2])};
  return All(sound) && highest <= 1.0f && all_known;
}

}  // namespace

CloudContents CheckSemanticCloud(const SemanticCloud& cloud, const LabelVocabulary& vocabulary) {
  CheckLabelSet("semantic cloud", cloud.vocabulary_hash, vocabulary);
  CloudContents contents;
  if (Survey(cloud.points, vocabulary, contents)) return contents;
  for (const SemanticPoint& point : cloud.points) {
    if (!point.position.allFinite()) throw InputError("semantic cloud: a position is not finite");
    CheckConfidences(point.confidences);
    for (const LabelId label : point.labels) CheckLabel("semantic cloud", label, vocabulary);
  }
  return contents;  // confidences that rounding has brought above 1 together
}

}  // namespace semantic_slam
