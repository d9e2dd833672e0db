#include "semantic_slam/map/point_store.h"

#include <cassert>

namespace semantic_slam {

MapPoint& PointStore::Add() {
  if (free_.empty()) {
    free_.push_back(points_.size());
    points_.emplace_back();
  }
  const std::size_t place = free_.back();
  free_.pop_back();
  points_[place] = std::make_unique<MapPoint>();
  points_[place]->id = next_number_++ << kPlaceBits | static_cast<PointId>(place);
  return *points_[place];
}

void PointStore::Erase(PointId id) {
  assert(Find(id) != nullptr);
  const auto place = static_cast<std::size_t>(id & kPlaceMask);
  points_[place].reset();
  free_.push_back(place);
}

void PointStore::Clear() {
  points_.clear();
  free_.clear();
}

}  // namespace semantic_slam
