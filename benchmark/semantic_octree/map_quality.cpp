#include "semantic_octree/map_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace semantic_slam {
namespace {

// Every n-th pixel of every n-th row is looked at: at 5 m that is still a point a centimetre.
constexpr int kStridePx = 2;
constexpr float kNearestM = 0.4f;

class TrueVoxels {
 public:
  explicit TrueVoxels(double resolution_m) : resolution_m_(resolution_m) {}

  void Add(const synthetic_room::Frame& frame, double range_m) {
    using synthetic_room::kWidth;
    for (int v = 0; v < synthetic_room::kHeight; v += kStridePx) {
      for (int u = 0; u < kWidth; u += kStridePx) {
        const float z = frame.true_depth_m[v * kWidth + u];
        const Eigen::Vector3f p(
            (static_cast<float>(u) - synthetic_room::kCentreX) / synthetic_room::kFocalLength * z,
            (static_cast<float>(v) - synthetic_room::kCentreY) / synthetic_room::kFocalLength * z,
            z);
        if (p.norm() > range_m || z < kNearestM) continue;
        const Eigen::Vector3f in_map = frame.R_map_camera * p + frame.position;
        octomap::OcTreeKey key;
        for (unsigned i = 0; i < 3; ++i)
          key[i] = static_cast<octomap::key_type>(
              static_cast<int>(std::floor(in_map[i] / resolution_m_)) + 32768);
        ++voxels_[key][frame.true_classes[v * kWidth + u]];
      }
    }
  }

  std::size_t size() const { return voxels_.size(); }

  // The class of most of the pixels; kUnknownLabel if no surface lies there.
  LabelId At(const octomap::OcTreeKey& key) const {
    const auto found = voxels_.find(key);
    if (found == voxels_.end()) return kUnknownLabel;
    const Counts& counts = found->second;
    return static_cast<LabelId>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  }

  // Whether a surface lies in that voxel or one of the 26 around it.
  bool IsNear(const octomap::OcTreeKey& key) const {
    for (int i = 0; i < 27; ++i) {
      const octomap::OcTreeKey beside(static_cast<octomap::key_type>(key[0] + i % 3 - 1),
                                      static_cast<octomap::key_type>(key[1] + i / 3 % 3 - 1),
                                      static_cast<octomap::key_type>(key[2] + i / 9 - 1));
      if (voxels_.count(beside) != 0) return true;
    }
    return false;
  }

 private:
  using Counts = std::array<int, synthetic_room::kClasses>;

  const double resolution_m_;
  std::unordered_map<octomap::OcTreeKey, Counts, octomap::OcTreeKey::KeyHash> voxels_;
};

double Share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

MapQuality JudgeMap(const MappingMethod& method, const MappingSettings& settings, int frames) {
  TrueVoxels truth(settings.resolution_m);
  synthetic_room::Frame frame;
  for (int i = 0; i < frames; ++i) {
    synthetic_room::RenderTruth(i, frame);
    truth.Add(frame, settings.range_m);
  }
  std::size_t occupied = 0, near = 0, found = 0, labelled = 0, right = 0, unlabelled = 0, alien = 0;
  method.ForEachOccupied([&](const octomap::OcTreeKey& key, LabelId label) {
    ++occupied;
    unlabelled += label == kUnknownLabel;
    alien += label >= synthetic_room::kClasses;
    near += truth.IsNear(key);
    const LabelId expected = truth.At(key);
    if (expected == kUnknownLabel) return;
    ++found;
    labelled += label != kUnknownLabel;
    right += label == expected;
  });
  return {truth.size(),
          occupied,
          Share(found, truth.size()),
          Share(near, occupied),
          Share(right, labelled),
          Share(unlabelled, occupied),
          Share(alien, occupied)};
}

}  // namespace semantic_slam
