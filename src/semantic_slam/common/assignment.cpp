#include "semantic_slam/common/assignment.h"

#include <algorithm>
#include <limits>

namespace semantic_slam {
namespace {

constexpr int kFree = -1;

// Assigns every row of a matrix that has at least as many columns as rows.
class RowAssigner {
 public:
  explicit RowAssigner(const Eigen::MatrixXd& cost)
      : cost_(cost),
        row_potential_(cost.rows(), 0.0),
        column_potential_(cost.cols(), 0.0),
        row_of_column_(cost.cols(), kFree),
        previous_column_(cost.cols(), kFree) {}

  // The row of every column, or kFree.
  const std::vector<int>& Run() {
    for (int row = 0; row < cost_.rows(); ++row) Augment(row, ShortestPathToFreeColumn(row));
    return row_of_column_;
  }

 private:
  // Grows a tree of alternating paths from `start_row` (Dijkstra over reduced costs) until it
  // reaches a column without row, and shifts the potentials so that the tree's edges cost nothing.
  int ShortestPathToFreeColumn(int start_row) {
    const int columns = static_cast<int>(cost_.cols());
    std::vector<double> distance(columns, std::numeric_limits<double>::infinity());
    std::vector<char> in_tree(columns, 0);
    std::vector<int> tree;  // columns, in the order in which they joined
    int row = start_row, column = kFree;
    double reached = 0.0;
    do {
      const int from = column;
      int nearest = kFree;
      for (int j = 0; j < columns; ++j) {
        if (in_tree[j]) continue;
        const double length = reached + cost_(row, j) - row_potential_[row] - column_potential_[j];
        if (length < distance[j]) {
          distance[j] = length;
          previous_column_[j] = from;
        }
        if (nearest == kFree || distance[j] < distance[nearest]) nearest = j;
      }
      column = nearest;
      reached = distance[column];
      in_tree[column] = 1;
      tree.push_back(column);
      row = row_of_column_[column];
    } while (row != kFree);
    row_potential_[start_row] += reached;
    for (const int j : tree) {
      const double slack = reached - distance[j];
      column_potential_[j] -= slack;
      if (row_of_column_[j] != kFree) row_potential_[row_of_column_[j]] += slack;
    }
    return column;
  }

  // Moves every row on the path to `column` one column on, which frees one for `start_row`.
  void Augment(int start_row, int column) {
    while (previous_column_[column] != kFree) {
      row_of_column_[column] = row_of_column_[previous_column_[column]];
      column = previous_column_[column];
    }
    row_of_column_[column] = start_row;
  }

  const Eigen::MatrixXd& cost_;
  std::vector<double> row_potential_;
  std::vector<double> column_potential_;
  std::vector<int> row_of_column_;
  std::vector<int> previous_column_;  // on the path from the row that is being assigned
};

}  // namespace

std::vector<AssignedPair> AssignAtLeastCost(const Eigen::MatrixXd& cost, double cost_limit) {
  if (cost.size() == 0) return {};
  // A pair that saves nothing is as good as none.
  const auto saving_or_none = [&](double c) { return c < cost_limit ? c - cost_limit : 0.0; };
  const bool transposed = cost.rows() > cost.cols();
  Eigen::MatrixXd gain = cost.unaryExpr(saving_or_none);
  if (transposed) gain.transposeInPlace();
  const std::vector<int> row_of_column = RowAssigner(gain).Run();
  std::vector<AssignedPair> pairs;
  for (int j = 0; j < static_cast<int>(row_of_column.size()); ++j) {
    const int i = row_of_column[j];
    if (i == kFree || !(gain(i, j) < 0.0)) continue;
    pairs.push_back(transposed ? AssignedPair{j, i} : AssignedPair{i, j});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const AssignedPair& a, const AssignedPair& b) { return a.row < b.row; });
  return pairs;
}

}  // namespace semantic_slam
