#pragma once

#include <memory>
#include <string>
#include <vector>

#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam/semantic_grid/semantic_grid_builder.h"
#include "tools/grid_stage.h"
#include "tools/mapping_stage.h"
#include "tools/object_stage.h"
#include "tools/semantic_stage.h"

namespace semantic_slam {

// The options of every stage, as the camera's configuration file may give them.
struct ReplayOptions {
  LocalizationOptions localization;
  SemanticStageOptions semantic;
  ObjectStageOptions objects;
  GridSlamOptions grid_slam;
  SemanticGridOptions semantic_grid;
  SemanticCostOptions semantic_costs;
};

void ReadReplayOptions(YamlReader& file, ReplayOptions& options);

// In place of a network's card: what render_sequence has left beside the images.
constexpr char kTruth[] = "truth";

// Which stages run behind tracking, with what, and how often.
struct StageSelection {
  bool semantic = false;
  bool objects = false;
  bool grid = false;
  std::string labels;              // file of the vocabulary
  std::string models;              // folder; empty: where LoadModel() looks anyhow
  std::string segmentation_card;   // with semantic; or kTruth
  std::string detection_card;      // with objects; or kTruth
  std::string dataset;             // folder with the truth
  double semantic_period_s = 0.2;
  double object_period_s = 0.1;
  double grid_period_s = 0.1;
};

// The stages behind tracking: each on a thread of its own, see StageRunner.
class ReplayStages {
 public:
  // Throws ConfigError as the stages do.
  ReplayStages(const StageSelection& selection, const ReplayOptions& options,
               const std::shared_ptr<const CameraModel>& camera, WhenFull when_full);

  // Hands an image to the stages that are due, with the keyframe graph as it is now.
  void Offer(const RgbdImage& image, const TrackedImage& tracked,
             const VisualLocalization& localization);

  // Works off what is left, and writes the results of every stage.
  void Finish(const KeyframeGraph& graph, const std::string& folder);

  // After Finish(): what the report tells of the stages.
  void AddTo(RunFacts& facts) const;

 private:
  void WriteSemanticGrid(const std::string& folder);
  ObjectMap NoObjects(const OccupancyMap& map) const;
  template <typename Stage, typename... Arguments>
  Stage* Start(double period_s, WhenFull when_full, Arguments&&... arguments);

  const ReplayOptions options_;
  StageTimer timer_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
  std::shared_ptr<const KeyframeGraph> graph_;
  ObjectStage* objects_ = nullptr;  // owned by its runner; nullptr if it does not run
  GridStage* grid_ = nullptr;       // likewise
  std::vector<std::unique_ptr<StageRunner>> runners_;  // last: their threads end first
};

}  // namespace semantic_slam
