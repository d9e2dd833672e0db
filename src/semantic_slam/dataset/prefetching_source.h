#pragma once

#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "semantic_slam/common/bounded_queue.h"
#include "semantic_slam/dataset/rgbd_source.h"

namespace semantic_slam {

// Reads another source ahead on a thread of its own, so that decoding runs beside tracking: the
// same images in the same order. Not thread-safe itself; may be destroyed before the end.
class PrefetchingSource : public RgbdSource {
 public:
  static constexpr std::size_t kMaxAhead = 8;

  // Decodes at most `max_ahead` images that Next() has not yet returned. Precondition: at least 2.
  explicit PrefetchingSource(std::unique_ptr<RgbdSource> source, std::size_t max_ahead = kMaxAhead);
  ~PrefetchingSource() override;

  std::size_t size() const override { return size_; }

  // Rethrows what the wrapped source threw at this place in the sequence, once.
  std::optional<RgbdImage> Next() override;

  // As the wrapped source stood when it returned what Next() returned last: the same numbers on
  // every run, however far ahead the reader is.
  const std::vector<std::string>& problems() const override { return problems_; }
  std::size_t dropped() const override { return dropped_; }

  // CPU time that the reader has taken up to then [s], for decoding above all.
  double cpu_s() const { return cpu_s_; }

  const std::vector<AccelerometerReading>& accelerometer() const override {
    return source_->accelerometer();
  }
  std::optional<Eigen::Matrix3d> R_camera_imu() const override { return source_->R_camera_imu(); }

 private:
  // What one call of the wrapped Next() did.
  struct Step {
    std::optional<RgbdImage> image;
    std::exception_ptr error;
    std::vector<std::string> problems;
    std::size_t dropped = 0;
    double cpu_s = 0.0;
  };

  void ReadAhead();
  Step TakeStep() const;

  const std::unique_ptr<RgbdSource> source_;  // used by thread_ only, but for what never changes
  const std::size_t size_;
  std::vector<std::string> problems_;
  std::size_t dropped_ = 0;
  double cpu_s_ = 0.0;
  BoundedQueue<Step> queue_;  // declared before thread_, so it outlives it
  std::thread thread_;
};

}  // namespace semantic_slam
