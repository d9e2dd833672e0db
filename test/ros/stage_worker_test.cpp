#include "semantic_slam_ros/stage_worker.h"

#include <vector>

#include <gtest/gtest.h>

#include "ros/gate.h"

namespace semantic_slam_ros {
namespace {

TEST(StageWorkerTest, WorksOffWhatIsPushed) {
  DropCounter drops;
  std::vector<int> done;
  {
    StageWorker<int> worker(10, drops, [&](int item) { done.push_back(item); });
    for (int i = 0; i < 5; ++i) worker.Push(i);
  }
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(drops.counts().empty());
}

TEST(StageWorkerTest, CountsTheOldOnesThatHadToGoAsLate) {
  DropCounter drops;
  Gate gate;
  std::vector<int> done;
  {
    StageWorker<int> worker(2, drops, [&](int item) {
      gate.Pass();
      done.push_back(item);
    });
    worker.Push(0);
    gate.AwaitReached();
    for (int i = 1; i <= 4; ++i) worker.Push(i);
    gate.Open();
  }
  EXPECT_EQ(done, (std::vector<int>{0, 3, 4}));
  EXPECT_EQ(drops.counts()["late"], 2u);
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
