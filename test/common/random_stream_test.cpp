#include "semantic_slam/common/random_stream.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr int kCount = 100000;

// The reference implementation's first numbers for seed 1234567
// (prng.di.unimi.it/splitmix64.c).
TEST(RandomStreamTest, IsSplitMix64) {
  RandomStream random(1234567);
  EXPECT_EQ(random.Bits(), 6457827717110365317u);
  EXPECT_EQ(random.Bits(), 3203168211198807973u);
  EXPECT_EQ(random.Bits(), 9817491932198370423u);
}

// Tolerances are four standard deviations of the estimate.
TEST(RandomStreamTest, UniformNumbersFillTheUnitInterval) {
  RandomStream random(1);
  double sum = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.Uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / kCount, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / kCount));
}

TEST(RandomStreamTest, GaussianNumbersHaveMean0AndVariance1) {
  RandomStream random(2);
  double sum = 0.0, sum_of_squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double g = random.Gaussian();
    ASSERT_TRUE(std::isfinite(g));
    sum += g, sum_of_squares += g * g;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 4.0 / std::sqrt(kCount));
  EXPECT_NEAR(sum_of_squares / kCount, 1.0, 4.0 * std::sqrt(2.0 / kCount));
}

TEST(RandomStreamTest, HashesTellNumbersAndTheirOrderApart) {
  std::set<std::uint64_t> hashes;
  for (std::uint64_t a = 0; a < 30; ++a) {
    for (std::uint64_t b = 0; b < 30; ++b) hashes.insert(HashOf({a, b}));
  }
  EXPECT_EQ(hashes.size(), 900u);
  EXPECT_NE(HashOf({1, 2, 0}), HashOf({1, 2}));
}

}  // namespace
}  // namespace semantic_slam
