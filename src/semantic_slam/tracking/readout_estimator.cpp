#include "semantic_slam/tracking/readout_estimator.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

double Information(double sigma) { return 1.0 / (sigma * sigma); }

}  // namespace

ReadoutEstimator::ReadoutEstimator(const ReadoutOptions& options, double start_readout_s)
    : options_(Validated(options)) {
  Reset(start_readout_s);
}

void ReadoutEstimator::Reset(double start_readout_s) {
  readout_s_ = start_readout_s;
  information_ = Information(options_.start_sigma_s);
}

void ReadoutEstimator::Add(const ReadoutEvidence& evidence) {
  if (!options_.learn || !std::isfinite(evidence.gradient) || !(evidence.information > 0.0)) return;
  information_ += options_.evidence_share * evidence.information;
  readout_s_ += options_.evidence_share * evidence.gradient / information_;
  readout_s_ = std::clamp(readout_s_, -kMaxReadoutS, kMaxReadoutS);
  information_ = std::min(information_, Information(options_.settled_sigma_s));
}

}  // namespace semantic_slam
