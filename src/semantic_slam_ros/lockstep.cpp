#include "semantic_slam_ros/lockstep.h"

namespace semantic_slam_ros {

using semantic_slam::Stamp;

namespace {

// As long as nobody has answered, images are sent at this pace.
constexpr std::chrono::milliseconds kFirstAnswerLimit{300};

}  // namespace

void Lockstep::NoteTracked(Stamp stamp, bool is_tracking) {
  is_tracking_ = is_tracking;
  tracked_.Note(stamp);
}

void Lockstep::Close() {
  tracked_.Close();
  commanded_.Close();
}

void Lockstep::AwaitAnswers(Stamp stamp) {
  if (!options_.lockstep) return;
  if (!began_) {
    AwaitFirstAnswers(stamp);
  } else if (Await(tracked_, stamp, late_tracking_) && waits_for_control_) {
    Await(commanded_, stamp, late_control_);
  }
}

bool Lockstep::Await(StampGate& gate, Stamp stamp, std::atomic<std::int64_t>& late) {
  const std::chrono::duration<double> limit(options_.wait_limit_s);
  if (gate.Await(stamp, std::chrono::duration_cast<Clock::duration>(limit))) return true;
  ++late;
  return false;
}

void Lockstep::AwaitFirstAnswers(Stamp stamp) {
  if (!first_wait_) first_wait_ = Clock::now();
  const bool tracked = tracked_.Await(stamp, kFirstAnswerLimit) && is_tracking_;
  const bool answered =
      tracked && (!waits_for_control_ || commanded_.Await(stamp, kFirstAnswerLimit));
  const std::chrono::duration<double> waited = Clock::now() - *first_wait_;
  began_ = answered || waited.count() > options_.start_limit_s;
}

void Lockstep::Restart() {
  tracked_.Forget();
  commanded_.Forget();
  first_wait_.reset();
  began_ = !options_.lockstep;
}

}  // namespace semantic_slam_ros
