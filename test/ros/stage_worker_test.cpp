#include "semantic_slam_ros/stage_worker.h"

#include <condition_variable>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

// Holds the worker at its first item until it is opened.
class Gate {
 public:
  void Pass() {
    std::unique_lock<std::mutex> lock(mutex_);
    reached_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return open_; });
  }
  void AwaitReached() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return reached_; });
  }
  void Open() {
    std::lock_guard<std::mutex> lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool reached_ = false;
  bool open_ = false;
};

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
