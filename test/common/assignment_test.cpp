#include "semantic_slam/common/assignment.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// The most that any pairing can save, by trying all of them.
double BestSavingByTrial(const Eigen::MatrixXd& cost, double limit, int row = 0,
                         unsigned used_columns = 0) {
  if (row == cost.rows()) return 0.0;
  double best = BestSavingByTrial(cost, limit, row + 1, used_columns);
  for (int j = 0; j < cost.cols(); ++j) {
    if ((used_columns >> j & 1u) != 0 || !(cost(row, j) < limit)) continue;
    best = std::max(best, limit - cost(row, j) +
                              BestSavingByTrial(cost, limit, row + 1, used_columns | 1u << j));
  }
  return best;
}

double Saving(const Eigen::MatrixXd& cost, double limit) {
  double sum = 0.0;
  int last_row = -1;
  std::vector<char> used(cost.cols(), 0);
  for (const AssignedPair& pair : AssignAtLeastCost(cost, limit)) {
    EXPECT_GT(pair.row, last_row);
    EXPECT_FALSE(used[pair.column]);
    EXPECT_LT(cost(pair.row, pair.column), limit);
    last_row = pair.row;
    used[pair.column] = 1;
    sum += limit - cost(pair.row, pair.column);
  }
  return sum;
}

TEST(AssignmentTest, NoOtherPairingSavesMore) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> cost_of(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const int rows = 1 + static_cast<int>(random() % 5),
              columns = 1 + static_cast<int>(random() % 6);
    const Eigen::MatrixXd cost =
        Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return cost_of(random); });
    for (const double limit : {0.2, 0.5, 2.0}) {
      // Sums of a few numbers of size 1: rounding only.
      EXPECT_NEAR(Saving(cost, limit), BestSavingByTrial(cost, limit), 1e-12);
    }
  }
}

TEST(AssignmentTest, TheGreedyChoiceIsNotTheBest) {
  Eigen::MatrixXd cost(2, 2);
  cost << 0.1, 0.2,  //
      0.2, 0.9;
  const auto pairs = AssignAtLeastCost(cost, 1.0);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].column, 1);
  EXPECT_EQ(pairs[1].column, 0);
}

TEST(AssignmentTest, PairsBeyondTheLimitAreNone) {
  Eigen::MatrixXd cost(2, 3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  cost << 0.5, nan, infinity,  //
      0.7, 0.5, 0.4;
  const auto pairs = AssignAtLeastCost(cost, 0.5);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].row, 1);
  EXPECT_EQ(pairs[0].column, 2);
}

TEST(AssignmentTest, EqualCostsAlwaysGiveTheSamePairs) {
  const Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(7, 4);
  const auto pairs = AssignAtLeastCost(cost, 1.0);
  ASSERT_EQ(pairs.size(), 4u);
  const auto again = AssignAtLeastCost(cost, 1.0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].row, again[i].row);
    EXPECT_EQ(pairs[i].column, again[i].column);
  }
}

TEST(AssignmentTest, NothingCanBePairedWithNothing) {
  EXPECT_TRUE(AssignAtLeastCost(Eigen::MatrixXd(0, 0), 1.0).empty());
  EXPECT_TRUE(AssignAtLeastCost(Eigen::MatrixXd(3, 0), 1.0).empty());
  EXPECT_TRUE(AssignAtLeastCost(Eigen::MatrixXd(0, 3), 1.0).empty());
}

}  // namespace
}  // namespace semantic_slam
