#pragma once

#include <functional>
#include <memory>
#include <string>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/detection/detector.h"
#include "semantic_slam/object_mapping/object_mapper.h"
#include "semantic_slam/object_tracking/object_tracker.h"
#include "tools/mapping_stage.h"

namespace semantic_slam {

struct ObjectStageOptions {
  NetworkOptions network;
  DetectorOptions detector;
  ObjectTrackingOptions object_tracking;
  ObjectMappingOptions object_mapping;

  // Boxes that the tracker would look at must reach it: the unsure ones keep tracks alive.
  ObjectStageOptions() { detector.min_confidence = object_tracking.tracker.low_confidence; }
};

// Reads the groups detection, object_tracking and object_mapping of a configuration file.
void ReadObjectStageOptions(YamlReader& file, ObjectStageOptions& options);

// Finds objects in an image. May throw InputError.
using DetectObjects = std::function<Detections(const RgbdImage&)>;

// Thesis sections 3.4.1 and 3.4.3: detection, object tracking, object mapping. Leaves objects.json.
class ObjectStage : public MappingStage {
 public:
  // Throws ConfigError as its parts do. `timer` must outlive this.
  ObjectStage(const ObjectStageOptions& options, DetectObjects detect,
              std::shared_ptr<const LabelVocabulary> vocabulary,
              std::shared_ptr<const CameraModel> camera, StageTimer& timer);

  const char* name() const override { return "objects"; }
  void Process(const RgbdImage& image, const TrackedImage& tracked) override;
  void FollowGraph(const KeyframeGraph& graph) override;
  void Write(const std::string& folder) override;
  Counts counts() const override;

  ObjectMap Objects() const { return mapper_.Objects(); }

 private:
  const std::shared_ptr<const LabelVocabulary> vocabulary_;
  const std::shared_ptr<const CameraModel> camera_;
  StageTimer& timer_;
  const DetectObjects detect_;
  ObjectTracker tracker_;
  ObjectMapper mapper_;
  std::size_t detections_ = 0;
};

}  // namespace semantic_slam
