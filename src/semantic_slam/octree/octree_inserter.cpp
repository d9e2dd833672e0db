#include "semantic_slam/octree/octree_inserter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <Eigen/Geometry>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/ray_walk.h"
#include "semantic_slam/octree/tree_updater.h"
#include "semantic_slam/semantic_cloud/point_lanes.h"

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

// What Insert() takes, by index. Sample() leaves the place to the caller.
class CloudPoints {
 public:
  CloudPoints(const std::vector<SemanticPoint>& points, const CloudContents& contents,
              const LabelMask& transient)
      : points_(points),
        contents_(contents),
        transient_(transient),
        any_transient_((contents.labels & transient).any()) {}

  std::size_t size() const { return points_.size(); }
  const Eigen::Vector3f& Position(std::size_t i) const { return points_[i].position; }
  bool IsOnlySeen(std::size_t i) const {
    return any_transient_ && transient_[points_[i].labels[0]];
  }

  VoxelSums::Sample Sample(std::size_t i) const {
    const PointLanes point(points_[i]);
    VoxelSums::Sample sample;
    sample.rgb = point.rgb();
    sample.labels = point.labels();
    sample.confidences = ToInts(point.confidences() * float{CompactLabels::kProbabilityOne} + 0.5f);
    return sample;
  }

  const Eigen::AlignedBox3f& AroundM() const { return contents_.around_m; }
  LabelMask Labels() const { return contents_.labels & ~transient_; }  // that count
  std::uint64_t Count() const { return points_.size(); }

 private:
  const std::vector<SemanticPoint>& points_;
  const CloudContents& contents_;
  const LabelMask& transient_;
  const bool any_transient_;
};

class ObservedPoints {
 public:
  explicit ObservedPoints(const std::vector<VoxelObservation>& observations)
      : observations_(observations) {}

  std::size_t size() const { return observations_.size(); }
  const Eigen::Vector3f& Position(std::size_t i) const { return observations_[i].position; }
  bool IsOnlySeen(std::size_t i) const { return observations_[i].is_only_seen; }

  VoxelSums::Sample Sample(std::size_t i) const {
    const VoxelObservation& observation = observations_[i];
    VoxelSums::Sample sample;
    const auto& [r, g, b] = observation.rgb;
    sample.rgb = Ints4{r, g, b, 0};
    const CompactLabels& labels = observation.labels;
    sample.labels = labels.label(0) | std::uint32_t{labels.label(1)} << 8 |
                    std::uint32_t{labels.label(2)} << 16;
    sample.confidences = Ints4{0, labels.scaled_probability(0), labels.scaled_probability(1),
                               labels.scaled_probability(2)};
    sample.points = observation.points;
    return sample;
  }

  Eigen::AlignedBox3f AroundM() const {
    Eigen::AlignedBox3f around(Eigen::Vector3f::Zero().eval());
    for (const VoxelObservation& observation : observations_) around.extend(observation.position);
    return around;
  }
  LabelMask Labels() const {
    LabelMask labels;
    for (const VoxelObservation& observation : observations_) {
      for (int k = 0; k < kTopLabels; ++k) labels.set(observation.labels.label(k));
    }
    return labels;
  }
  std::uint64_t Count() const {
    std::uint64_t points = 0;
    for (const VoxelObservation& observation : observations_) points += observation.points;
    return points;
  }

 private:
  const std::vector<VoxelObservation>& observations_;
};

constexpr ScanGrid::EndId kNowhere = std::numeric_limits<ScanGrid::EndId>::max();

octomap::point3d InMap(const Rigid3d& T_map_camera, const Eigen::Vector3f& position) {
  return ToPoint(T_map_camera * position.cast<double>());
}

// Finds the voxels of points that are near the camera. All axes at once (the fourth is idle) in
// single precision, from the corner of the camera's voxel on, where numbers are small. Only where
// that is too near a voxel's face to be sure it is worked out as OctoMap does.
class VoxelFinder {
 public:
  // All points lie `around_m` the camera.
  VoxelFinder(const Eigen::AlignedBox3f& around_m, const Rigid3d& T_map_camera,
              const octomap::OcTreeKey& origin_key, const SemanticOcTree& tree)
      : T_map_camera_(T_map_camera), tree_(tree) {
    const double voxels_per_m = 1.0 / tree.getResolution();
    const double farthest = around_m.diagonal().norm() * voxels_per_m;
    unsure_ = static_cast<float>(std::max(farthest * kRounding, kLeastUnsure));
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        columns_[axis][i] = static_cast<float>(T_map_camera.linear()(i, axis) * voxels_per_m);
      corner_[i] = origin_key[static_cast<unsigned>(i)];
      offset_[i] = static_cast<float>(T_map_camera.translation()[i] * voxels_per_m -
                                      (corner_[i] - kMiddleKey));
    }
    offset_[3] = 0.5f;
  }

  struct Voxel {
    Ints4 key;    // beyond the tree's for points outside
    Ints4 place;  // as VoxelSums takes it
  };

  Voxel Find(const Eigen::Vector3f& p) const {
    const Floats4 at = columns_[0] * p.x() + columns_[1] * p.y() + columns_[2] * p.z() + offset_;
    const Ints4 whole = Floor(at);
    const Floats4 part = at - ToFloats(whole);
    if (!All((part > unsure_) & (part < 1.0f - unsure_))) return FindExactly(p);
    return {whole + corner_, ToInts(part * 256.0f)};
  }

 private:
  static constexpr int kMiddleKey = 32768;  // of the voxel at the map's origin

  // A product of single precision is rounded by 2^-24 of itself, and the sum of the four as often
  // again; what is left is to spare.
  static constexpr double kRounding = 1.0 / (1 << 20);
  static constexpr double kLeastUnsure = 1.0 / 1024.0;

  Voxel FindExactly(const Eigen::Vector3f& p) const {
    const octomap::point3d point = InMap(T_map_camera_, p);
    Voxel voxel{{-1, -1, -1, 0}, {}};
    octomap::OcTreeKey key;
    if (!tree_.coordToKeyChecked(point, key)) return voxel;
    for (unsigned i = 0; i < 3; ++i) {
      const double part =
          point(i) / tree_.getResolution() - (static_cast<int>(key[i]) - kMiddleKey);
      voxel.key[i] = key[i];
      voxel.place[i] = std::clamp(static_cast<int>(part * 256.0), 0, 255);
    }
    return voxel;
  }

  const Rigid3d& T_map_camera_;
  const SemanticOcTree& tree_;
  std::array<Floats4, 3> columns_{};
  Floats4 offset_{};
  Ints4 corner_{};
  float unsure_;  // nearer to a face [voxels] rounding may tell the wrong voxel
};

}  // namespace

void CheckRangeInVoxels(const OctreeInserterOptions& options, double resolution_m) {
  CheckInRange("max_hit_range_m / resolution_m", options.max_hit_range_m / resolution_m, 0.0,
               kMaxRangeVoxels);
  CheckInRange("max_clear_range_m / resolution_m", options.max_clear_range_m / resolution_m, 0.0,
               kMaxRangeVoxels);
}

OctreeInserter::OctreeInserter(const OctreeInserterOptions& options, const LabelFusion& fusion)
    : options_(Checked(options)), fusion_(fusion) {}

const std::vector<VoxelObservation>& OctreeInserter::Insert(
    const std::vector<SemanticPoint>& points, const CloudContents& contents,
    const LabelMask& transient, const Rigid3d& T_map_camera, SemanticOcTree& tree) {
  return InsertPoints(CloudPoints(points, contents, transient), T_map_camera, tree);
}

const std::vector<VoxelObservation>& OctreeInserter::Insert(const Observations& observations,
                                                            const Rigid3d& T_map_camera,
                                                            SemanticOcTree& tree) {
  return InsertPoints(ObservedPoints(observations), T_map_camera, tree);
}

template <typename Points>
const OctreeInserter::Observations& OctreeInserter::InsertPoints(const Points& points,
                                                                 const Rigid3d& T_map_camera,
                                                                 SemanticOcTree& tree) {
  CheckInRange(
      "max_clear_range_m in voxels",
      std::max(options_.max_clear_range_m, options_.max_hit_range_m) / tree.getResolution(), 0.0,
      kMaxRangeVoxels);
  SetOrigin(T_map_camera, tree);
  ResetGrid(points.AroundM(), T_map_camera, tree);
  SumUp(points, T_map_camera, tree);
  Combine(T_map_camera, tree);
  MarkRays(tree);
  UpdateTree(tree);
  return combined_;
}

void OctreeInserter::SetOrigin(const Rigid3d& T_map_camera, const SemanticOcTree& tree) {
  origin_ = ToPoint(T_map_camera.translation());
  if (IsFinite(T_map_camera) && tree.coordToKeyChecked(origin_, origin_key_)) return;
  std::ostringstream what;
  what << "camera at " << T_map_camera.translation().transpose()
       << " m is outside of the octree, which reaches " << 32768 * tree.getResolution()
       << " m from the origin";
  throw InputError(what.str());
}

// The grid covers a box around the camera and the points, as far as any ray may go.
void OctreeInserter::ResetGrid(const Eigen::AlignedBox3f& around_m, const Rigid3d& T_map_camera,
                               const SemanticOcTree& tree) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < 8; ++i) {
    box.extend(T_map_camera *
               around_m.corner(static_cast<Eigen::AlignedBox3f::CornerType>(i)).cast<double>());
  }
  const double reach = std::max(options_.max_clear_range_m, options_.max_hit_range_m);
  octomap::OcTreeKey lowest, highest;
  for (int i = 0; i < 3; ++i) {
    const double middle = T_map_camera.translation()[i];
    lowest[i] = tree.ClampedKey(static_cast<float>(std::max(box.min()[i], middle - reach)));
    highest[i] = tree.ClampedKey(static_cast<float>(std::min(box.max()[i], middle + reach)));
  }
  grid_.Reset(lowest, highest);
}

// Neighbouring points often lie in one voxel, or by noise in one of two, which then need not be
// looked up again.
template <typename Points>
void OctreeInserter::SumUp(const Points& points, const Rigid3d& T_map_camera,
                           const SemanticOcTree& tree) {
  const VoxelFinder finder(points.AroundM(), T_map_camera, origin_key_, tree);
  sums_.Reset(points.Labels(), points.Count());
  is_seen_through_.clear();
  out_of_reach_.clear();
  VoxelSums::Adder adder(sums_);
  Ints4 last_key{-1, -1, -1, 0}, key_before = last_key;
  ScanGrid::EndId end = kNowhere, end_before = kNowhere;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const VoxelFinder::Voxel voxel = finder.Find(points.Position(i));
    if (!All(voxel.key == last_key)) {
      std::swap(last_key, key_before);
      std::swap(end, end_before);
      if (!All(voxel.key == last_key)) {
        last_key = voxel.key;
        end = AddEnd({last_key[0], last_key[1], last_key[2]});
      }
    }
    if (end == kNowhere) continue;
    if (points.IsOnlySeen(i)) {
      is_seen_through_[end] = true;
      continue;
    }
    VoxelSums::Sample sample = points.Sample(i);
    sample.place = voxel.place;
    adder.Add(end, sample);
  }
  adder.Finish();
}

// kNowhere for what is outside of the tree or, which is noted, of the grid.
ScanGrid::EndId OctreeInserter::AddEnd(const std::array<int, 3>& key) {
  for (const int k : key) {
    if (k < 0 || k > 65535) return kNowhere;
  }
  const octomap::OcTreeKey tree_key(static_cast<octomap::key_type>(key[0]),
                                    static_cast<octomap::key_type>(key[1]),
                                    static_cast<octomap::key_type>(key[2]));
  if (!grid_.layout().Covers(tree_key)) {
    out_of_reach_.push_back(tree_key);
    return kNowhere;
  }
  const ScanGrid::EndId end = grid_.AddEnd(tree_key);
  if (end == is_seen_through_.size()) {
    is_seen_through_.push_back(false);
    sums_.AddVoxel();
  }
  return end;
}

void OctreeInserter::Combine(const Rigid3d& T_map_camera, const SemanticOcTree& tree) {
  const Rigid3d T_camera_map = T_map_camera.inverse();
  const double resolution_m = tree.getResolution();
  combined_.clear();
  ray_ends_.clear();
  combined_of_.resize(grid_.ends());
  const auto add_only_seen = [&](const octomap::point3d& centre) {
    const Eigen::Vector3d in_map(centre.x(), centre.y(), centre.z());
    combined_.push_back({(T_camera_map * in_map).cast<float>(), {}, {}, 1, true});
  };
  grid_.ForEachEnd([&](ScanGrid::EndId end, const octomap::OcTreeKey& key, ScanGrid::BitId bit) {
    const octomap::point3d centre = tree.keyToCoord(key);
    const bool in_range = (centre - origin_).norm() <= options_.max_hit_range_m;
    if (in_range && !sums_.IsEmpty(end)) {
      const VoxelSums::Mean mean = sums_.MeanOf(end);
      Eigen::Vector3d in_map;
      for (int i = 0; i < 3; ++i)
        in_map[i] = (static_cast<int>(key[i]) - 32768 + double{mean.place[i]}) * resolution_m;
      if (IsInside(centre)) grid_.MarkHit(bit);
      combined_of_[end] = static_cast<std::uint32_t>(combined_.size());
      combined_.push_back(
          {(T_camera_map * in_map).cast<float>(), mean.rgb, mean.labels, mean.points, false});
    }
    if (!in_range || is_seen_through_[end]) add_only_seen(centre);
    ray_ends_.push_back(RayEnd(centre));
  });
  std::sort(out_of_reach_.begin(), out_of_reach_.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.k, a.k + 3, b.k, b.k + 3);
  });
  out_of_reach_.erase(std::unique(out_of_reach_.begin(), out_of_reach_.end()), out_of_reach_.end());
  for (const octomap::OcTreeKey& key : out_of_reach_) {
    const octomap::point3d centre = tree.keyToCoord(key);
    add_only_seen(centre);
    ray_ends_.push_back(RayEnd(centre));
  }
}

void OctreeInserter::MarkRays(const SemanticOcTree& tree) {
  rays_.Reset(grid_.layout(), tree);
  octomap::OcTreeKey end_key;
  for (const octomap::point3d& end : ray_ends_) {
    if (!tree.coordToKeyChecked(end, end_key)) continue;
    rays_.Mark(RayWalk(tree, origin_, origin_key_, end));
  }
  grid_.AddFree(rays_);
}

void OctreeInserter::UpdateTree(SemanticOcTree& tree) {
  grid_.LimitHeight(tree.ClampedKey(static_cast<float>(options_.min_z_m)),
                    tree.ClampedKey(static_cast<float>(options_.max_z_m)));
  TreeUpdater updater(tree);
  grid_.ForEachBrick([&](const ScanGrid::Brick& brick) {
    updater.Update(brick, [&](SemanticNode& node, bool was_occupied, unsigned place) {
      Enter(combined_[combined_of_[grid_.EndAt(brick, place)]], was_occupied, fusion_, node);
    });
  });
}

// The voxel's centre, or as far on the way to it as rays free voxels.
octomap::point3d OctreeInserter::RayEnd(const octomap::point3d& centre) const {
  const octomap::point3d offset = centre - origin_;
  if (offset.norm() <= options_.max_clear_range_m) return centre;
  return origin_ + offset.normalized() * static_cast<float>(options_.max_clear_range_m);
}

bool OctreeInserter::IsInside(const octomap::point3d& centre) const {
  return centre.z() >= options_.min_z_m && centre.z() <= options_.max_z_m;
}

}  // namespace semantic_slam
