#include "semantic_slam/tracking/readout_estimator.h"

#include <limits>

#include <gtest/gtest.h>

#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

// What an image says that knows the readout time to `sigma_s`.
ReadoutEvidence Evidence(double true_s, double present_s, double sigma_s) {
  const double information = 1.0 / (sigma_s * sigma_s);
  return {information, information * (true_s - present_s)};
}

double LearnFrom(ReadoutEstimator& estimator, double true_s, int images) {
  for (int i = 0; i < images; ++i) {
    estimator.Add(Evidence(true_s, estimator.readout_s(), 0.004));
  }
  return estimator.readout_s();
}

TEST(ReadoutEstimatorTest, FindsTheReadoutTime) {
  ReadoutEstimator estimator(ReadoutOptions(), 0.0);
  EXPECT_NEAR(LearnFrom(estimator, 0.02, 100), 0.02, 0.001);  // a twentieth is left of the way
}

TEST(ReadoutEstimatorTest, FollowsAChangeOfDirection) {
  ReadoutEstimator estimator(ReadoutOptions(), 0.02);
  LearnFrom(estimator, 0.02, 1000);
  EXPECT_NEAR(LearnFrom(estimator, -0.02, 3000), -0.02, 0.002);
}

TEST(ReadoutEstimatorTest, WeakEvidenceMovesItLittle) {
  ReadoutEstimator estimator(ReadoutOptions(), 0.0);
  estimator.Add(Evidence(0.05, 0.0, 0.1));  // a camera that hardly turns
  EXPECT_LT(estimator.readout_s(), 1e-3);
}

TEST(ReadoutEstimatorTest, WithoutLearningItIsAsGiven) {
  ReadoutOptions options;
  options.learn = false;
  ReadoutEstimator estimator(options, 0.01);
  EXPECT_TRUE(estimator.is_rolling());
  EXPECT_EQ(LearnFrom(estimator, 0.02, 100), 0.01);
  EXPECT_FALSE(ReadoutEstimator(options, 0.0).is_rolling());
}

TEST(ReadoutEstimatorTest, IgnoresEvidenceThatIsNone) {
  ReadoutEstimator estimator(ReadoutOptions(), 0.01);
  estimator.Add({0.0, 1.0});
  estimator.Add({1e6, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_EQ(estimator.readout_s(), 0.01);
}

TEST(ReadoutEstimatorTest, ResetBeginsAnew) {
  ReadoutEstimator estimator(ReadoutOptions(), 0.0);
  LearnFrom(estimator, 0.02, 100);
  estimator.Reset(0.005);
  EXPECT_EQ(estimator.readout_s(), 0.005);
}

TEST(ReadoutEstimatorTest, RefusesOptionsByName) {
  ReadoutOptions options;
  options.evidence_share = 2.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ReadoutEstimator(options, 0.0); }).substr(0, 18),
            "evidence_share = 2");
}

}  // namespace
}  // namespace semantic_slam
