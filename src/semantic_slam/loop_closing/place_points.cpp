#include "semantic_slam/loop_closing/place_points.h"

#include <set>

namespace semantic_slam {
namespace {

constexpr int kPlaceKeyframes = 10;

}  // namespace

std::vector<MapPoint> PointsAround(KeyframeId place, const Map& map) {
  std::vector<KeyframeId> around = map.BestCovisible(place, kPlaceKeyframes);
  around.push_back(place);
  std::set<PointId> ids;
  for (const KeyframeId id : around) {
    const auto& seen = map.FindKeyframe(id)->points;
    ids.insert(seen.begin(), seen.end());
  }
  std::vector<MapPoint> points;
  for (const PointId id : ids) {
    if (const MapPoint* point = map.FindPoint(id)) points.push_back(*point);
  }
  return points;
}

}  // namespace semantic_slam
