#include "semantic_octree/semantic_method.h"

#include "semantic_octree/tree_method.h"
#include "semantic_slam/octree/semantic_map.h"

namespace semantic_slam {
namespace {

constexpr int kMapId = 1;
constexpr KeyframeId kKeyframe = 0;  // all images are of this one, which is the map's origin

SemanticMapperOptions OptionsOf(const MappingSettings& settings) {
  SemanticMapperOptions options;
  options.map.resolution_m = settings.resolution_m;
  options.map.transient_classes = "";
  options.insertion.max_hit_range_m = settings.range_m;
  options.insertion.max_clear_range_m = settings.range_m;
  return options;
}

KeyframeGraph GraphOfOne() {
  KeyframeGraph graph;
  graph.map_id = kMapId;
  graph.revision = 1;
  graph.keyframes.resize(1);
  graph.keyframes[0].id = kKeyframe;
  return graph;
}

class SemanticMethod : public TreeMethod<SemanticOcTree> {
 public:
  explicit SemanticMethod(const MappingSettings& settings)
      : mapper_(OptionsOf(settings),
                std::make_shared<const LabelVocabulary>(synthetic_room::Vocabulary())) {
    mapper_.FollowGraph(GraphOfOne());
    cloud_.vocabulary_hash = mapper_.vocabulary().hash();
    image_.status = TrackingStatus::kTracking;
    image_.map_id = kMapId;
    image_.keyframe_id = kKeyframe;
  }

  void Prepare(synthetic_room::Frame& frame) override {
    cloud_.points.swap(frame.points);
    cloud_.stamp.ns = image_.stamp.ns = frame.id + 1;
  }

  void Insert(const synthetic_room::Frame& frame) override {
    image_.T_keyframe_camera = frame.T_map_camera();
    mapper_.Insert(cloud_, image_);
  }

  void Release() override { cloud_.points = {}; }

 protected:
  const SemanticOcTree& tree() const override { return mapper_.tree(); }
  LabelId LabelOf(const SemanticNode& node) const override { return node.labels().label(0); }

 private:
  SemanticMapper mapper_;
  SemanticCloud cloud_;
  TrackedImage image_;
};

}  // namespace

std::unique_ptr<MappingMethod> MakeSemanticMethod(const MappingSettings& settings) {
  return std::make_unique<SemanticMethod>(settings);
}

}  // namespace semantic_slam
