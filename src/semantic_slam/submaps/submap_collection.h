#pragma once

#include <memory>
#include <vector>

#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/scan_matching/scan_matcher.h"
#include "semantic_slam/submaps/active_submaps.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// All submaps of one floor plan: those that are being drawn, those that are closed, and those of
// maps that were lost; no more than a given number of them. Not thread-safe.
class SubmapCollection {
 public:
  // Throws ConfigError if an option is out of range. `max_submaps` is at least 3.
  SubmapCollection(const SubmapsOptions& options, const ScanInserterOptions& inserter_options,
                   int max_submaps);

  // Enters the scan into the active submaps. If there are too many submaps then, the oldest goes
  // that was laid aside, else the closed one that would be missed least.
  void Insert(const AnchoredScan& scan);

  // By ascending id.
  std::vector<Submap*> all();
  std::vector<const Submap*> all() const;

  // T_map_scan where the scan fits onto the older active submap, which has seen most; as expected
  // if it fits nowhere or there is no submap yet.
  Rigid2d Match(const ScanMatcher& matcher, const PlanarScan& scan,
                const Rigid2d& T_map_scan_expected) const;

  // The plan as MergeSubmaps() draws it.
  OccupancyMap Render() const;

  // Lays all submaps aside: they are of a map that tracking has lost.
  void LayAside();

  // Takes those back that hang on one of the keyframes. Returns whether there were any.
  bool TakeBack(const KeyframePoses& keyframes);

  void ForgetLaidAside() { aside_.clear(); }

  // Without those that were laid aside.
  std::size_t size() const { return closed_.size() + active_.submaps().size(); }
  void Reset();

 private:
  void Trim();

  const double resolution_m_;
  const std::size_t max_submaps_;
  const ScanInserter inserter_;
  std::vector<std::unique_ptr<Submap>> closed_;  // by ascending id
  std::vector<std::unique_ptr<Submap>> aside_;   // by ascending id
  ActiveSubmaps active_;
};

}  // namespace semantic_slam
