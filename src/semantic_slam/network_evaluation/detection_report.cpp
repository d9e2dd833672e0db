#include "semantic_slam/network_evaluation/detection_report.h"

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "semantic_slam/network_evaluation/report_json.h"
#include "semantic_slam/network_evaluation/report_text.h"

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t AllTruths(const DetectionScore& score) {
  std::int64_t truths = 0;
  for (int c = 0; c < score.classes(); ++c) truths += score.truths(c);
  return truths;
}

Json ToJson(const std::optional<OperatingPoint>& point) {
  if (!point) return nullptr;
  return {{"threshold", point->threshold},
          {"precision", NumberOrNull(point->rates.precision())},
          {"recall", NumberOrNull(point->rates.recall())},
          {"f1", NumberOrNull(point->rates.f1())},
          {"hits", point->rates.hits},
          {"extras", point->rates.extras},
          {"misses", point->rates.misses},
          {"mean_class_precision", NumberOrNull(point->mean_class_precision)},
          {"mean_class_recall", NumberOrNull(point->mean_class_recall)}};
}

Json ToJson(const ClassDetectionScore& score) {
  return {{"boxes", score.truths},
          {"ap50", NumberOrNull(score.ap50)},
          {"ap50_95", NumberOrNull(score.ap50_95)},
          {"precision", NumberOrNull(score.rates.precision())},
          {"recall", NumberOrNull(score.rates.recall())},
          {"f1", NumberOrNull(score.rates.f1())}};
}

void PrintPoint(const std::string& name, const OperatingPoint& point, std::ostream& out) {
  PrintTableRow(name + " " + NumberText(point.threshold, 3),
                {PercentText(point.rates.precision()), PercentText(point.rates.recall()),
                 PercentText(point.rates.f1())},
                out);
  PrintTableRow("    mean of classes",
                {PercentText(point.mean_class_precision), PercentText(point.mean_class_recall)},
                out);
}

void PrintClass(const std::string& name, const ClassDetectionScore& score, std::ostream& out) {
  PrintTableRow("  " + name,
                {PercentText(score.ap50), PercentText(score.ap50_95),
                 PercentText(score.rates.precision()), PercentText(score.rates.recall()),
                 PercentText(score.rates.f1()), std::to_string(score.truths)},
                out);
}

}  // namespace

Json ToJson(const DetectionEvaluation& evaluation, const ClassList& classes) {
  const DetectionScore& score = evaluation.score;
  Json json;
  json["boxes"] = AllTruths(score);
  json["map50"] = NumberOrNull(score.MeanAp50());
  json["map50_95"] = NumberOrNull(score.MeanAp50To95());
  json["at_threshold"] = ToJson(std::optional(score.At(score.threshold())));
  json["at_best_f1"] = ToJson(score.AtBestF1());
  json["classes"] = Json::object();
  for (int c = 0; c < score.classes(); ++c) {
    json["classes"][classes.names[c]] = ToJson(score.OfClass(c));
  }
  json["confusion"] = ToJson(evaluation.confusion, classes.names, kBackground);
  json["time"] = ToJson(evaluation.timing);
  return json;
}

void PrintTable(const DetectionEvaluation& evaluation, const ClassList& classes,
                std::ostream& out) {
  const DetectionScore& score = evaluation.score;
  PrintTableRow("images", {std::to_string(evaluation.timing.count)}, out);
  PrintTableRow("true boxes", {std::to_string(AllTruths(score))}, out);
  PrintTableRow("mAP@0.5", {PercentText(score.MeanAp50())}, out);
  PrintTableRow("mAP@0.5:0.95", {PercentText(score.MeanAp50To95())}, out);
  PrintTableRow("all boxes, IoU 0.5", {"precision", "recall", "F1"}, out);
  PrintPoint("  threshold", score.At(score.threshold()), out);
  if (const auto best = score.AtBestF1()) PrintPoint("  best F1, at", *best, out);
  PrintTableRow("time per image", {"median", "95 %"}, out);
  PrintTableRow(
      "  [ms]",
      {NumberText(evaluation.timing.median_ms, 1), NumberText(evaluation.timing.p95_ms, 1)}, out);
  PrintTableRow("class", {"AP@0.5", "AP@.5:.95", "precision", "recall", "F1", "boxes"}, out);
  for (int c = 0; c < score.classes(); ++c) PrintClass(classes.names[c], score.OfClass(c), out);
}

}  // namespace semantic_slam
