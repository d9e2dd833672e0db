#include "semantic_slam/submaps/submap_collection.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "semantic_slam/submaps/submap_merging.h"

namespace semantic_slam {

SubmapCollection::SubmapCollection(const SubmapsOptions& options,
                                   const ScanInserterOptions& inserter_options, int max_submaps)
    : resolution_m_(options.resolution_m),
      max_submaps_(static_cast<std::size_t>(max_submaps)),
      inserter_(inserter_options),
      active_(options) {}

void SubmapCollection::Insert(const AnchoredScan& scan) {
  std::vector<std::unique_ptr<Submap>> closed = active_.Insert(scan, inserter_);
  std::move(closed.begin(), closed.end(), std::back_inserter(closed_));
  Trim();
}

std::vector<Submap*> SubmapCollection::all() {
  std::vector<Submap*> submaps;
  for (const auto& submap : closed_) submaps.push_back(submap.get());
  for (const auto& submap : active_.submaps()) submaps.push_back(submap.get());
  return submaps;
}

std::vector<const Submap*> SubmapCollection::all() const {
  std::vector<const Submap*> submaps;
  for (const auto& submap : closed_) submaps.push_back(submap.get());
  for (const auto& submap : active_.submaps()) submaps.push_back(submap.get());
  return submaps;
}

Rigid2d SubmapCollection::Match(const ScanMatcher& matcher, const PlanarScan& scan,
                                const Rigid2d& T_map_scan_expected) const {
  if (active_.submaps().empty()) return T_map_scan_expected;
  const Submap& reference = *active_.submaps().front();
  const auto match = matcher.Match(HitPoints(scan), reference.grid(),
                                   reference.T_map_submap().inverse() * T_map_scan_expected);
  return match ? reference.T_map_submap() * match->T_grid_scan : T_map_scan_expected;
}

OccupancyMap SubmapCollection::Render() const {
  return MergeSubmaps(all(), resolution_m_);
}

void SubmapCollection::LayAside() {
  const auto move = [this](std::vector<std::unique_ptr<Submap>> submaps) {
    std::move(submaps.begin(), submaps.end(), std::back_inserter(aside_));
  };
  move(std::exchange(closed_, {}));
  move(active_.Close());
}

bool SubmapCollection::TakeBack(const KeyframePoses& keyframes) {
  const auto first = std::stable_partition(aside_.begin(), aside_.end(), [&](const auto& submap) {
    return !keyframes.Find(submap->keyframe());
  });
  if (first == aside_.end()) return false;
  std::move(first, aside_.end(), std::back_inserter(closed_));
  aside_.erase(first, aside_.end());
  std::sort(closed_.begin(), closed_.end(),
            [](const auto& a, const auto& b) { return a->id() < b->id(); });
  return true;
}

void SubmapCollection::Reset() {
  closed_.clear();
  aside_.clear();
  active_.Reset();
}

void SubmapCollection::Trim() {
  while (size() + aside_.size() > max_submaps_ && !aside_.empty()) aside_.erase(aside_.begin());
  while (size() > max_submaps_ && !closed_.empty()) {
    std::vector<const Submap*> closed = std::as_const(*this).all();
    closed.resize(closed_.size());
    closed_.erase(closed_.begin() + static_cast<std::ptrdiff_t>(LeastMissed(closed)));
  }
}

}  // namespace semantic_slam
