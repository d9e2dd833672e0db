#include "semantic_slam_ros/graph_input.h"

#include <vector>

#include <gtest/gtest.h>

#include "ros/ros_testing.h"
#include "semantic_slam_ros/tracking_conversions.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::KeyframeGraph;
using semantic_slam::Stamp;
using semantic_slam::TrackedImage;
using GraphMsg = semantic_slam::KeyframeArray;
using StateMsg = semantic_slam::TrackingState;

constexpr double kLimitS = 10.0;

StateMsg StateAt(double seconds) {
  TrackedImage image;
  image.stamp = Stamp::FromSeconds(seconds);
  image.status = semantic_slam::TrackingStatus::kTracking;
  image.keyframe_id = 0;
  return ToTrackingState(image, "map", "camera");
}

GraphMsg GraphOf(int keyframes) {
  KeyframeGraph graph;
  for (int i = 0; i < keyframes; ++i) {
    graph.keyframes.emplace_back();
    graph.keyframes.back().id = i;
  }
  return ToKeyframeArray(graph, "map");
}

class GraphInputTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] { return state_pub_.getNumSubscribers() == 1 && graph_pub_.getNumSubscribers() == 1; },
        kLimitS));
  }

  ros::NodeHandle nh_;
  DropCounter drops_;
  std::vector<TrackedImage> tracked_;
  std::vector<KeyframeGraph> graphs_;
  const GraphInput input_{nh_, drops_,
                          [this](const TrackedImage& image) { tracked_.push_back(image); },
                          [this](KeyframeGraph graph) { graphs_.push_back(std::move(graph)); }};
  ros::Publisher state_pub_ = nh_.advertise<StateMsg>("tracking_state", 1000);
  ros::Publisher graph_pub_ = nh_.advertise<GraphMsg>("keyframes", 10);
};

TEST_F(GraphInputTest, HandsOverEveryStateEvenIfTheNodeWasBusy) {
  for (int i = 1; i <= 500; ++i) state_pub_.publish(StateAt(i));
  ASSERT_TRUE(SpinUntil([&] { return tracked_.size() == 500; }, kLimitS)) << tracked_.size();
  EXPECT_EQ(tracked_.back().stamp, Stamp::FromSeconds(500));
}

TEST_F(GraphInputTest, HandsOverTheGraph) {
  graph_pub_.publish(GraphOf(3));
  ASSERT_TRUE(SpinUntil([&] { return !graphs_.empty(); }, kLimitS));
  EXPECT_EQ(graphs_[0].keyframes.size(), 3u);
}

TEST_F(GraphInputTest, CountsWhatIsMalformedAndGoesOn) {
  StateMsg bad_state = StateAt(1.0);
  bad_state.state = 7;
  state_pub_.publish(bad_state);
  GraphMsg bad_graph = GraphOf(2);
  bad_graph.keyframes[1].id = 0;
  graph_pub_.publish(bad_graph);
  state_pub_.publish(StateAt(2.0));
  graph_pub_.publish(GraphOf(1));
  ASSERT_TRUE(SpinUntil([&] { return tracked_.size() == 1 && graphs_.size() == 1; }, kLimitS));
  EXPECT_EQ(drops_.counts(),
            (std::map<std::string, std::size_t>{{"bad_keyframes", 1}, {"bad_tracking_state", 1}}));
}

TEST(GraphInputTopicsTest, SubscribesToWhatIsAskedFor) {
  ros::NodeHandle nh("apart");
  DropCounter drops;
  const GraphInput input(nh, drops, [](const TrackedImage&) {}, {});
  const auto state_pub = nh.advertise<StateMsg>("tracking_state", 1);
  const auto graph_pub = nh.advertise<GraphMsg>("keyframes", 1);
  EXPECT_TRUE(SpinUntil([&] { return state_pub.getNumSubscribers() == 1; }, kLimitS));
  EXPECT_EQ(graph_pub.getNumSubscribers(), 0u);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "graph_input_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
