#include "tools/replay_stages.h"

#include <filesystem>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/semantic_grid/semantic_grid_file.h"

namespace semantic_slam {

void ReadReplayOptions(YamlReader& file, ReplayOptions& options) {
  ReadOptionGroups(file, options.localization);
  ReadSemanticStageOptions(file, options.semantic);
  ReadObjectStageOptions(file, options.objects);
  ReadOptionGroups(file, options.grid_slam);
  file.ReadOptions("semantic_grid", options.semantic_grid);
  file.ReadOptions("semantic_costs", options.semantic_costs);
}

template <typename Stage, typename... Arguments>
Stage* ReplayStages::Start(double period_s, WhenFull when_full, Arguments&&... arguments) {
  auto stage = std::make_unique<Stage>(std::forward<Arguments>(arguments)...);
  Stage* const started = stage.get();
  runners_.push_back(std::make_unique<StageRunner>(std::move(stage), period_s, when_full));
  return started;
}

ReplayStages::ReplayStages(const StageSelection& selection, const ReplayOptions& options,
                           const std::shared_ptr<const CameraModel>& camera, WhenFull when_full)
    : options_(options) {
  if (!selection.semantic && !selection.objects && !selection.grid) return;
  if (!std::filesystem::exists(selection.labels)) {
    throw ConfigError("no vocabulary at " + selection.labels + "; --labels says where it is");
  }
  vocabulary_ = std::make_shared<const LabelVocabulary>(LabelVocabulary::Load(selection.labels));
  if (selection.semantic) {
    Start<SemanticStage>(selection.semantic_period_s, when_full, options.semantic,
                         LoadModel(selection.segmentation_card, selection.models), vocabulary_, camera,
                         timer_);
  }
  if (selection.objects) {
    objects_ = Start<ObjectStage>(selection.object_period_s, when_full, options.objects,
                                  LoadModel(selection.detection_card, selection.models), vocabulary_,
                                  camera, timer_);
  }
  if (selection.grid) {
    grid_ = Start<GridStage>(selection.grid_period_s, when_full, options.grid_slam, camera, timer_);
  }
}

void ReplayStages::Offer(const RgbdImage& image, const TrackedImage& tracked,
                         const VisualLocalization& localization) {
  if (runners_.empty()) return;
  if (graph_ == nullptr || graph_->revision != localization.revision()) {
    graph_ = std::make_shared<const KeyframeGraph>(localization.keyframe_graph());
  }
  for (const auto& runner : runners_) runner->Offer(image, tracked, graph_);
}

void ReplayStages::Finish(const KeyframeGraph& graph, const std::string& folder) {
  for (const auto& runner : runners_) runner->Finish(graph);
  for (const auto& runner : runners_) runner->stage().Write(folder);
  if (grid_ != nullptr) WriteSemanticGrid(folder);
}

void ReplayStages::WriteSemanticGrid(const std::string& folder) {
  const SemanticGridBuilder builder(options_.semantic_grid, options_.semantic_costs, *vocabulary_);
  const OccupancyMap map = grid_->Render();
  const ObjectMap objects = objects_ != nullptr ? objects_->Objects() : NoObjects(map);
  SemanticCells cells;
  {
    StageTimer::Scope scope(timer_, "grid.semantic_grid");
    cells = builder.Build(map, objects);
  }
  if (cells.cost.empty()) return;  // nothing is known, not even an empty floor
  semantic_slam::WriteSemanticGrid(folder, cells, map, objects, *vocabulary_);
}

// What there is where no stage looks for objects.
ObjectMap ReplayStages::NoObjects(const OccupancyMap& map) const {
  ObjectMap objects;
  objects.map_id = map.map_id;
  objects.revision = map.revision;
  objects.vocabulary_hash = vocabulary_->hash();
  return objects;
}

void ReplayStages::AddTo(RunFacts& facts) const {
  for (const auto& runner : runners_) facts.stages[runner->name()] = runner->counts();
  facts.stage_timings = timer_.Timings();
}

}  // namespace semantic_slam
