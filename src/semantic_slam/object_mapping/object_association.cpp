#include "semantic_slam/object_mapping/object_association.h"

#include <algorithm>
#include <utility>

#include "semantic_slam/common/assignment.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
namespace {

constexpr double kNever = 1.0;
// A track counts as much as half an overlap: the track's own object wins over another one unless
// the sighting overlaps that by far more.
constexpr double kWithTrack = 0.5;
constexpr double kWithoutTrack = 0.25;  // of the cost at full overlap

bool IsLinked(const Sighting& sighting, const MappedObject& object, const TrackLinks& links) {
  return std::any_of(sighting.names.begin(), sighting.names.end(), [&](const Sighting::Name& name) {
    const auto link = links.find(name.track);
    return link != links.end() && link->second == object.id();
  });
}

bool HasName(const Sighting& sighting, LabelId label) {
  return std::any_of(sighting.names.begin(), sighting.names.end(),
                     [&](const Sighting::Name& name) { return name.label == label; });
}

bool IsNear(const ObjectShape& a, const ObjectShape& b, double slack_m) {
  const double reach_m = 0.5 * (a.box.size.norm() + b.box.size.norm()) + slack_m;
  return (a.position_m - b.position_m).norm() <= reach_m;
}

double Cost(const Sighting& sighting, const MappedObject& object, const TrackLinks& links,
            const ObjectAssociationOptions& options) {
  const Overlap overlap = OverlapOf(sighting.shape, object.shape());
  if (IsLinked(sighting, object, links) &&
      IsNear(sighting.shape, object.shape(), options.track_slack_m)) {
    return kWithTrack * (1.0 - overlap.of_smaller);
  }
  const bool is_one = HasName(sighting, object.label())
                          ? overlap.of_smaller >= options.same_class_overlap
                          : overlap.of_union >= options.other_class_overlap;
  if (!is_one) return kNever;
  return kWithoutTrack + (kNever - kWithoutTrack) * (1.0 - overlap.of_smaller);
}

}  // namespace

void JoinDoubles(std::vector<Sighting>& sightings, const ObjectAssociationOptions& options) {
  std::stable_sort(sightings.begin(), sightings.end(), [](const Sighting& a, const Sighting& b) {
    return a.names.front().confidence > b.names.front().confidence;
  });
  std::vector<Sighting> joined;
  for (Sighting& sighting : sightings) {
    const auto same = std::find_if(joined.begin(), joined.end(), [&](const Sighting& other) {
      return IntersectionOverUnion(other.box, sighting.box) >= options.double_box_overlap;
    });
    if (same == joined.end()) {
      joined.push_back(std::move(sighting));
    } else {
      same->names.insert(same->names.end(), sighting.names.begin(), sighting.names.end());
    }
  }
  sightings.swap(joined);
}

std::vector<std::optional<std::size_t>> AssociateSightings(
    const std::vector<Sighting>& sightings, const std::vector<MappedObject>& objects,
    const TrackLinks& links, const ObjectAssociationOptions& options) {
  Eigen::MatrixXd cost(sightings.size(), objects.size());
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    for (std::size_t j = 0; j < objects.size(); ++j) {
      cost(i, j) = Cost(sightings[i], objects[j], links, options);
    }
  }
  std::vector<std::optional<std::size_t>> shown(sightings.size());
  for (const AssignedPair& pair : AssignAtLeastCost(cost, kNever)) {
    shown[pair.row] = static_cast<std::size_t>(pair.column);
  }
  return shown;
}

bool AreOne(const MappedObject& a, const MappedObject& b, const ObjectAssociationOptions& options) {
  const Overlap overlap = OverlapOf(a.shape(), b.shape());
  if (overlap.of_smaller <= 0.0) return false;
  return a.label() == b.label() ? overlap.of_smaller >= options.merge_overlap
                                : overlap.of_union >= options.other_class_overlap;
}

}  // namespace semantic_slam
