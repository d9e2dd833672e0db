#include "tools/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace semantic_slam {
namespace {

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kInterval(100);

}  // namespace

ProgressBar::ProgressBar(std::string title, std::size_t total)
    : title_(std::move(title)), total_(total), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (!is_terminal_) return;
  Draw();
  std::fputc('\n', stderr);
}

void ProgressBar::Update(std::size_t done, const std::string& note) {
  done_ = done;
  note_ = note;
  const auto now = std::chrono::steady_clock::now();
  if (!is_terminal_ || now - last_drawn_ < kInterval) return;
  last_drawn_ = now;
  Draw();
}

void ProgressBar::Draw() const {
  const double share =
      total_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
  const int filled = static_cast<int>(share * kWidth);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  // \033[K clears what a longer line before has left.
  std::fprintf(stderr, "\r%s [%s] %zu/%zu %s\033[K", title_.c_str(), bar.c_str(), done_, total_,
               note_.c_str());
  std::fflush(stderr);
}

}  // namespace semantic_slam
