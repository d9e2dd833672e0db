#pragma once

#include "semantic_slam/common/options.h"

namespace semantic_slam {

struct ReadoutOptions {
  bool learn = true;             // else the camera's readout time is taken as it is given
  double start_sigma_s = 0.02;   // how far the given readout time may be off
  double settled_sigma_s = 1e-3;  // how well it is known at best: the rest is left to follow changes
  double evidence_share = 0.03;  // of an image's evidence that counts: its errors are not independent
  double turn_sigma_radps = 0.1;  // how well the mean turn since the last image tells the present one

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("learn", self.learn);
    visit("start_sigma_s", self.start_sigma_s, 1e-6, 1.0);
    visit("settled_sigma_s", self.settled_sigma_s, 1e-6, 1.0);
    visit("evidence_share", self.evidence_share, 1e-6, 1.0);
    visit("turn_sigma_radps", self.turn_sigma_radps, 1e-4, 100.0);
  }
};

// What the features of one image say of a change of the readout time: the minimum of
// 0.5 * information * change^2 - gradient * change, over all poses.
struct ReadoutEvidence {
  double information = 0.0;  // [1/s^2]
  double gradient = 0.0;     // [1/s]
};

// Learns how long a rolling shutter takes from the first row to the last, image by image: a camera
// that turns shows each row from another pose, and tracking sees how much. Information that is older
// fades, so that it follows a recording that is played backwards, too. Not thread-safe.
class ReadoutEstimator {
 public:
  // Throws ConfigError if an option is out of range.
  ReadoutEstimator(const ReadoutOptions& options, double start_readout_s);

  // Begins anew with another camera.
  void Reset(double start_readout_s);

  void Add(const ReadoutEvidence& evidence);

  // Whether there is, or may be, a rolling shutter.
  bool is_rolling() const { return options_.learn || readout_s_ != 0.0; }
  double readout_s() const { return readout_s_; }
  double turn_sigma_radps() const { return options_.turn_sigma_radps; }

 private:
  static constexpr double kMaxReadoutS = 0.05;

  const ReadoutOptions options_;
  double readout_s_;
  double information_;
};

}  // namespace semantic_slam
