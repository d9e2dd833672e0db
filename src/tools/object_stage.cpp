#include "tools/object_stage.h"

#include <filesystem>
#include <utility>

#include "semantic_slam/object_mapping/object_map_file.h"

namespace semantic_slam {
namespace {

// The groups of a configuration file's mapping "detection".
struct DetectionGroups {
  NetworkOptions& network;
  DetectorOptions& detector;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("network", self.network);
    visit_group("detector", self.detector);
  }
};

}  // namespace

void ReadObjectStageOptions(YamlReader& file, ObjectStageOptions& options) {
  DetectionGroups detection{options.network, options.detector};
  ReadOptionGroups(file, "detection", detection);
  ReadOptionGroups(file, "object_tracking", options.object_tracking);
  ReadOptionGroups(file, "object_mapping", options.object_mapping);
}

ObjectStage::ObjectStage(const ObjectStageOptions& options, DetectObjects detect,
                         std::shared_ptr<const LabelVocabulary> vocabulary,
                         std::shared_ptr<const CameraModel> camera, StageTimer& timer)
    : vocabulary_(std::move(vocabulary)),
      camera_(std::move(camera)),
      timer_(timer),
      detect_(std::move(detect)),
      tracker_(options.object_tracking, vocabulary_),
      mapper_(options.object_mapping, vocabulary_) {}

void ObjectStage::Process(const RgbdImage& image, const TrackedImage& tracked) {
  Detections detections;
  {
    StageTimer::Scope scope(timer_, "objects.detection");
    detections = detect_(image);
  }
  detections_ += detections.boxes.size();
  ObjectTracks tracks;
  {
    StageTimer::Scope scope(timer_, "objects.tracking");
    tracks = tracker_.Update(detections, image.colour);
  }
  StageTimer::Scope scope(timer_, "objects.mapping");
  mapper_.Observe(tracks, image, *camera_, tracked);
}

void ObjectStage::FollowGraph(const KeyframeGraph& graph) { mapper_.FollowGraph(graph); }

void ObjectStage::Write(const std::string& folder) {
  WriteObjectMap(std::filesystem::path(folder) / "objects.json", Objects(), *vocabulary_);
}

MappingStage::Counts ObjectStage::counts() const {
  return {{"detections", detections_}, {"objects", Objects().objects.size()}};
}

}  // namespace semantic_slam
