#include "tools/semantic_stage.h"

#include <array>
#include <filesystem>
#include <utility>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/octree/map_export.h"
#include "semantic_slam/octree/map_picture.h"
#include "semantic_slam/octree/voxel_view.h"
#include "semantic_slam/segmentation/segmentation_overlay.h"
#include "tools/overview_figure.h"

namespace semantic_slam {
namespace {

constexpr double kNoticeableShare = 0.03;   // of the pixels
constexpr double kCloudResolutionM = 0.02;  // of the overview's cloud
constexpr double kStepBackM = 0.4;          // from where the overview looks at cloud and map

int NoticeableClasses(const Segmentation& segmentation) {
  std::array<int, 256> pixels{};
  const cv::Mat& labels = segmentation.labels[0];
  for (int v = 0; v < labels.rows; ++v) {
    const auto* row = labels.ptr<LabelId>(v);
    for (int u = 0; u < labels.cols; ++u) ++pixels[row[u]];
  }
  int classes = 0;
  for (int id = 1; id < 256; ++id) classes += pixels[id] > kNoticeableShare * labels.total();
  return classes;
}

// How good an example an image is: it shows several classes, the network is sure of them, and most of
// it has depth.
double ExampleScore(const Segmentation& segmentation, const SemanticCloud& cloud) {
  const double confidence = cv::mean(segmentation.confidences[0])[0] / 255.0;
  return NoticeableClasses(segmentation) * confidence * static_cast<double>(cloud.points.size());
}

cv::Mat ToBgr(const RgbdImage& image) {
  if (image.order == ColourOrder::kBgr) return image.colour;
  cv::Mat bgr;
  cv::cvtColor(image.colour, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

// A little behind the camera, so that more than the camera's own view is seen.
Rigid3d SteppedBack(const Rigid3d& T_map_camera) {
  return T_map_camera * Eigen::Translation3d(0.0, 0.0, -kStepBackM);
}

std::vector<Eigen::Vector3d> Positions(const KeyframeGraph& graph) {
  std::vector<Eigen::Vector3d> positions;
  for (const KeyframeNode& node : graph.keyframes) {
    if (!node.culled) positions.push_back(node.T_map_keyframe.translation());
  }
  return positions;
}

// A graph of one keyframe, which is where the camera was.
KeyframeGraph GraphOf(const TrackedImage& image) {
  KeyframeNode node;
  node.id = image.keyframe_id;
  node.stamp = image.stamp;
  node.T_map_keyframe = image.T_map_camera * image.T_keyframe_camera.inverse();
  KeyframeGraph graph;
  graph.map_id = image.map_id;
  graph.keyframes = {node};
  return graph;
}

}  // namespace

void ReadSemanticStageOptions(YamlReader& file, SemanticStageOptions& options) {
  file.ReadOptions("segmentation", options.segmentation);
  file.ReadOptions("semantic_cloud", options.semantic_cloud);
  ReadOptionGroups(file, "octomap", options.octomap);
}

SemanticStage::SemanticStage(const SemanticStageOptions& options, SegmentImage segment,
                             std::shared_ptr<const LabelVocabulary> vocabulary,
                             std::shared_ptr<const CameraModel> camera, StageTimer& timer)
    : options_(options),
      vocabulary_(std::move(vocabulary)),
      camera_(std::move(camera)),
      timer_(timer),
      segment_(std::move(segment)),
      cloud_builder_(options.semantic_cloud, camera_),
      mapper_(options.octomap, vocabulary_) {}

void SemanticStage::Process(const RgbdImage& image, const TrackedImage& tracked) {
  Segmentation segmentation;
  {
    StageTimer::Scope scope(timer_, "semantic.segmentation");
    segmentation = segment_(image);
  }
  SemanticCloud cloud;
  {
    StageTimer::Scope scope(timer_, "semantic.cloud");
    cloud = cloud_builder_.Build(image, segmentation);
  }
  {
    StageTimer::Scope scope(timer_, "semantic.octree");
    mapper_.Insert(cloud, tracked);
  }
  ConsiderAsExample(image, tracked, segmentation, cloud);
}

void SemanticStage::FollowGraph(const KeyframeGraph& graph) {
  StageTimer::Scope scope(timer_, "semantic.follow_graph");
  mapper_.FollowGraph(graph);
  graph_ = graph;
}

void SemanticStage::Write(const std::string& folder) {
  const std::filesystem::path out(folder);
  WriteMapFiles(out / "semantic_map", mapper_.tree(), *vocabulary_);
  MapPictureOptions picture;
  picture.camera_path_m = Positions(graph_);
  WriteMapFromAbove(out / "map_top.png", mapper_.tree(), *vocabulary_, picture);
  if (!example_) return;
  const cv::Mat overview = Overview(*example_);
  WriteFileAtomicallyVia(out / "overview.png",
                         [&](const std::string& path) { return cv::imwrite(path, overview); });
}

MappingStage::Counts SemanticStage::counts() const {
  const SemanticMapper::Counts& counts = mapper_.counts();
  return {{"clouds", counts.inserted},
          {"rebuilds", counts.rebuilds},
          {"dropped_unknown_keyframe", counts.unknown_keyframe},
          {"dropped_lost_keyframe", counts.lost_keyframe},
          {"nodes", mapper_.tree().size()}};
}

void SemanticStage::ConsiderAsExample(const RgbdImage& image, const TrackedImage& tracked,
                                      const Segmentation& segmentation,
                                      const SemanticCloud& cloud) {
  const double score = ExampleScore(segmentation, cloud);
  if (example_ && score <= example_->score) return;
  example_ = Example{image, tracked, segmentation, cloud, score};
}

cv::Mat SemanticStage::Overview(const Example& example) const {
  const VoxelColours colours(ColourMode::kClass, *vocabulary_);
  const cv::Mat map = RenderVoxels(mapper_.tree(), colours, camera_->intrinsics(),
                                   SteppedBack(PoseOf(example.tracked)));
  const cv::Mat camera = ToBgr(example.image);
  return ComposeFigure(
      {{"camera", camera},
       {"segmentation",
        DrawSegmentation(camera, ColourOrder::kBgr, example.segmentation, *vocabulary_)},
       {"semantic cloud", DrawCloud(example)},
       {"semantic map", map}},
      2);
}

// The cloud alone as small voxels.
cv::Mat SemanticStage::DrawCloud(const Example& example) const {
  SemanticMapperOptions options = options_.octomap;
  options.map.resolution_m = kCloudResolutionM;
  SemanticMapper mapper(options, vocabulary_);
  mapper.FollowGraph(GraphOf(example.tracked));
  mapper.Insert(example.cloud, example.tracked);
  return RenderVoxels(mapper.tree(), VoxelColours(ColourMode::kClass, *vocabulary_),
                      camera_->intrinsics(), SteppedBack(example.tracked.T_map_camera));
}

Rigid3d SemanticStage::PoseOf(const TrackedImage& tracked) const {
  const auto T_map_keyframe = KeyframePoses(graph_).Find(tracked.keyframe_id);
  return T_map_keyframe ? *T_map_keyframe * tracked.T_keyframe_camera : tracked.T_map_camera;
}

}  // namespace semantic_slam
