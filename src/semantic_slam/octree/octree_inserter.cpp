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

std::vector<VoxelObservation> OctreeInserter::Insert(
    const std::vector<VoxelObservation>& observations, const Rigid3d& T_map_camera,
    SemanticOcTree& tree) {
  CheckInRange(
      "max_clear_range_m in voxels",
      std::max(options_.max_clear_range_m, options_.max_hit_range_m) / tree.getResolution(), 0.0,
      kMaxRangeVoxels);
  Locate(observations, T_map_camera, tree);
  ResetGrid(tree);
  SortByVoxel();
  std::vector<VoxelObservation> combined;
  combined.reserve(slot_begins_.size());
  for (std::size_t begin = 0, end = 0; begin < sorted_.size(); begin = end) {
    while (end < sorted_.size() && sorted_[end].key == sorted_[begin].key) ++end;
    InsertVoxel(sorted_.data() + begin, sorted_.data() + end, observations, tree, combined);
  }
  UpdateTree(combined, tree);
  return combined;
}

void OctreeInserter::Locate(const std::vector<VoxelObservation>& observations,
                            const Rigid3d& T_map_camera, const SemanticOcTree& tree) {
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
  octomap::OcTreeKey lowest, highest;
  for (unsigned i = 0; i < 3; ++i) {
    float low = origin_(i), high = origin_(i);
    for (const Located& point : located_) {
      low = std::min(low, point.position(i));
      high = std::max(high, point.position(i));
    }
    lowest[i] = ClampedKey(tree, std::max(low, origin_(i) - reach));
    highest[i] = ClampedKey(tree, std::min(high, origin_(i) + reach));
  }
  grid_.Reset(lowest, highest);
}

// Brings the points of each voxel together: those on the grid in Morton order, then, few as a rule,
// those out of reach.
void OctreeInserter::SortByVoxel() {
  const auto out_of_reach =
      std::stable_partition(located_.begin(), located_.end(),
                            [this](const Located& point) { return grid_.Covers(point.key); });
  for (auto point = located_.begin(); point != out_of_reach; ++point) grid_.MarkEnd(point->key);
  const std::uint32_t slots = grid_.AssignSlots();
  std::vector<std::uint32_t>& begins = slot_begins_;
  begins.assign(slots + 1, 0);
  for (auto point = located_.begin(); point != out_of_reach; ++point)
    ++begins[grid_.SlotOf(point->key) + 1];
  for (std::uint32_t i = 0; i < slots; ++i) begins[i + 1] += begins[i];
  sorted_.resize(located_.size());
  for (auto point = located_.begin(); point != out_of_reach; ++point) {
    sorted_[begins[grid_.SlotOf(point->key)]++] = *point;
  }
  const auto rest =
      std::copy(out_of_reach, located_.end(), sorted_.begin() + (out_of_reach - located_.begin()));
  std::stable_sort(sorted_.begin() + (out_of_reach - located_.begin()), rest,
                   [](const Located& a, const Located& b) { return KeyLess(a.key, b.key); });
  hit_of_slot_.assign(slots, 0);
}

void OctreeInserter::InsertVoxel(const Located* begin, const Located* end,
                                 const std::vector<VoxelObservation>& observations,
                                 const SemanticOcTree& tree,
                                 std::vector<VoxelObservation>& combined) {
  const octomap::point3d centre = tree.keyToCoord(begin->key);
  for (const Located* point = begin; point != end; ++point) {
    const VoxelObservation& observation = observations[point->index];
    const auto distance = static_cast<float>((point->position - centre).norm());
    (observation.is_transient ? transient_ : steady_).Add(observation, distance);
  }
  const octomap::point3d offset = centre - origin_;
  if (!steady_.empty()) {
    if (offset.norm() <= options_.max_hit_range_m && IsInside(centre)) {
      grid_.MarkHit(begin->key);
      hit_of_slot_[grid_.SlotOf(begin->key)] = static_cast<std::uint32_t>(combined.size());
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

void OctreeInserter::UpdateTree(const std::vector<VoxelObservation>& combined,
                                SemanticOcTree& tree) {
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
