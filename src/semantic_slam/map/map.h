#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map_point.h"
#include "semantic_slam/map/point_store.h"

namespace semantic_slam {

// A map point for people to look at.
struct ColouredPoint {
  Eigen::Vector3f position;  // [m], map frame
  std::array<std::uint8_t, 3> rgb;

  friend bool operator==(const ColouredPoint& a, const ColouredPoint& b) {
    return a.position == b.position && a.rgb == b.rgb;
  }
};

// One view kept for good. Its features never change; which map point each one shows does.
struct Keyframe {
  KeyframeId id = kNoKeyframe;
  int map_id = 0;
  std::shared_ptr<const FrameFeatures> features;
  Rigid3d T_map_camera = Rigid3d::Identity();
  std::vector<PointId> points;          // per feature; kNoPoint where it shows none
  std::vector<bool> left_out;           // per feature: it is on something that moves; empty: none is
  std::map<KeyframeId, int> covisible;  // number of points shared with other keyframes
  KeyframeId parent = kNoKeyframe;      // spanning tree
  bool is_joint =
      false;  // began a map that was joined to another: it need not see what its parent does

  bool LeavesOut(std::size_t feature) const { return !left_out.empty() && left_out[feature]; }
};

// Two keyframes of one place that closing a loop has tied together.
struct LoopEdge {
  KeyframeId a, b;
  Rigid3d T_a_b;
};

struct MapContents;  // map_contents.h

// The map of camera localization: keyframes, points, who sees what, and the covisibility graph and
// spanning tree that follow from it (Mur-Artal et al., ORB-SLAM, T-RO 2015, section III.C-D).
//
// When tracking is lost in an unknown place a new map begins beside it (Elvira et al.,
// ORBSLAM-Atlas, IROS 2019). The older ones lie dormant, each in a frame of its own, until the
// present one comes to a place of theirs and is joined to them. What has no map_id speaks of the
// present map or, where a keyframe or point is named, of whichever that is in.
//
// Not thread-safe by itself: hold mutex() around every call when several threads use it. Equal
// calls give equal maps: iteration is by ascending id of keyframes, and over points in one order.
class Map {
 public:
  // `scales` are the feature pyramid's.
  explicit Map(std::vector<float> scales);
  Map(const Map&) = delete;
  Map& operator=(const Map&) = delete;

  std::mutex& mutex() const { return mutex_; }

  // Adds a view; it sees no point yet. Its parent is set by UpdateCovisibility().
  Keyframe& AddKeyframe(std::shared_ptr<const FrameFeatures> features, const Rigid3d& T_map_camera);

  // Adds a point seen by one feature of one keyframe, with the descriptor and scale seen there.
  MapPoint& AddPoint(const Eigen::Vector3d& position, KeyframeId keyframe, int feature);

  // Precondition: the feature shows no point. Nothing happens if the keyframe already sees it.
  void AddObservation(PointId point, KeyframeId keyframe, int feature);

  // Erases the point too if fewer than two keyframes are left that see it.
  void RemoveObservation(PointId point, KeyframeId keyframe);

  void ErasePoint(PointId point);

  // Gives all observations of `from` to `to`; keyframes that see both keep `to`'s feature. `from`
  // is gone afterwards, and Resolve(from) == to.
  void MergePoints(PointId from, PointId to);

  // Takes the keyframe out: its observations go, its children get its parent, and the protocol's
  // graph keeps it as a node that moves with its parent. Precondition: it has one.
  void CullKeyframe(KeyframeId keyframe);

  // Recounts the points that the keyframe shares with others, and gives it the parent it shares
  // most with if it has none.
  void UpdateCovisibility(KeyframeId keyframe);

  // Recomputes descriptor, view direction and distances from the observations.
  void UpdatePointAppearance(PointId point);
  void UpdatePointGeometry(PointId point);

  // nullptr if there is no such keyframe or point (any more).
  Keyframe* FindKeyframe(KeyframeId id);
  const Keyframe* FindKeyframe(KeyframeId id) const;
  MapPoint* FindPoint(PointId id);
  const MapPoint* FindPoint(PointId id) const;

  // The point that `id` is today; kNoPoint if it was erased. Merges are remembered until the second
  // keyframe after them is added, so `id` must not be older than that.
  PointId Resolve(PointId id) const;

  // Keyframes sharing most points first; at most `limit`, each sharing at least `min_shared`.
  std::vector<KeyframeId> BestCovisible(KeyframeId keyframe, int limit, int min_shared = 1) const;

  // The points of the keyframe that at least `min_observations` keyframes see.
  int CountPoints(KeyframeId keyframe, int min_observations) const;

  // Pose of a keyframe, culled or not, through its living ancestors. Precondition: it has existed.
  Rigid3d KeyframePose(KeyframeId id) const;

  // Of all maps.
  const std::map<KeyframeId, std::unique_ptr<Keyframe>>& keyframes() const { return keyframes_; }
  std::size_t point_count() const { return points_.size(); }

  // Calls visit(point) for every point of all maps; it must not add or erase any.
  template <typename Visitor>
  void ForEachPoint(Visitor&& visit) {
    points_.ForEach(visit);
  }
  template <typename Visitor>
  void ForEachPoint(Visitor&& visit) const {
    points_.ForEach([&visit](const MapPoint& point) { visit(point); });
  }
  std::vector<ColouredPoint> ColouredPoints() const;
  const std::vector<float>& scales() const { return scales_; }

  int map_id() const { return map_id_; }
  bool IsPresent(const Keyframe& keyframe) const { return keyframe.map_id == map_id_; }
  std::uint64_t revision() const { return revision_; }
  // To be called after poses of keyframes, or which keyframes there are, have changed.
  void BumpRevision(RevisionReason reason);
  KeyframeGraph Graph() const;

  // Empties the map and forgets the dormant ones; map_id grows by one, keyframe and point ids go
  // on.
  void Clear();

  // Begins an empty map; map_id grows by one, keyframe and point ids go on. The map so far becomes
  // dormant, and of the dormant ones the oldest are forgotten that have too many keyframes
  // together.
  void BeginNew(std::size_t max_dormant_keyframes);

  // Joins the present map to a dormant one, moved by T_dormant_present: its first keyframe becomes
  // a child of `place`, a keyframe of the other. All is in the dormant one's frame then, and in the
  // present map.
  void JoinTo(KeyframeId place, const Rigid3d& T_dormant_present);

  std::size_t dormant_keyframes() const;

  // In the order in which they were added; they go with their keyframes.
  const std::vector<LoopEdge>& loop_edges() const { return loop_edges_; }
  void AddLoopEdge(const LoopEdge& edge) { loop_edges_.push_back(edge); }

  // All maps, as they may be kept in a file.
  MapContents Contents() const;

  // Replaces all maps by those. Keyframes, points and maps get ids that come after all that were
  // used so far, in the same order, so map_id grows by as many maps as there are. Precondition:
  // `contents` are sound, see CheckMapContents().
  void Load(const MapContents& contents);

 private:
  struct Culled {
    int map_id;
    Stamp stamp;
    KeyframeId parent;
    Rigid3d T_parent_keyframe;
  };

  void AdoptChildrenOf(const Keyframe& keyframe);
  void ForgetLoopEdges();
  void Forget(int map_id);
  void ForgetAll();
  void CountCovisible(Keyframe& keyframe) const;

  const std::vector<float> scales_;
  mutable std::mutex mutex_;
  std::map<KeyframeId, std::unique_ptr<Keyframe>> keyframes_;
  std::map<KeyframeId, Culled> culled_;
  std::vector<LoopEdge> loop_edges_;
  PointStore points_;
  // From a merged point to the one that took its place: since the newest keyframe was added, and
  // since the one before it.
  std::map<PointId, PointId> merges_;
  std::map<PointId, PointId> earlier_merges_;
  KeyframeId next_keyframe_ = 0;
  int map_id_ = 0;
  std::uint64_t revision_ = 0;
  RevisionReason reason_ = RevisionReason::kLocalBa;
  std::optional<MapMerge> merge_;  // the last one
};

}  // namespace semantic_slam
