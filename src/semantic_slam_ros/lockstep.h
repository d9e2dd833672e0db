#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam_ros/stamp_gate.h"

namespace semantic_slam_ros {

struct LockstepOptions {
  bool lockstep = true;         // each image waits for the answers to the one before
  double wait_limit_s = 2.0;    // for an answer [s] of the wall's clock
  double start_limit_s = 60.0;  // for the first answer [s] of the wall's clock

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("lockstep", self.lockstep);
    visit("wait_limit_s", self.wait_limit_s, 0.01, 600.0);
    visit("start_limit_s", self.start_limit_s, 0.0, 3600.0);
  }
};

// Holds a simulation until an image has been tracked and, where the drone is controlled from
// outside, the command for its stamp has come. One thread waits, others note what has come.
class Lockstep {
 public:
  // Precondition: the options are valid.
  Lockstep(const LockstepOptions& options, bool waits_for_control)
      : options_(options), waits_for_control_(waits_for_control), began_(!options.lockstep) {}

  // From any thread.
  void NoteTracked(semantic_slam::Stamp stamp, bool is_tracking);
  void NoteCommanded(semantic_slam::Stamp stamp) { commanded_.Note(stamp); }
  // Nobody waits any more.
  void Close();
  // Whether the answers to one image have come at last, or the limit for that has run out: before,
  // the others may still be starting, and the drone should stay where it is.
  bool began() const { return began_; }
  // Waits that ran out since.
  std::int64_t late_tracking() const { return late_tracking_; }
  std::int64_t late_control() const { return late_control_; }

  // Waits for the answers to the image. Without lockstep it does not wait.
  void AwaitAnswers(semantic_slam::Stamp stamp);

  // Stamps begin anew.
  void Restart();

 private:
  using Clock = std::chrono::steady_clock;

  bool Await(StampGate& gate, semantic_slam::Stamp stamp, std::atomic<std::int64_t>& late);
  void AwaitFirstAnswers(semantic_slam::Stamp stamp);

  const LockstepOptions options_;
  const bool waits_for_control_;
  StampGate tracked_;
  StampGate commanded_;
  std::atomic<bool> is_tracking_{false};
  std::atomic<bool> began_;
  std::atomic<std::int64_t> late_tracking_{0};
  std::atomic<std::int64_t> late_control_{0};
  std::optional<Clock::time_point> first_wait_;
};

}  // namespace semantic_slam_ros
