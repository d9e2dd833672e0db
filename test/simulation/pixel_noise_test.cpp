#include "semantic_slam/simulation/pixel_noise.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr int kPixels = 100000;

TEST(PixelNoiseTest, NumbersAreNormallyDistributedAndIndependent) {
  const PixelNoise noise(1, Stamp{1000});
  double sum[PixelNoise::kGaussians] = {}, squares[PixelNoise::kGaussians] = {}, product = 0.0;
  for (int pixel = 0; pixel < kPixels; ++pixel) {
    const std::uint64_t bits = noise.Bits(pixel);
    for (int i = 0; i < PixelNoise::kGaussians; ++i) {
      const double x = PixelNoise::Gaussian(bits, i);
      sum[i] += x;
      squares[i] += x * x;
    }
    product += PixelNoise::Gaussian(bits, 0) * PixelNoise::Gaussian(bits, 1);
  }
  for (int i = 0; i < PixelNoise::kGaussians; ++i) {
    // Five standard deviations of the estimates from 100000.
    EXPECT_NEAR(sum[i] / kPixels, 0.0, 0.016);
    EXPECT_NEAR(squares[i] / kPixels, 1.0, 0.022);
  }
  EXPECT_NEAR(product / kPixels, 0.0, 0.016);
}

TEST(PixelNoiseTest, UniformNumbersFillTheirInterval) {
  const PixelNoise noise(1, Stamp{1000});
  double sum = 0.0;
  for (int pixel = 0; pixel < kPixels; ++pixel) {
    const float u = PixelNoise::Uniform(noise.Bits(pixel));
    ASSERT_GE(u, 0.0f);
    ASSERT_LT(u, 1.0f);
    sum += u;
  }
  EXPECT_NEAR(sum / kPixels, 0.5, 0.005);  // five standard deviations
}

TEST(PixelNoiseTest, SeedAndStampDecide) {
  const PixelNoise noise(1, Stamp{1000});
  EXPECT_EQ(noise.Bits(7), PixelNoise(1, Stamp{1000}).Bits(7));
  EXPECT_NE(noise.Bits(7), noise.Bits(8));
  EXPECT_NE(noise.Bits(7), PixelNoise(2, Stamp{1000}).Bits(7));
  EXPECT_NE(noise.Bits(7), PixelNoise(1, Stamp{1001}).Bits(7));
}

}  // namespace
}  // namespace semantic_slam
