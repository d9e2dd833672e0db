#include "semantic_slam/localization/mapping_pipeline.h"

#include <mutex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// The parameter is how the pipeline works.
class MappingPipelineTest : public testing::TestWithParam<MappingMode> {
 protected:
  KeyframeId AddKeyframe(int image) {
    const Rigid3d T_world_camera = HandheldPath::T_world_camera(3.0 + 0.1 * image);
    const Stamp stamp{1'000'000'000'000 + 100'000'000 * static_cast<std::int64_t>(image)};
    std::lock_guard<std::mutex> lock(map_.mutex());
    return AddKeyframeWithPoints(map_, SmallRoomFeatures(T_world_camera, stamp), T_world_camera);
  }

  Map map_{SmallExtractor().scales()};
  PlaceIndex index_{PlaceIndexOptions()};
  StageTimer timer_;
  MappingPipeline pipeline_{
      LocalMapperOptions(), LoopCloserOptions(), SmallCamera(), map_, index_, timer_, GetParam()};
};

TEST_P(MappingPipelineTest, WorksKeyframesOff) {
  std::set<KeyframeId> keyframes;
  for (int i = 0; i < 4; ++i) {
    keyframes.insert(AddKeyframe(i));
    pipeline_.Add(*keyframes.rbegin());
    if (GetParam() == MappingMode::kInline) {
      EXPECT_TRUE(pipeline_.HasRoom());
      EXPECT_EQ(index_.Keyframes(), keyframes);
    }
    pipeline_.Finish();
    EXPECT_TRUE(pipeline_.HasRoom());
  }
  EXPECT_EQ(index_.Keyframes(), keyframes);  // loop closing comes last
  EXPECT_EQ(map_.revision(), 4u);
  EXPECT_EQ(pipeline_.loops(), 0u);
  std::set<std::string> stages;
  for (const StageTiming& timing : timer_.Timings()) stages.insert(timing.stage);
  EXPECT_EQ(stages.count("local_mapping"), 1u);
  EXPECT_EQ(stages.count("loop_closing.detect"), 1u);
}

TEST_P(MappingPipelineTest, ForgetsAMapAndKnowsAnother) {
  pipeline_.Add(AddKeyframe(0));
  pipeline_.Finish();
  map_.Clear();
  pipeline_.Reset(SmallCamera());
  EXPECT_TRUE(index_.Keyframes().empty());
  const KeyframeId next = AddKeyframe(1);
  pipeline_.KnowMap(SmallCamera());
  EXPECT_EQ(index_.Keyframes(), std::set<KeyframeId>{next});
}

TEST_P(MappingPipelineTest, AKeyframeThatIsGoneDoesNoHarm) {
  pipeline_.Add(12345);
  pipeline_.Finish();
  EXPECT_TRUE(pipeline_.HasRoom());
  EXPECT_TRUE(index_.Keyframes().empty());
}

TEST_P(MappingPipelineTest, RefusesOptionsOutOfRange) {
  LocalMapperOptions options;
  options.window_keyframes = 1;
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              MappingPipeline(options, LoopCloserOptions(), SmallCamera(), map_, index_, timer_,
                              GetParam());
            }),
            "window_keyframes = 1, but must be in [2, 200]");
}

INSTANTIATE_TEST_SUITE_P(Modes, MappingPipelineTest,
                         testing::Values(MappingMode::kInline, MappingMode::kThreaded),
                         [](const auto& mode) {
                           return mode.param == MappingMode::kInline ? "Inline" : "Threaded";
                         });

}  // namespace
}  // namespace semantic_slam
