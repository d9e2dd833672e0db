#include "semantic_slam/network_evaluation/segmentation_report.h"

#include <nlohmann/json.hpp>

#include "semantic_slam/network_evaluation/report_json.h"
#include "semantic_slam/network_evaluation/report_text.h"
#include "semantic_slam/network_evaluation/segmentation_score.h"

namespace semantic_slam {

using Json = nlohmann::ordered_json;

Json ToJson(const SegmentationEvaluation& evaluation, const ClassList& classes) {
  const SegmentationScore score = ScoreSegmentation(evaluation.confusion);
  Json json;
  json["pixels"] = score.pixels;
  json["pixel_accuracy"] = NumberOrNull(score.pixel_accuracy);
  json["mean_class_accuracy"] = NumberOrNull(score.mean_class_accuracy);
  json["mean_iou"] = NumberOrNull(score.mean_iou);
  json["frequency_weighted_iou"] = NumberOrNull(score.frequency_weighted_iou);
  json["classes"] = Json::object();
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const ClassSegmentationScore& of_class = score.classes[c];
    json["classes"][classes.names[c]] = {{"iou", NumberOrNull(of_class.iou)},
                                         {"precision", NumberOrNull(of_class.precision)},
                                         {"recall", NumberOrNull(of_class.recall)},
                                         {"pixel_share", NumberOrNull(of_class.pixel_share)}};
  }
  json["confusion"] = ToJson(evaluation.confusion, classes.names, kOtherLabels);
  json["time"] = ToJson(evaluation.timing);
  return json;
}

void PrintTable(const SegmentationEvaluation& evaluation, const ClassList& classes,
                std::ostream& out) {
  const SegmentationScore score = ScoreSegmentation(evaluation.confusion);
  PrintTableRow("images", {std::to_string(evaluation.timing.count)}, out);
  PrintTableRow("pixel accuracy", {PercentText(score.pixel_accuracy)}, out);
  PrintTableRow("mean class accuracy", {PercentText(score.mean_class_accuracy)}, out);
  PrintTableRow("mean IoU", {PercentText(score.mean_iou)}, out);
  PrintTableRow("frequency-weighted IoU", {PercentText(score.frequency_weighted_iou)}, out);
  PrintTableRow("time per image", {"median", "95 %"}, out);
  PrintTableRow(
      "  [ms]",
      {NumberText(evaluation.timing.median_ms, 1), NumberText(evaluation.timing.p95_ms, 1)}, out);
  PrintTableRow("class", {"IoU", "precision", "recall", "pixels"}, out);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const ClassSegmentationScore& of_class = score.classes[c];
    PrintTableRow("  " + classes.names[c],
                  {PercentText(of_class.iou), PercentText(of_class.precision),
                   PercentText(of_class.recall), PercentText(of_class.pixel_share)},
                  out);
  }
}

}  // namespace semantic_slam
