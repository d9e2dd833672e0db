#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace semantic_slam {

// Remembers why items of a recording were left out: how many in all, and the first few reasons, so
// that a recording of which nothing is readable does not fill the memory. Not thread-safe.
class ProblemLog {
 public:
  void Add(const std::string& reason) {
    ++count_;
    if (reasons_.size() < kMaxReasons) reasons_.push_back(reason);
  }

  std::size_t count() const { return count_; }
  const std::vector<std::string>& reasons() const { return reasons_; }

 private:
  static constexpr std::size_t kMaxReasons = 5;
  std::size_t count_ = 0;
  std::vector<std::string> reasons_;
};

}  // namespace semantic_slam
