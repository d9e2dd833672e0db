#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace semantic_slam {

// A line on stderr that shows how far long work has come, at most ten times a second; nothing where
// stderr is not a terminal. Not thread-safe.
class ProgressBar {
 public:
  ProgressBar(std::string title, std::size_t total);
  ~ProgressBar();  // leaves the last state on the screen and ends the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  // `note` is shown behind the bar.
  void Update(std::size_t done, const std::string& note = "");

 private:
  void Draw() const;

  const std::string title_;
  const std::size_t total_;
  const bool is_terminal_;
  std::size_t done_ = 0;
  std::string note_;
  std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace semantic_slam
