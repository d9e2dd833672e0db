#include "semantic_slam/ground_truth/map_report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kClassesShown = 8;  // in the table
constexpr std::array<const char*, VoxelLabelScore::kObservationBins> kObservationNames{
    "1", "2-3", "4-7", "8-15", "16-31", "32+"};

Json ToJson(const VoxelCount& count) {
  return {{"voxels", count.voxels},
          {"right", count.voxels > 0 ? Json(count.share()) : Json(nullptr)}};
}

Json ToJson(const CellCount& count) {
  return count.cells > 0 ? Json(count.share()) : Json(nullptr);
}

double Share(std::size_t part, std::size_t all) {
  return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0.0;
}

Json ToJson(const VoxelLabelScore& score, const LabelVocabulary& vocabulary) {
  Json json;
  json["occupied"] = score.occupied;
  json["without_surface"] = Share(score.without_surface, score.occupied);
  json["not_counted"] = Share(score.not_counted, score.occupied);
  json["unlabelled"] = Share(score.unlabelled, score.all.voxels);
  json["right"] = score.all.share();
  json["strict"] = score.strict.share();
  json["by_class"] = Json::object();
  for (const auto& [label, count] : score.by_class) {
    json["by_class"][vocabulary[label].name] = ToJson(count);
  }
  json["by_observations"] = Json::object();
  for (std::size_t i = 0; i < kObservationNames.size(); ++i) {
    json["by_observations"][kObservationNames[i]] = ToJson(score.by_observations[i]);
  }
  return json;
}

Json ToJson(const ObjectScore& score, const std::vector<MapObject>& truth,
            const LabelVocabulary& vocabulary) {
  Json json;
  json["expected"] = score.expected;
  json["found"] = score.matches.size();
  json["missed"] = score.missed.size();
  json["extra"] = score.extra.size();
  json["right_class"] = Share(score.right_class(), score.matches.size());
  const auto add = [&json](const std::string& name, const ErrorStatistics& errors) {
    json[name + "_mean_m"] = errors.mean;
    json[name + "_max_m"] = errors.max;
  };
  add("position", score.position_m());
  add("box_centre", score.box_m());
  add("height", score.height_m());
  add("size", score.size_m());
  json["missed_classes"] = Json::array();
  for (const std::size_t i : score.missed) {
    json["missed_classes"].push_back(vocabulary[truth[i].labels.front().label].name);
  }
  return json;
}

Json ToJson(const GridScore& score) {
  return {{"free_precision", ToJson(score.free_precision)},
          {"free_recall", ToJson(score.free_recall)},
          {"occupied_precision", ToJson(score.occupied_precision)},
          {"occupied_recall", ToJson(score.occupied_recall)}};
}

// One line of the table: a name and up to four cells.
void PrintRow(const std::string& name, const std::vector<std::string>& cells, std::ostream& out) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%-30s", name.c_str());
  out << text.data();
  for (const std::string& cell : cells) {
    std::snprintf(text.data(), text.size(), " %12s", cell.c_str());
    out << text.data();
  }
  out << '\n';
}

std::string Number(double value, const char* format) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string Metres(double value) {
  return Number(value, "%.3f m");
}
std::string Percent(double share) {
  return Number(100.0 * share, "%.1f %%");
}

std::string Percent(const CellCount& count) {
  return count.cells > 0 ? Percent(count.share()) : "-";
}

void PrintTrajectory(const TrajectoryReport& report, std::ostream& out) {
  PrintRow("trajectory", {"RMSE", "mean", "max"}, out);
  const ErrorStatistics position = Summarise(report.absolute.position_m);
  PrintRow("  ATE", {Metres(position.rmse), Metres(position.mean), Metres(position.max)}, out);
  const ErrorStatistics rotation = Summarise(report.absolute.rotation_deg);
  PrintRow("  rotation",
           {Number(rotation.rmse, "%.2f deg"), Number(rotation.mean, "%.2f deg"),
            Number(rotation.max, "%.2f deg")},
           out);
  PrintRow("  path, poses",
           {Number(report.path_m, "%.1f m"), std::to_string(report.matches.size())}, out);
}

// Those with the most voxels.
void PrintClasses(const VoxelLabelScore& score, const LabelVocabulary& vocabulary,
                  std::ostream& out) {
  std::vector<std::pair<LabelId, VoxelCount>> classes(score.by_class.begin(), score.by_class.end());
  std::stable_sort(classes.begin(), classes.end(),
                   [](const auto& a, const auto& b) { return a.second.voxels > b.second.voxels; });
  for (std::size_t i = 0; i < std::min(classes.size(), kClassesShown); ++i) {
    const auto& [label, count] = classes[i];
    PrintRow("  " + vocabulary[label].name, {std::to_string(count.voxels), Percent(count.share())},
             out);
  }
  if (classes.size() <= kClassesShown) return;
  VoxelCount others;
  for (std::size_t i = kClassesShown; i < classes.size(); ++i) {
    others.voxels += classes[i].second.voxels;
    others.right += classes[i].second.right;
  }
  PrintRow("  " + std::to_string(classes.size() - kClassesShown) + " other classes",
           {std::to_string(others.voxels), Percent(others.share())}, out);
}

void PrintVoxels(const std::optional<VoxelLabelScore>& score, const LabelVocabulary& vocabulary,
                 std::ostream& out) {
  if (!score) return PrintRow("voxels", {"-"}, out);
  PrintRow("voxels", {"number", "right label"}, out);
  PrintRow("  with a surface", {std::to_string(score->all.voxels), Percent(score->all.share())},
           out);
  PrintRow("  by the nearest surface alone", {"", Percent(score->strict.share())}, out);
  PrintRow("  far from any surface", {Percent(Share(score->without_surface, score->occupied))},
           out);
  for (std::size_t i = 0; i < kObservationNames.size(); ++i) {
    const VoxelCount& count = score->by_observations[i];
    if (count.voxels == 0) continue;
    PrintRow("  seen " + std::string(kObservationNames[i]) + (i == 0 ? " time" : " times"),
             {std::to_string(count.voxels), Percent(count.share())}, out);
  }
  PrintClasses(*score, vocabulary, out);
}

void PrintObjects(const std::optional<ObjectScore>& score, std::ostream& out) {
  if (!score) return PrintRow("objects", {"-"}, out);
  PrintRow("objects", {"to be found", "found", "missed", "extra"}, out);
  PrintRow("  number",
           {std::to_string(score->expected), std::to_string(score->matches.size()),
            std::to_string(score->missed.size()), std::to_string(score->extra.size())},
           out);
  if (score->matches.empty()) return;
  PrintRow("  right class", {Percent(Share(score->right_class(), score->matches.size()))}, out);
  PrintRow("", {"mean", "max"}, out);
  const auto print = [&out](const char* name, const ErrorStatistics& errors) {
    PrintRow(name, {Metres(errors.mean), Metres(errors.max)}, out);
  };
  print("  position, from above", score->position_m());
  print("  middle of the box", score->box_m());
  print("  height of the top", score->height_m());
  print("  length and width", score->size_m());
}

void PrintGrid(const char* name, const std::optional<GridScore>& score, std::ostream& out) {
  if (!score) return PrintRow(name, {"-"}, out);
  PrintRow(name, {"precision", "recall"}, out);
  PrintRow("  free", {Percent(score->free_precision), Percent(score->free_recall)}, out);
  PrintRow("  occupied", {Percent(score->occupied_precision), Percent(score->occupied_recall)},
           out);
}

}  // namespace

Json ToJson(const MapEvaluation& evaluation, const LabelVocabulary& vocabulary) {
  Json json;
  json["trajectory"] = ToJson(evaluation.trajectory);
  json["voxels"] = evaluation.voxels ? ToJson(*evaluation.voxels, vocabulary) : Json(nullptr);
  json["objects"] = evaluation.objects
                        ? ToJson(*evaluation.objects, evaluation.true_objects, vocabulary)
                        : Json(nullptr);
  json["grid"] = evaluation.grid ? ToJson(*evaluation.grid) : Json(nullptr);
  json["semantic_grid"] =
      evaluation.semantic_grid ? ToJson(*evaluation.semantic_grid) : Json(nullptr);
  json["hollow_area"] = {{"in_objects", ToJson(evaluation.hollow.in_objects)},
                         {"in_semantic_grid", ToJson(evaluation.hollow.in_semantic_grid)},
                         {"in_grid", ToJson(evaluation.hollow.in_grid)}};
  return json;
}

void PrintTable(const MapEvaluation& evaluation, const LabelVocabulary& vocabulary,
                std::ostream& out) {
  PrintTrajectory(evaluation.trajectory, out);
  PrintVoxels(evaluation.voxels, vocabulary, out);
  PrintObjects(evaluation.objects, out);
  PrintGrid("floor plan", evaluation.grid, out);
  PrintGrid("semantic grid", evaluation.semantic_grid, out);
  PrintRow("area of tables and chairs", {"in objects", "semantic", "floor plan"}, out);
  const HollowArea& hollow = evaluation.hollow;
  PrintRow("  marked",
           {Percent(hollow.in_objects), Percent(hollow.in_semantic_grid), Percent(hollow.in_grid)},
           out);
}

}  // namespace semantic_slam
