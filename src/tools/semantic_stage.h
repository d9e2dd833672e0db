#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/dnn/network.h"
#include "semantic_slam/octree/semantic_map.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/semantic_cloud/cloud_builder.h"
#include "tools/mapping_stage.h"

namespace semantic_slam {

struct SemanticStageOptions {
  NetworkOptions segmentation;
  CloudBuilderOptions semantic_cloud;
  SemanticMapperOptions octomap;
};

// Reads the groups segmentation, semantic_cloud and octomap of a configuration file.
void ReadSemanticStageOptions(YamlReader& file, SemanticStageOptions& options);

// Labels the pixels of an image. May throw InputError.
using SegmentImage = std::function<Segmentation(const RgbdImage&)>;

// The 3D branch, thesis section 3.3: segmentation, cloud, octree. Leaves semantic_map.ot,
// semantic_map_colour.ot, semantic_map.bt, semantic_map.ply, map_top.png and overview.png.
class SemanticStage : public MappingStage {
 public:
  // Throws ConfigError as its parts do. `timer` must outlive this.
  SemanticStage(const SemanticStageOptions& options, SegmentImage segment,
                std::shared_ptr<const LabelVocabulary> vocabulary,
                std::shared_ptr<const CameraModel> camera, StageTimer& timer);

  const char* name() const override { return "semantic"; }
  void Process(const RgbdImage& image, const TrackedImage& tracked) override;
  void FollowGraph(const KeyframeGraph& graph) override;
  void Write(const std::string& folder) override;
  Counts counts() const override;

 private:
  // One image that shows much, with all that was made of it: the overview's subject.
  struct Example {
    RgbdImage image;
    TrackedImage tracked;
    Segmentation segmentation;
    SemanticCloud cloud;
    double score = 0.0;  // how much it shows
  };

  void ConsiderAsExample(const RgbdImage& image, const TrackedImage& tracked,
                         const Segmentation& segmentation, const SemanticCloud& cloud);
  cv::Mat Overview(const Example& example) const;
  cv::Mat DrawCloud(const Example& example) const;
  Rigid3d PoseOf(const TrackedImage& tracked) const;

  const SemanticStageOptions options_;
  const std::shared_ptr<const LabelVocabulary> vocabulary_;
  const std::shared_ptr<const CameraModel> camera_;
  StageTimer& timer_;
  const SegmentImage segment_;
  const CloudBuilder cloud_builder_;
  SemanticMapper mapper_;
  KeyframeGraph graph_;  // the newest
  std::optional<Example> example_;
};

}  // namespace semantic_slam
