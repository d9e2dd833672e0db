#include "semantic_slam/dataset/prefetching_source.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr std::int64_t kForever = 1'000'000'000;

// Counts what it hands out; "drops" one pair before every tenth; may throw at one place.
class CountingSource : public RgbdSource {
 public:
  CountingSource(std::int64_t images, std::atomic<std::int64_t>& decoded,
                 std::int64_t throw_at = -1)
      : images_(images), throw_at_(throw_at), decoded_(decoded) {}

  std::size_t size() const override { return static_cast<std::size_t>(images_); }
  std::optional<RgbdImage> Next() override {
    if (next_ == throw_at_) throw std::runtime_error("disk failed");
    if (next_ == images_) return std::nullopt;
    if (next_ % 10 == 0) problems_.push_back("before " + std::to_string(next_));
    RgbdImage image;
    image.stamp.ns = next_++;
    ++decoded_;
    return image;
  }
  const std::vector<std::string>& problems() const override { return problems_; }
  std::size_t dropped() const override { return problems_.size(); }
  const std::vector<AccelerometerReading>& accelerometer() const override { return accelerometer_; }
  std::optional<Eigen::Matrix3d> R_camera_imu() const override {
    return Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  }

 private:
  const std::int64_t images_;
  const std::int64_t throw_at_;
  std::atomic<std::int64_t>& decoded_;
  std::int64_t next_ = 0;
  std::vector<std::string> problems_;
  const std::vector<AccelerometerReading> accelerometer_{{Stamp{1}, Eigen::Vector3d::Zero()}};
};

class PrefetchingSourceTest : public testing::Test {
 protected:
  std::unique_ptr<RgbdSource> Counting(std::int64_t images, std::int64_t throw_at = -1) {
    return std::make_unique<CountingSource>(images, decoded_, throw_at);
  }

  // Waits until the reader stands still, as it must with nobody taking images.
  std::int64_t DecodedWhenStill() const {
    std::int64_t before = -1;
    while (before != decoded_) {
      before = decoded_;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return before;
  }

  std::atomic<std::int64_t> decoded_{0};
};

TEST_F(PrefetchingSourceTest, KeepsOrderAndEnds) {
  PrefetchingSource source(Counting(1000));
  EXPECT_EQ(source.size(), 1000u);
  for (std::int64_t i = 0; i < 1000; ++i) ASSERT_EQ(source.Next()->stamp.ns, i);
  EXPECT_FALSE(source.Next());
  EXPECT_FALSE(source.Next());
}

TEST_F(PrefetchingSourceTest, IsAtMostEightAhead) {
  PrefetchingSource source(Counting(kForever));
  EXPECT_EQ(DecodedWhenStill(), 8);
  for (int i = 0; i < 5; ++i) source.Next();
  EXPECT_EQ(DecodedWhenStill(), 13);
}

TEST_F(PrefetchingSourceTest, StopsWhenDestroyedBeforeTheEnd) {
  for (int taken = 0; taken < 20; ++taken) {
    PrefetchingSource source(Counting(kForever));
    for (int i = 0; i < taken; ++i) source.Next();
  }
}

TEST_F(PrefetchingSourceTest, CarriesTheReadersExceptionToItsPlace) {
  PrefetchingSource source(Counting(100, 3));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(source.Next());
  EXPECT_THROW(source.Next(), std::runtime_error);
  EXPECT_FALSE(source.Next());
}

TEST_F(PrefetchingSourceTest, CountsDropsAsOfTheImageReturned) {
  PrefetchingSource source(Counting(25));
  EXPECT_EQ(source.dropped(), 0u);
  DecodedWhenStill();
  source.Next();
  EXPECT_EQ(source.dropped(), 1u);
  for (int i = 1; i <= 10; ++i) source.Next();
  EXPECT_EQ(source.dropped(), 2u);
  EXPECT_EQ(source.problems().back(), "before 10");
  while (source.Next()) continue;
  EXPECT_EQ(source.dropped(), 3u);
}

TEST_F(PrefetchingSourceTest, TellsTheReadersTime) {
  PrefetchingSource source(Counting(1000));
  EXPECT_EQ(source.cpu_s(), 0.0);
  source.Next();
  const double first_s = source.cpu_s();
  EXPECT_GT(first_s, 0.0);
  while (source.Next()) continue;
  EXPECT_GT(source.cpu_s(), first_s);
  EXPECT_LT(source.cpu_s(), 1.0);  // counting to a thousand takes a millisecond
}

TEST_F(PrefetchingSourceTest, PassesTheImuThrough) {
  const PrefetchingSource source(Counting(1));
  EXPECT_EQ(source.accelerometer().size(), 1u);
  EXPECT_TRUE(source.R_camera_imu());
}

}  // namespace
}  // namespace semantic_slam
