#pragma once

#include <vector>

#include <Eigen/Core>

namespace semantic_slam {

struct AssignedPair {
  int row;
  int column;
};

// Pairs rows with columns, one to one, so that what the pairs save against `cost_limit` is
// greatest: the sum of (cost_limit - cost) over all pairs. No pair costs `cost_limit` or more, or
// NaN. By ascending row; equal inputs give equal pairs, also where several solutions are equally
// good.
//
// Shortest augmenting paths with potentials (Jonker and Volgenant, Computing 38, 1987):
// O(n^2 m) for n x m costs, n the smaller.
std::vector<AssignedPair> AssignAtLeastCost(const Eigen::MatrixXd& cost, double cost_limit);

}  // namespace semantic_slam
