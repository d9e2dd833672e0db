#include "semantic_slam_ros/map_worker.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ros/gate.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::KeyframeGraph;

KeyframeGraph GraphOf(std::uint64_t revision) {
  KeyframeGraph graph;
  graph.revision = revision;
  return graph;
}

// Notes what the worker does; the first thing that is seen, 0, holds it at the gate.
class MapWorkerTest : public testing::Test {
 protected:
  // Holds the worker, so that what follows has to wait.
  void Hold() {
    worker_->Add({0});
    gate_.AwaitReached();
  }

  // What was done, up to the worker's end.
  std::vector<std::string> Finish() {
    gate_.Open();
    worker_.reset();
    return done_;
  }

  DropCounter drops_;
  Gate gate_;
  std::vector<std::string> done_;
  std::unique_ptr<MapWorker<int>> worker_ = std::make_unique<MapWorker<int>>(
      2, drops_,
      MapWorker<int>::Handlers{[this](const KeyframeGraph& graph) {
                                 done_.push_back("graph " + std::to_string(graph.revision));
                               },
                               [this](const int& seen) {
                                 if (seen == 0) gate_.Pass();
                                 done_.push_back("seen " + std::to_string(seen));
                               },
                               [this] { done_.push_back("publish"); }});
};

TEST_F(MapWorkerTest, FollowsTheNewestGraphBeforeItTakesIn) {
  Hold();
  worker_->Add({1});
  worker_->Follow(GraphOf(7));
  worker_->Follow(GraphOf(8));
  worker_->Add({2});
  EXPECT_EQ(Finish(), (std::vector<std::string>{"seen 0", "graph 8", "seen 1", "seen 2"}));
  EXPECT_TRUE(drops_.counts().empty());
}

TEST_F(MapWorkerTest, CountsTheOldOnesThatHadToGoAsLate) {
  Hold();
  worker_->Follow(GraphOf(3));
  worker_->Add({1, 2, 3});
  worker_->Add({4});
  EXPECT_EQ(Finish(), (std::vector<std::string>{"seen 0", "graph 3", "seen 3", "seen 4"}));
  EXPECT_EQ(drops_.counts()["late"], 2u);
}

TEST_F(MapWorkerTest, ClearForgetsWhatWaitsButNotTheGraph) {
  Hold();
  worker_->Add({1});
  worker_->Follow(GraphOf(3));
  worker_->Clear();
  EXPECT_EQ(Finish(), (std::vector<std::string>{"seen 0", "graph 3"}));
  EXPECT_TRUE(drops_.counts().empty());
}

TEST_F(MapWorkerTest, PublishesOnceWhenItHasTakenInWhatItWasAt) {
  Hold();
  worker_->Publish();
  worker_->Publish();
  worker_->Add({1});
  EXPECT_EQ(Finish(), (std::vector<std::string>{"seen 0", "publish", "seen 1"}));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
