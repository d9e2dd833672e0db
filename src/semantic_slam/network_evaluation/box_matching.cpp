#include "semantic_slam/network_evaluation/box_matching.h"

#include <algorithm>
#include <tuple>

#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

struct Pair {
  int truth = 0;
  int found = 0;
  bool is_of_one_class = false;
  double overlap = 0.0;
};

std::vector<Pair> OverlappingPairs(const std::vector<ClassBox>& truth,
                                   const std::vector<ClassBox>& found, double min_iou) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < found.size(); ++j) {
      const double overlap = IntersectionOverUnion(truth[i].box, found[j].box);
      if (overlap < min_iou) continue;
      pairs.push_back({static_cast<int>(i), static_cast<int>(j),
                       truth[i].class_index == found[j].class_index, overlap});
    }
  }
  return pairs;
}

}  // namespace

std::vector<int> MatchInOrder(const std::vector<cv::Rect2f>& truth,
                              const std::vector<cv::Rect2f>& found, double min_iou) {
  std::vector<int> matches(found.size(), -1);
  std::vector<bool> is_taken(truth.size(), false);
  for (std::size_t j = 0; j < found.size(); ++j) {
    double best = -1.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double overlap = IntersectionOverUnion(truth[i], found[j]);
      if (is_taken[i] || overlap < min_iou || overlap <= best) continue;
      best = overlap;
      matches[j] = static_cast<int>(i);
    }
    if (matches[j] >= 0) is_taken[matches[j]] = true;
  }
  return matches;
}

std::vector<ClassBox> PassOverOptional(const std::vector<ClassBox>& truth,
                                       const std::vector<cv::Rect2f>& optional,
                                       const std::vector<ClassBox>& found, double min_iou) {
  std::vector<ClassBox> kept;
  for (const ClassBox& box : found) {
    double of_true = 0.0, of_optional = 0.0;
    for (const ClassBox& other : truth) {
      of_true = std::max(of_true, IntersectionOverUnion(other.box, box.box));
    }
    for (const cv::Rect2f& other : optional) {
      of_optional = std::max(of_optional, IntersectionOverUnion(other, box.box));
    }
    if (of_optional < min_iou || of_optional <= of_true) kept.push_back(box);
  }
  return kept;
}

void CountBoxes(const std::vector<ClassBox>& truth, const std::vector<ClassBox>& found,
                double min_iou, ConfusionMatrix& matrix) {
  std::vector<Pair> pairs = OverlappingPairs(truth, found, min_iou);
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.is_of_one_class, a.overlap) > std::tie(b.is_of_one_class, b.overlap);
  });
  std::vector<bool> is_truth_taken(truth.size(), false);
  std::vector<bool> is_found_taken(found.size(), false);
  for (const Pair& pair : pairs) {
    if (is_truth_taken[pair.truth] || is_found_taken[pair.found]) continue;
    is_truth_taken[pair.truth] = is_found_taken[pair.found] = true;
    matrix.Add(truth[pair.truth].class_index, found[pair.found].class_index);
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!is_truth_taken[i]) matrix.Add(truth[i].class_index, matrix.none());
  }
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (!is_found_taken[j]) matrix.Add(matrix.none(), found[j].class_index);
  }
}

}  // namespace semantic_slam
