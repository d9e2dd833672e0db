#include "semantic_slam/octree/octree_inserter.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/ray_walk.h"

namespace semantic_slam {
namespace {

constexpr double kMaxRangeVoxels = 1000.0;

// Where old and new colour meet: fast enough to follow the light, slow enough to average noise.
constexpr int kOldColourParts = 3;

OctreeInserterOptions Checked(const OctreeInserterOptions& options) {
  Validate(options);
  if (options.min_z_m >= options.max_z_m) {
    std::ostringstream what;
    what << "min_z_m = " << options.min_z_m << ", but must be below max_z_m = " << options.max_z_m;
    throw ConfigError(what.str());
  }
  return options;
}

octomap::point3d ToPoint(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

bool KeyLess(const octomap::OcTreeKey& a, const octomap::OcTreeKey& b) {
  return std::lexicographical_compare(a.k, a.k + 3, b.k, b.k + 3);
}

octomap::key_type ClampedKey(const SemanticOcTree& tree, float coordinate) {
  const double cell = std::floor(coordinate / tree.getResolution()) + 32768.0;
  return static_cast<octomap::key_type>(std::clamp(cell, 0.0, 65535.0));
}

void Enter(const VoxelObservation& observation, bool was_occupied, const LabelFusion& fusion,
           SemanticNode& node) {
  SemanticNode::Rgb rgb = observation.rgb;
  if (was_occupied) {
    for (int i = 0; i < 3; ++i) {
      rgb[i] = static_cast<std::uint8_t>((kOldColourParts * node.rgb()[i] + rgb[i] + 2) /
                                         (kOldColourParts + 1));
    }
  }
  node.SetRgb(rgb);
  node.SetLabels(
      CompactLabels(fusion.Fuse(node.labels().Unpacked(), observation.labels.Unpacked())));
}

}  // namespace

void CheckRangeInVoxels(const OctreeInserterOptions& options, double resolution_m) {
  CheckInRange("max_hit_range_m / resolution_m", options.max_hit_range_m / resolution_m, 0.0,
               kMaxRangeVoxels);
  CheckInRange("max_clear_range_m / resolution_m", options.max_clear_range_m / resolution_m, 0.0,
               kMaxRangeVoxels);
}

OctreeInserter::OctreeInserter(const OctreeInserterOptions& options, const LabelFusion& fusion)
    : options_(Checked(options)), fusion_(fusion) {}

std::vector<VoxelObservation> OctreeInserter::Insert(const Observations& observations,
                                                     const Rigid3d& T_map_camera,
                                                     SemanticOcTree& tree) {
  CheckInRange(
      "max_clear_range_m in voxels",
      std::max(options_.max_clear_range_m, options_.max_hit_range_m) / tree.getResolution(), 0.0,
      kMaxRangeVoxels);
  Locate(observations, T_map_camera, tree);
  ResetGrid(tree);
  SortByVoxel();
  Observations combined;
  combined.reserve(slot_ends_.size());
  const std::uint32_t* const points = sorted_.data();
  for (std::size_t begin = 0, end = 0; begin < sorted_.size(); begin = end) {
    const octomap::OcTreeKey& key = located_[points[begin]].key;
    while (end < sorted_.size() && located_[points[end]].key == key) ++end;
    InsertVoxel(points + begin, points + end, observations, tree, combined);
  }
  UpdateTree(combined, tree);
  return combined;
}

void OctreeInserter::Locate(const Observations& observations, const Rigid3d& T_map_camera,
                            const SemanticOcTree& tree) {
  origin_ = ToPoint(T_map_camera.translation());
  if (!IsFinite(T_map_camera) || !tree.coordToKeyChecked(origin_, origin_key_)) {
    std::ostringstream what;
    what << "camera at " << T_map_camera.translation().transpose()
         << " m is outside of the octree, which reaches " << 32768 * tree.getResolution()
         << " m from the origin";
    throw InputError(what.str());
  }
  lowest_z_ = ClampedKey(tree, static_cast<float>(options_.min_z_m));
  highest_z_ = ClampedKey(tree, static_cast<float>(options_.max_z_m));
  located_.clear();
  located_.reserve(observations.size());
  for (std::uint32_t i = 0; i < observations.size(); ++i) {
    Located point{ToPoint(T_map_camera * observations[i].position.cast<double>()), {}, i};
    if (tree.coordToKeyChecked(point.position, point.key)) located_.push_back(point);
  }
}

// The grid covers the box around the camera and the points, as far as any ray may go.
void OctreeInserter::ResetGrid(const SemanticOcTree& tree) {
  const auto reach =
      static_cast<float>(std::max(options_.max_clear_range_m, options_.max_hit_range_m));
  octomap::point3d low = origin_, high = origin_;
  for (const Located& point : located_) {
    for (unsigned i = 0; i < 3; ++i) {
      low(i) = std::min(low(i), point.position(i));
      high(i) = std::max(high(i), point.position(i));
    }
  }
  octomap::OcTreeKey lowest, highest;
  for (unsigned i = 0; i < 3; ++i) {
    lowest[i] = ClampedKey(tree, std::max(low(i), origin_(i) - reach));
    highest[i] = ClampedKey(tree, std::min(high(i), origin_(i) + reach));
  }
  grid_.Reset(lowest, highest);
}

// Brings the points of each voxel together: those on the grid in Morton order, by counting, then,
// few as a rule, those out of reach.
void OctreeInserter::SortByVoxel() {
  std::vector<std::uint32_t> out_of_reach;
  const auto count = static_cast<std::uint32_t>(located_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (grid_.Covers(located_[i].key)) {
      grid_.MarkEnd(located_[i].key);
    } else {
      out_of_reach.push_back(i);
    }
  }
  const std::uint32_t slots = grid_.AssignSlots();
  slots_.assign(count, slots);  // one more, for what is out of reach
  slot_ends_.assign(slots + 2, 0);
  for (std::uint32_t i = 0, next = 0; i < count; ++i) {
    if (next < out_of_reach.size() && out_of_reach[next] == i) {
      ++next;
    } else {
      slots_[i] = grid_.SlotOf(located_[i].key);
    }
    ++slot_ends_[slots_[i] + 1];
  }
  for (std::uint32_t i = 0; i <= slots; ++i) slot_ends_[i + 1] += slot_ends_[i];
  sorted_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) sorted_[slot_ends_[slots_[i]]++] = i;
  std::stable_sort(sorted_.end() - static_cast<std::ptrdiff_t>(out_of_reach.size()), sorted_.end(),
                   [this](std::uint32_t a, std::uint32_t b) {
                     return KeyLess(located_[a].key, located_[b].key);
                   });
  hit_of_slot_.assign(slots, 0);
}

void OctreeInserter::InsertVoxel(const std::uint32_t* begin, const std::uint32_t* end,
                                 const Observations& observations, const SemanticOcTree& tree,
                                 Observations& combined) {
  const octomap::OcTreeKey key = located_[*begin].key;
  const octomap::point3d centre = tree.keyToCoord(key);
  for (const std::uint32_t* i = begin; i != end; ++i) {
    const VoxelObservation& observation = observations[located_[*i].index];
    const auto distance = static_cast<float>((located_[*i].position - centre).norm());
    (observation.is_transient ? transient_ : steady_).Add(observation, distance);
  }
  const octomap::point3d offset = centre - origin_;
  if (!steady_.empty()) {
    if (offset.norm() <= options_.max_hit_range_m && IsInside(centre)) {
      grid_.MarkHit(key);
      hit_of_slot_[grid_.SlotOf(key)] = static_cast<std::uint32_t>(combined.size());
    }
    combined.push_back(steady_.Take());
  }
  if (!transient_.empty()) {
    combined.push_back(transient_.Take());
    combined.back().is_transient = true;
  }
  const bool whole_ray = offset.norm() <= options_.max_clear_range_m;
  MarkRay(whole_ray
              ? centre
              : origin_ + offset.normalized() * static_cast<float>(options_.max_clear_range_m),
          tree);
}

void OctreeInserter::MarkRay(const octomap::point3d& end, const SemanticOcTree& tree) {
  octomap::OcTreeKey end_key;
  if (!tree.coordToKeyChecked(end, end_key)) return;
  ScanGrid::Brick* brick = nullptr;
  int brick_x = -1, brick_y = -1, brick_z = -1;
  RayWalk(tree, origin_, origin_key_, end).ForEachVoxel([&](int x, int y, int z) {
    if (z < lowest_z_ || z > highest_z_) return;
    if (x >> 3 != brick_x || y >> 3 != brick_y || z >> 3 != brick_z) {
      brick_x = x >> 3, brick_y = y >> 3, brick_z = z >> 3;
      brick = &grid_.BrickAt(x, y, z);
    }
    ScanGrid::MarkFree(*brick, x, y, z);
  });
}

void OctreeInserter::UpdateTree(const Observations& combined, SemanticOcTree& tree) {
  TreeUpdater updater(tree);
  grid_.ForEachUpdate([&](const octomap::OcTreeKey& key, bool is_hit, std::uint32_t slot) {
    if (!is_hit) {
      updater.Miss(key);
      return;
    }
    bool was_occupied = false;
    SemanticNode& node = updater.Hit(key, &was_occupied);
    Enter(combined[hit_of_slot_[slot]], was_occupied, fusion_, node);
  });
}

bool OctreeInserter::IsInside(const octomap::point3d& centre) const {
  return centre.z() >= options_.min_z_m && centre.z() <= options_.max_z_m;
}

}  // namespace semantic_slam
