#include "semantic_slam/control/limited_norm.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(LimitedNormTest, ShortensWhatIsLonger) {
  EXPECT_TRUE(LimitedNorm({3, 0, 4}, 2.5).isApprox(Eigen::Vector3d(1.5, 0, 2)));
  EXPECT_EQ(LimitedNorm({3, 0, 4}, 5.0), Eigen::Vector3d(3, 0, 4));
  EXPECT_EQ(LimitedNorm({0, 0, 0}, 1.0), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace semantic_slam
