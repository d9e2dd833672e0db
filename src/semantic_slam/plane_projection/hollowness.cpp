#include "semantic_slam/plane_projection/hollowness.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr int kMaxColumnsPerSide = 400;

// The columns of one footprint, as a grid over its bounding box.
class Columns {
 public:
  Columns(const ConvexPolygon& outline, double size_m) {
    low_ = {-Support(outline, {-1.0, 0.0}), -Support(outline, {0.0, -1.0})};
    const Eigen::Vector2d extent(Support(outline, {1.0, 0.0}) - low_.x(),
                                 Support(outline, {0.0, 1.0}) - low_.y());
    size_ = std::max(size_m, extent.maxCoeff() / kMaxColumnsPerSide);
    width_ = static_cast<int>(extent.x() / size_) + 1;
    height_ = static_cast<int>(extent.y() / size_) + 1;
    states_.assign(static_cast<std::size_t>(width_) * height_, kOutside);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const Eigen::Vector2d centre = low_ + size_ * Eigen::Vector2d(x + 0.5, y + 0.5);
        if (Contains(outline, centre)) states_[y * width_ + x] = kUnseen;
      }
    }
  }

  double size() const { return size_; }

  void MarkFree(const Eigen::Vector3f& p) { Mark(p, kFree); }
  void MarkOccupied(const Eigen::Vector3f& p) { Mark(p, kOccupied); }

  SpaceBelow Count() const {
    SpaceBelow below;
    below.free_columns = static_cast<int>(std::count(states_.begin(), states_.end(), kFree));
    below.occupied_columns =
        static_cast<int>(std::count(states_.begin(), states_.end(), kOccupied));
    below.unseen_columns = static_cast<int>(std::count(states_.begin(), states_.end(), kUnseen));
    return below;
  }

 private:
  // In ascending order of what weighs more.
  enum State : char { kOutside, kUnseen, kFree, kOccupied };

  void Mark(const Eigen::Vector3f& p, State state) {
    const double x = std::floor((p.x() - low_.x()) / size_);
    const double y = std::floor((p.y() - low_.y()) / size_);
    if (!(x >= 0.0 && y >= 0.0 && x < width_ && y < height_)) return;
    char& column = states_[static_cast<int>(y) * width_ + static_cast<int>(x)];
    if (column != kOutside) column = std::max<char>(column, state);
  }

  Eigen::Vector2d low_;
  double size_;
  int width_, height_;
  std::vector<char> states_;
};

// The part [enter, leave] of the way from eye to end that is below the ceiling and over the
// outline.
struct WayBelow {
  double enter = 0.0;
  double leave = 1.0;

  void KeepWhere(double from, double to, double limit) {  // the value runs from `from` to `to`
    if (from == to) {
      if (from > limit) leave = -1.0;
      return;
    }
    const double crossing = (limit - from) / (to - from);
    if (to > from) {
      leave = std::min(leave, crossing);
    } else {
      enter = std::max(enter, crossing);
    }
  }
};

WayBelow FindWayBelow(const ConvexPolygon& outline, double ceiling_m, const Eigen::Vector3f& eye,
                      const Eigen::Vector3f& end) {
  WayBelow way;
  way.KeepWhere(eye.z(), end.z(), ceiling_m);
  const Eigen::Vector2d eye_xy = eye.head<2>().cast<double>(),
                        end_xy = end.head<2>().cast<double>();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const Eigen::Vector2d outwards(side.y(), -side.x());
    way.KeepWhere(outwards.dot(eye_xy), outwards.dot(end_xy), outwards.dot(outline[i]));
  }
  return way;
}

}  // namespace

SpaceBelow& SpaceBelow::operator+=(const SpaceBelow& other) {
  free_columns += other.free_columns;
  occupied_columns += other.occupied_columns;
  unseen_columns += other.unseen_columns;
  return *this;
}

SpaceBelow LookBelow(const ConvexPolygon& outline_m, double top_height_m,
                     const Eigen::Vector3f& eye_m, const std::vector<Sight>& sights,
                     const HollownessOptions& options) {
  const auto lowest =
      std::min_element(sights.begin(), sights.end(),
                       [](const Sight& a, const Sight& b) { return a.end_m.z() < b.end_m.z(); });
  if (outline_m.empty() || lowest == sights.end()) return {};
  if (top_height_m - lowest->end_m.z() < options.min_room_m) return {};
  const double ceiling_m = top_height_m - options.clearance_m;
  Columns columns(outline_m, options.column_m);
  for (const Sight& sight : sights) {
    const WayBelow way = FindWayBelow(outline_m, ceiling_m, eye_m, sight.end_m);
    if (sight.on_object && sight.end_m.z() < ceiling_m) columns.MarkOccupied(sight.end_m);
    if (!(way.enter < way.leave)) continue;
    const Eigen::Vector3f line = sight.end_m - eye_m;
    const double step = 0.5 * columns.size() / std::max<double>(line.norm(), columns.size());
    // What the reading ends on is not free.
    const double until = sight.on_object ? std::min(way.leave, 1.0 - 2.0 * step) : way.leave;
    for (double t = way.enter + 0.5 * step; t < until; t += step) {
      columns.MarkFree(eye_m + static_cast<float>(t) * line);
    }
  }
  return columns.Count();
}

Hollowness JudgeHollowness(const SpaceBelow& below, bool class_is_hollow,
                           const HollownessOptions& options) {
  const int seen = below.free_columns + below.occupied_columns;
  const int all = seen + below.unseen_columns;
  if (seen == 0 || seen < options.min_seen_share * all) {
    return class_is_hollow ? Hollowness::kPartly : Hollowness::kNo;
  }
  const double free_share = static_cast<double>(below.free_columns) / seen;
  if (!class_is_hollow) {
    return free_share >= options.unexpected_share ? Hollowness::kPartly : Hollowness::kNo;
  }
  if (free_share >= options.full_share) return Hollowness::kFull;
  return free_share >= options.partly_share ? Hollowness::kPartly : Hollowness::kNo;
}

}  // namespace semantic_slam
