#include "tools/replay_stages.h"

#include <filesystem>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/segmentation/segmenter.h"
#include "semantic_slam/semantic_grid/semantic_grid_file.h"
#include "tools/truth_images.h"

namespace semantic_slam {
namespace {

SegmentImage MakeSegmenter(const StageSelection& selection, const LabelVocabulary& vocabulary,
                           const NetworkOptions& options) {
  if (selection.segmentation_card == kTruth) {
    const auto truth = std::make_shared<const TrueLabels>(selection.dataset, vocabulary);
    return [truth](const RgbdImage& image) { return truth->Find(image.colour, image.stamp); };
  }
  const Model model = LoadModel(selection.segmentation_card, selection.models);
  const auto network = std::make_shared<Segmenter>(model, vocabulary, options);
  return [network](const RgbdImage& image) {
    return network->Segment(image.colour, image.order, image.stamp);
  };
}

DetectObjects MakeDetector(const StageSelection& selection, const LabelVocabulary& vocabulary,
                           const ObjectStageOptions& options) {
  if (selection.detection_card == kTruth) {
    const auto truth = std::make_shared<const TrueBoxes>(selection.dataset, vocabulary);
    return [truth](const RgbdImage& image) { return truth->Find(image.colour, image.stamp); };
  }
  const Model model = LoadModel(selection.detection_card, selection.models);
  const auto network =
      std::make_shared<Detector>(model, vocabulary, options.network, options.detector);
  return [network](const RgbdImage& image) {
    return network->Detect(image.colour, image.order, image.stamp);
  };
}

}  // namespace

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
                         MakeSegmenter(selection, *vocabulary_, options.semantic.segmentation),
                         vocabulary_, camera, timer_);
  }
  if (selection.objects) {
    objects_ = Start<ObjectStage>(selection.object_period_s, when_full, options.objects,
                                  MakeDetector(selection, *vocabulary_, options.objects),
                                  vocabulary_, camera, timer_);
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
