#pragma once

#include <utility>
#include <vector>

#include "semantic_slam/map/map_contents.h"
#include "semantic_slam/map/map_file.h"
#include "testing/small_room.h"

namespace semantic_slam {

inline Rigid3d ShiftedBy(double x_m, double y_m = 0.0) {
  return Rigid3d(Eigen::Translation3d(x_m, y_m, 0.0));
}

// A map with everything in it that maps can have: two that were joined (keyframes 0 to 3) lie
// dormant; the present one has keyframes 4, 6 and 7, 5 was culled. A loop ties 4 and 7. Some points
// were erased and some merged.
class SmallMaps {
 public:
  static constexpr int kPresent = 2;
  static constexpr KeyframeId kNext = 8;

  SmallMaps() : map(SmallExtractor().scales()) {
    AddChain(2, 0.0);
    map.BeginNew(1000);
    AddChain(2, 5.0);
    map.JoinTo(1, ShiftedBy(0.1, 0.2));
    map.BeginNew(1000);
    AddChain(4, 0.0);
    map.ErasePoint(map.FindKeyframe(4)->points[3]);
    const std::vector<PointId>& points = map.FindKeyframe(7)->points;
    map.MergePoints(points[90], map.FindKeyframe(6)->points[91]);
    map.CullKeyframe(5);
    map.AddLoopEdge({4, 7, ShiftedBy(0.3)});
    map.AddLoopEdge({4, 5, ShiftedBy(0.1)});  // of a keyframe that is gone: of no use
    for (const auto& entry : map.keyframes()) map.UpdateCovisibility(entry.first);
  }

  StoredMap Stored() const { return {SmallIntrinsics(), map.scales(), map.Contents()}; }

  Map map;

 private:
  // Keyframes side by side; each sees 40 points of its own, all those of the first, and half of
  // those of the one before.
  void AddChain(int count, double x_m) {
    std::vector<PointId> of_first, before;
    for (int i = 0; i < count; ++i) {
      const Rigid3d T =
          ShiftedBy(x_m + 0.1 * i) * Eigen::AngleAxisd(0.01 * i, Eigen::Vector3d::UnitY());
      const KeyframeId id = map.AddKeyframe(SquaresFeatures(7), T).id;
      for (std::size_t k = 0; k < of_first.size(); ++k) {
        map.AddObservation(of_first[k], id, static_cast<int>(k));
      }
      for (std::size_t k = 0; k < before.size() / 2; ++k) {
        map.AddObservation(before[k], id, 40 + static_cast<int>(k));
      }
      before.clear();
      for (int k = 0; k < 40; ++k) {
        const int feature = of_first.empty() ? k : 80 + k;
        before.push_back(map.AddPoint(T * Eigen::Vector3d(0.01 * k, 0.0, 2.0), id, feature).id);
      }
      if (of_first.empty()) of_first = std::exchange(before, {});
      map.UpdateCovisibility(id);
    }
  }
};

}  // namespace semantic_slam
