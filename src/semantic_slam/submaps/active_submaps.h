#pragma once

#include <memory>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/submaps/submap.h"

namespace semantic_slam {

struct SubmapsOptions {
  double resolution_m = 0.05;   // side of a cell
  int min_scans = 30;           // a submap is full after so many scans
  double min_distance_m = 1.0;  // and so long a way from where it began,
  double min_turn_deg = 45.0;   // or so large a turn
  double max_distance_m =
      10.0;  // a scan from farther away begins anew: the camera was somewhere else

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("resolution_m", self.resolution_m, 0.01, 1.0);
    visit("min_scans", self.min_scans, 1, 100000);
    visit("min_distance_m", self.min_distance_m, 0.1, 50.0);
    visit("min_turn_deg", self.min_turn_deg, 5.0, 360.0);
    visit("max_distance_m", self.max_distance_m, 0.5, 100.0);
  }
};

// A scan in the map, and the keyframe that its pose hangs on.
struct AnchoredScan {
  const PlanarScan& scan;
  Rigid2d T_map_scan;
  KeyframeId keyframe = kNoKeyframe;
  Rigid3d T_map_keyframe = Rigid3d::Identity();
  Rigid3d T_keyframe_level = Rigid3d::Identity();  // the scan's frame, seen from the keyframe
};

// The submaps that are being drawn (Hess et al., ICRA 2016, section IV-B): as a rule two that
// overlap, so that the older one always holds enough to match a scan to. A submap is full by its
// number of scans and by how far the camera went; hovering alone never fills one. Not thread-safe.
class ActiveSubmaps {
 public:
  // Throws ConfigError if an option is out of range.
  explicit ActiveSubmaps(const SubmapsOptions& options);

  // Enters the scan into the active submaps; begins a new one if the newest is full. Returns those
  // that are closed now.
  std::vector<std::unique_ptr<Submap>> Insert(const AnchoredScan& scan,
                                              const ScanInserter& inserter);

  // The oldest first; empty before the first scan.
  const std::vector<std::unique_ptr<Submap>>& submaps() const { return submaps_; }

  // Closes all of them.
  std::vector<std::unique_ptr<Submap>> Close();

  void Reset() { submaps_.clear(); }

 private:
  bool IsFull(const Submap& submap) const;
  void CloseIfFarFrom(const AnchoredScan& scan, std::vector<std::unique_ptr<Submap>>& closed);

  const SubmapsOptions options_;
  SubmapId next_id_ = 0;
  std::vector<std::unique_ptr<Submap>> submaps_;
};

}  // namespace semantic_slam
