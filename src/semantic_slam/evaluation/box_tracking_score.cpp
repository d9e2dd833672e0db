#include "semantic_slam/evaluation/box_tracking_score.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "semantic_slam/common/assignment.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kMatchIou = 0.5;
constexpr double kRounding = 1e-9;  // an IoU of exactly the threshold is a match
constexpr int kHotaThresholds = 19;

using Boxes = std::vector<BoxInFrame>;

// The boxes of one image; ids are renumbered 0, 1, ... in ascending order over the whole sequence.
struct Frame {
  std::vector<int> reference_ids;
  std::vector<int> estimated_ids;
  Eigen::MatrixXd iou;  // reference x estimated
};

struct Comparison {
  std::vector<Frame> frames;
  Eigen::VectorXd reference_count;  // boxes by id
  Eigen::VectorXd estimated_count;
};

double Iou(const cv::Rect2d& a, const cv::Rect2d& b) {
  const double both = (a & b).area();
  return both > 0.0 ? both / (a.area() + b.area() - both) : 0.0;
}

std::map<int, int> Renumbered(const Boxes& boxes) {
  std::map<int, int> numbers;
  for (const BoxInFrame& box : boxes) numbers[box.id] = 0;
  int next = 0;
  for (auto& [id, number] : numbers) number = next++;
  return numbers;
}

std::map<int, Boxes> ByFrame(const Boxes& boxes, const char* which) {
  std::map<int, Boxes> frames;
  std::set<std::pair<int, int>> seen;
  for (const BoxInFrame& box : boxes) {
    if (!seen.insert({box.frame, box.id}).second) {
      throw InputError(std::string(which) + ": id " + std::to_string(box.id) +
                       " appears twice in frame " + std::to_string(box.frame));
    }
    frames[box.frame].push_back(box);
  }
  return frames;
}

std::vector<int> Numbers(const Boxes& boxes, const std::map<int, int>& numbers,
                         Eigen::VectorXd& count) {
  std::vector<int> ids;
  for (const BoxInFrame& box : boxes) {
    ids.push_back(numbers.at(box.id));
    count[ids.back()] += 1.0;
  }
  return ids;
}

Comparison Compare(const Boxes& reference, const Boxes& estimate) {
  const auto reference_numbers = Renumbered(reference), estimated_numbers = Renumbered(estimate);
  auto reference_frames = ByFrame(reference, "reference");
  auto estimated_frames = ByFrame(estimate, "estimate");
  std::set<int> all;
  for (const auto& frame : reference_frames) all.insert(frame.first);
  for (const auto& frame : estimated_frames) all.insert(frame.first);
  Comparison comparison;
  comparison.reference_count.setZero(reference_numbers.size());
  comparison.estimated_count.setZero(estimated_numbers.size());
  for (const int number : all) {
    const Boxes& truth = reference_frames[number];
    const Boxes& found = estimated_frames[number];
    Frame frame;
    frame.reference_ids = Numbers(truth, reference_numbers, comparison.reference_count);
    frame.estimated_ids = Numbers(found, estimated_numbers, comparison.estimated_count);
    frame.iou.resize(truth.size(), found.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      for (std::size_t j = 0; j < found.size(); ++j)
        frame.iou(i, j) = Iou(truth[i].box, found[j].box);
    }
    comparison.frames.push_back(std::move(frame));
  }
  return comparison;
}

// False positives and negatives and switches of identity: an object keeps the id that it had in the
// frame before where the boxes still match.
void ScoreClear(const Comparison& comparison, BoxTrackingScore& score) {
  constexpr double kKeepsItsId = 1000.0;
  std::map<int, int> last_id;    // that an object ever had
  std::map<int, int> id_before;  // in the frame before
  std::size_t matches = 0;
  for (const Frame& frame : comparison.frames) {
    Eigen::MatrixXd cost = -frame.iou;
    for (int i = 0; i < cost.rows(); ++i) {
      const auto before = id_before.find(frame.reference_ids[i]);
      for (int j = 0; j < cost.cols(); ++j) {
        if (frame.iou(i, j) < kMatchIou - kRounding) {
          cost(i, j) = 0.0;
        } else if (before != id_before.end() && before->second == frame.estimated_ids[j]) {
          cost(i, j) -= kKeepsItsId;
        }
      }
    }
    id_before.clear();
    for (const AssignedPair& pair : AssignAtLeastCost(cost, 0.0)) {
      const int object = frame.reference_ids[pair.row], id = frame.estimated_ids[pair.column];
      const auto [last, is_first] = last_id.try_emplace(object, id);
      score.id_switches += !is_first && last->second != id;
      last->second = id_before[object] = id;
      ++matches;
    }
  }
  score.false_positives = score.estimated_boxes - matches;
  score.false_negatives = score.reference_boxes - matches;
  const auto errors = score.false_positives + score.false_negatives + score.id_switches;
  score.mota = 1.0 - static_cast<double>(errors) / static_cast<double>(score.reference_boxes);
}

// One id for each object over the whole sequence, so that most boxes agree.
double Idf1(const Comparison& comparison, const BoxTrackingScore& score) {
  Eigen::MatrixXd matches =
      Eigen::MatrixXd::Zero(comparison.reference_count.size(), comparison.estimated_count.size());
  for (const Frame& frame : comparison.frames) {
    for (int i = 0; i < frame.iou.rows(); ++i) {
      for (int j = 0; j < frame.iou.cols(); ++j) {
        if (frame.iou(i, j) < kMatchIou - kRounding) continue;
        matches(frame.reference_ids[i], frame.estimated_ids[j]) += 1.0;
      }
    }
  }
  double agreeing = 0.0;
  for (const AssignedPair& pair : AssignAtLeastCost(-matches, 0.0)) {
    agreeing += matches(pair.row, pair.column);
  }
  return 2.0 * agreeing / static_cast<double>(score.reference_boxes + score.estimated_boxes);
}

// How much each pair of ids overlaps over the whole sequence, 0..1: what HOTA prefers to match.
Eigen::MatrixXd GlobalAlignment(const Comparison& comparison) {
  const Eigen::VectorXd& n = comparison.reference_count;
  const Eigen::VectorXd& m = comparison.estimated_count;
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(n.size(), m.size());
  for (const Frame& frame : comparison.frames) {
    const Eigen::VectorXd row_sum = frame.iou.rowwise().sum();
    const Eigen::RowVectorXd column_sum = frame.iou.colwise().sum();
    for (int i = 0; i < frame.iou.rows(); ++i) {
      for (int j = 0; j < frame.iou.cols(); ++j) {
        const double all = row_sum[i] + column_sum[j] - frame.iou(i, j);
        if (all <= 0.0) continue;
        together(frame.reference_ids[i], frame.estimated_ids[j]) += frame.iou(i, j) / all;
      }
    }
  }
  const Eigen::MatrixXd either =
      n.replicate(1, m.size()) + m.transpose().replicate(n.size(), 1) - together;
  return together.cwiseQuotient(either);
}

double Hota(const Comparison& comparison, const BoxTrackingScore& score) {
  const Eigen::MatrixXd alignment = GlobalAlignment(comparison);
  using Matches = std::map<std::pair<int, int>, double>;  // by ids: boxes matched
  std::vector<Matches> matches(kHotaThresholds);
  for (const Frame& frame : comparison.frames) {
    Eigen::MatrixXd cost = -frame.iou;
    for (int i = 0; i < cost.rows(); ++i) {
      for (int j = 0; j < cost.cols(); ++j) {
        cost(i, j) *= alignment(frame.reference_ids[i], frame.estimated_ids[j]);
      }
    }
    for (const AssignedPair& pair : AssignAtLeastCost(cost, 0.0)) {
      for (int k = 0; k < kHotaThresholds; ++k) {
        if (frame.iou(pair.row, pair.column) < 0.05 * (k + 1) - kRounding) break;
        matches[k][{frame.reference_ids[pair.row], frame.estimated_ids[pair.column]}] += 1.0;
      }
    }
  }
  double sum = 0.0;
  for (const Matches& at_threshold : matches) {
    double matched = 0.0, association = 0.0;
    for (const auto& [ids, count] : at_threshold) {
      const double either =
          comparison.reference_count[ids.first] + comparison.estimated_count[ids.second] - count;
      matched += count;
      association += count * count / either;
    }
    if (matched == 0.0) continue;
    const double all = static_cast<double>(score.reference_boxes + score.estimated_boxes) - matched;
    sum += std::sqrt(matched / all * association / matched);
  }
  return sum / kHotaThresholds;
}

}  // namespace

BoxTrackingScore ScoreBoxTracks(const Boxes& reference, const Boxes& estimate) {
  Boxes counting;
  std::copy_if(reference.begin(), reference.end(), std::back_inserter(counting),
               [](const BoxInFrame& box) { return box.confidence != 0.0; });
  if (counting.empty()) throw InputError("reference: no box counts");
  const Comparison comparison = Compare(counting, estimate);
  BoxTrackingScore score;
  score.reference_boxes = counting.size();
  score.estimated_boxes = estimate.size();
  ScoreClear(comparison, score);
  score.idf1 = Idf1(comparison, score);
  score.hota = Hota(comparison, score);
  return score;
}

nlohmann::ordered_json ToJson(const BoxTrackingScore& score) {
  return {{"mota", 100.0 * score.mota},
          {"idf1", 100.0 * score.idf1},
          {"hota", 100.0 * score.hota},
          {"id_switches", score.id_switches},
          {"false_positives", score.false_positives},
          {"false_negatives", score.false_negatives},
          {"reference_boxes", score.reference_boxes},
          {"estimated_boxes", score.estimated_boxes}};
}

void PrintTable(const BoxTrackingScore& score, std::ostream& out) {
  out << std::fixed << std::setprecision(1);
  out << "MOTA             " << 100.0 * score.mota << " %\n"
      << "IDF1             " << 100.0 * score.idf1 << " %\n"
      << "HOTA             " << 100.0 * score.hota << " %\n"
      << "id switches      " << score.id_switches << "\n"
      << "false positives  " << score.false_positives << "\n"
      << "false negatives  " << score.false_negatives << " of " << score.reference_boxes << "\n";
}

}  // namespace semantic_slam
