#include "semantic_slam/network_evaluation/example_choice.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {

std::vector<Example> ChooseExamples(const std::vector<double>& scores) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    if (!std::isnan(scores[i])) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  std::vector<Example> examples;
  const auto add = [&](const char* name, std::size_t index) {
    const bool is_new = std::none_of(examples.begin(), examples.end(),
                                     [&](const Example& other) { return other.index == index; });
    if (is_new) examples.push_back({name, index, scores[index]});
  };
  if (order.empty()) return examples;
  add("best", order.front());
  add("median", order[order.size() / 2]);
  const double lowest = scores[order.back()];
  add("worst", *std::find_if(order.begin(), order.end(),
                             [&](std::size_t i) { return scores[i] == lowest; }));
  return examples;
}

}  // namespace semantic_slam
