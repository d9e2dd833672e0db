#include "semantic_slam/submaps/active_submaps.h"

#include <cmath>
#include <utility>

namespace semantic_slam {
namespace {

constexpr std::size_t kActive = 2;

}  // namespace

ActiveSubmaps::ActiveSubmaps(const SubmapsOptions& options) : options_(Validated(options)) {}

std::vector<std::unique_ptr<Submap>> ActiveSubmaps::Insert(const AnchoredScan& scan,
                                                           const ScanInserter& inserter) {
  std::vector<std::unique_ptr<Submap>> closed;
  CloseIfFarFrom(scan, closed);
  if (submaps_.empty() || IsFull(*submaps_.back())) {
    if (submaps_.size() == kActive) {
      closed.push_back(std::move(submaps_.front()));
      submaps_.erase(submaps_.begin());
    }
    submaps_.push_back(std::make_unique<Submap>(next_id_++, options_.resolution_m, scan.keyframe,
                                                scan.T_map_keyframe, scan.T_keyframe_level));
  }
  for (const auto& submap : submaps_) submap->Insert(scan.scan, scan.T_map_scan, inserter);
  return closed;
}

bool ActiveSubmaps::IsFull(const Submap& submap) const {
  return submap.scans() >= options_.min_scans &&
         (submap.distance_m() >= options_.min_distance_m ||
          submap.turn_rad() >= options_.min_turn_deg * M_PI / 180.0);
}

void ActiveSubmaps::CloseIfFarFrom(const AnchoredScan& scan,
                                   std::vector<std::unique_ptr<Submap>>& closed) {
  if (submaps_.empty()) return;
  const Eigen::Vector2d from = submaps_.back()->T_map_submap().translation();
  if ((scan.T_map_scan.translation() - from).norm() <= options_.max_distance_m) return;
  for (auto& submap : Close()) closed.push_back(std::move(submap));
}

std::vector<std::unique_ptr<Submap>> ActiveSubmaps::Close() {
  return std::exchange(submaps_, {});
}

}  // namespace semantic_slam
