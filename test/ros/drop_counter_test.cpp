#include "semantic_slam_ros/drop_counter.h"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

TEST(DropCounterTest, CountsByCause) {
  DropCounter drops;
  EXPECT_TRUE(drops.counts().empty());
  drops.Add("bad_image", "the image is empty");
  drops.Add("bad_image", "the image is empty");
  drops.AddQuietly("unpaired_depth", 3);
  EXPECT_EQ(drops.counts(),
            (std::map<std::string, std::size_t>{{"bad_image", 2}, {"unpaired_depth", 3}}));
}

TEST(DropCounterTest, CountsFromManyThreads) {
  DropCounter drops;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&drops] {
      for (int i = 0; i < 1000; ++i) drops.AddQuietly("late");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(drops.counts()["late"], 4000u);
}

}  // namespace
}  // namespace semantic_slam_ros
