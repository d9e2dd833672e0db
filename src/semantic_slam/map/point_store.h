#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "semantic_slam/map/map_point.h"

namespace semantic_slam {

// The points of a map by id. Places of erased points are used again, so it is as large as the most
// points that there were at a time; ids are not, and grow. Equal calls give equal ids and order.
class PointStore {
 public:
  // A point with a new id, greater than all before.
  MapPoint& Add();

  // nullptr if there is no such point (any more).
  MapPoint* Find(PointId id) const {
    const auto place = static_cast<std::size_t>(id & kPlaceMask);
    MapPoint* point = place < points_.size() ? points_[place].get() : nullptr;
    return point != nullptr && point->id == id ? point : nullptr;
  }

  // Precondition: there is such a point.
  void Erase(PointId id);

  // Erases all.
  void Clear();

  std::size_t size() const { return points_.size() - free_.size(); }

  // How many points it has room for.
  std::size_t places() const { return points_.size(); }

  // Calls visit(point) for every point, which may erase that one; it must not add any.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const {
    for (const auto& point : points_) {
      if (point != nullptr) visit(*point);
    }
  }

 private:
  // An id is a number that grows, and in its last bits the point's place.
  static constexpr int kPlaceBits = 24;  // sixteen million points at a time
  static constexpr PointId kPlaceMask = (PointId{1} << kPlaceBits) - 1;

  std::vector<std::unique_ptr<MapPoint>> points_;  // by place; empty where it is free
  std::vector<std::size_t> free_;                  // places; the last one is used next
  PointId next_number_ = 0;
};

}  // namespace semantic_slam
