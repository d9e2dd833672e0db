#pragma once

#include <map>
#include <memory>
#include <vector>

#include "semantic_slam/local_mapping/point_fusion.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/place_recognition/place_index.h"
#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {

// A map with an open loop: the camera looks at a desk, goes away looking at pictures that nothing else
// shows, and comes back to the desk with an error that has grown on the way. Neighbours share points,
// the two visits do not.
class TwoVisits {
 public:
  static constexpr int kVisit = 5;  // keyframes 0..4 are the first visit
  static constexpr int kAway = 6;   // 5..10 are elsewhere
  static constexpr int kAll = 2 * kVisit + kAway;
  static constexpr KeyframeId kLast = kAll - 1;
  static constexpr double kDriftM = 0.3;  // at the end

  TwoVisits() : map(SmallExtractor().scales()), index(PlaceIndexOptions()) {
    for (int i = 0; i < kAll; ++i) Add(i);
  }

  // Where the camera truly was.
  static Rigid3d TruePose(int i) {
    if (i < kVisit) return HandheldPath::T_world_camera(3.0 + 0.1 * i);
    if (i < kVisit + kAway) {
      Rigid3d T = TruePose(kVisit - 1);
      T.translation().y() += 0.2 * (i - kVisit + 1);
      return T;
    }
    return HandheldPath::T_world_camera(3.05 + 0.1 * (i - kVisit - kAway));
  }

  double Error(KeyframeId id) const { return DistanceBetween(map.KeyframePose(id), TruePose(static_cast<int>(id))); }

  Map map;
  PlaceIndex index;  // holds all but the last keyframe

 private:
  static bool IsAway(int i) { return i >= kVisit && i < kVisit + kAway; }

  static std::shared_ptr<const FrameFeatures> Features(int i) {
    static std::map<int, std::shared_ptr<const FrameFeatures>> features;  // rendered once for all tests
    auto& f = features[i];
    if (f == nullptr) {
      f = IsAway(i) ? SquaresFeatures(100 + i)
                    : SmallRoomFeatures(TruePose(i), Stamp{1'000'000'000'000 + 100'000'000 * std::int64_t{i}});
    }
    return f;
  }

  // What the error has come to at keyframe i: nothing on the first visit, all of it on the second.
  static Rigid3d Drift(int i) {
    const double share = std::clamp((i - kVisit + 1) / static_cast<double>(kAway + 1), 0.0, 1.0);
    Rigid3d T = Rigid3d::Identity();
    T.linear() = ExpSo3(Eigen::Vector3d(0.0, 0.0, 0.05 * share));
    T.translation() = share * kDriftM * Eigen::Vector3d(0.6, 0.0, 0.8);
    return T;
  }

  void Add(int i) {
    const KeyframeId id = AddKeyframeWithPoints(map, Features(i), Drift(i) * TruePose(i));
    const bool same_place = i > 0 && IsAway(i) == IsAway(i - 1);
    if (same_place && !IsAway(i)) {
      FusePoints(PointsOf(*map.FindKeyframe(id - 1)), id, 4.0f, *SmallCamera(), ObservationNoise(), map);
      map.UpdateCovisibility(id);
    }
    if (i < kAll - 1) index.Add(id, Features(i));
  }
};

}  // namespace semantic_slam
