#include "semantic_slam/simulation/light_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

constexpr float kInsetM = 0.005f;       // sites keep off the surface's edges, where others meet it
constexpr std::size_t kMaxEdges = 192;  // tried for the smallest rectangle
constexpr float kReach = 1.5f;          // of a site outside of the surface, in grid spacings

float Cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The part's corners along two axes.
Eigen::AlignedBox2f Bounds(const Mesh& part, const Eigen::Vector3f& right,
                           const Eigen::Vector3f& up) {
  Eigen::AlignedBox2f bounds;
  for (const Eigen::Vector3f& p : part.positions_m) {
    bounds.extend(Eigen::Vector2f(right.dot(p), up.dot(p)));
  }
  return bounds;
}

// The edge along which the smallest rectangle around a flat part lies, of unit length.
Eigen::Vector3f BestDirection(const Mesh& part, const Eigen::Vector3f& normal) {
  Eigen::Vector3f best = Eigen::Vector3f::Zero();
  float smallest = std::numeric_limits<float>::infinity();
  std::size_t edges = 0;
  for (const Eigen::Vector3i& triangle : part.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (++edges > kMaxEdges) return best;
      const Eigen::Vector3f direction =
          (part.positions_m[triangle[(i + 1) % 3]] - part.positions_m[triangle[i]]).normalized();
      const float area = Bounds(part, direction, normal.cross(direction)).volume();
      if (area < smallest * 0.999f) {
        smallest = area;
        best = direction;
      }
    }
  }
  return best;
}

struct Triangle2d {
  std::array<Eigen::Vector2f, 3> corners;  // counter-clockwise

  bool Contains(const Eigen::Vector2f& p) const {
    for (int i = 0; i < 3; ++i) {
      if (Cross(corners[(i + 1) % 3] - corners[i], p - corners[i]) < 0.0f) return false;
    }
    return true;
  }

  Eigen::Vector2f NearestOnRim(const Eigen::Vector2f& p) const {
    Eigen::Vector2f nearest = corners[0];
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2f edge = corners[(i + 1) % 3] - corners[i];
      const float along = std::clamp(edge.dot(p - corners[i]) / edge.squaredNorm(), 0.0f, 1.0f);
      const Eigen::Vector2f q = corners[i] + along * edge;
      if ((q - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = q;
    }
    return nearest;
  }

  Eigen::Vector2f Centroid() const { return (corners[0] + corners[1] + corners[2]) / 3.0f; }
};

// `p` if the surface is there; a place on it a little inside of its rim if that is within
// `reach_m`.
std::optional<Eigen::Vector2f> PlaceOn(const std::vector<Triangle2d>& surface,
                                       const Eigen::Vector2f& p, float reach_m) {
  float nearest_m = reach_m;
  std::optional<Eigen::Vector2f> place;
  for (const Triangle2d& triangle : surface) {
    if (triangle.Contains(p)) return p;
    const Eigen::Vector2f on_rim = triangle.NearestOnRim(p);
    const float distance_m = (on_rim - p).norm();
    if (distance_m > nearest_m) continue;
    nearest_m = distance_m;
    const Eigen::Vector2f inwards = triangle.Centroid() - on_rim;
    place = on_rim + inwards * std::min(0.5f, kInsetM / std::max(inwards.norm(), 1e-9f));
  }
  return place;
}

}  // namespace

LightGrid::LightGrid(const Mesh& part, float spacing_m) {
  const Eigen::Vector3i& first = part.triangles.front();
  const Eigen::Vector3f& corner = part.positions_m[first[0]];
  normal_ =
      (part.positions_m[first[1]] - corner).cross(part.positions_m[first[2]] - corner).normalized();
  right_ = BestDirection(part, normal_);
  up_ = normal_.cross(right_);
  const Eigen::AlignedBox2f bounds = Bounds(part, right_, up_);
  origin_m_ = bounds.min().x() * right_ + bounds.min().y() * up_ + normal_.dot(corner) * normal_;
  extent_m_ = bounds.sizes().cwiseMax(1e-6f);
  columns_ = std::max(2, static_cast<int>(std::lround(extent_m_.x() / spacing_m)) + 1);
  rows_ = std::max(2, static_cast<int>(std::lround(extent_m_.y() / spacing_m)) + 1);
  samples_per_m_ = Eigen::Vector2f(columns_ - 1, rows_ - 1).cwiseQuotient(extent_m_);
  samples_.assign(static_cast<std::size_t>(columns_) * rows_, LightSample::Zero());
}

std::vector<LightSite> LightGrid::Sites(const Mesh& part) const {
  std::vector<Triangle2d> surface;
  for (const Eigen::Vector3i& triangle : part.triangles) {
    Triangle2d flat;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3f p = part.positions_m[triangle[i]] - origin_m_;
      flat.corners[i] = {right_.dot(p), up_.dot(p)};
    }
    surface.push_back(flat);
  }
  const Eigen::Vector2f inset_m = (0.25f * extent_m_).cwiseMin(kInsetM);
  const float reach_m = kReach * samples_per_m_.cwiseInverse().maxCoeff();
  std::vector<LightSite> sites(samples_.size(), {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()});
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const Eigen::Vector2f p = Eigen::Vector2f(column, row).cwiseQuotient(samples_per_m_);
      const auto place =
          PlaceOn(surface, p.cwiseMax(inset_m).cwiseMin(extent_m_ - inset_m), reach_m);
      if (!place) continue;
      sites[static_cast<std::size_t>(row) * columns_ + column] = {
          origin_m_ + place->x() * right_ + place->y() * up_, normal_};
    }
  }
  return sites;
}

Eigen::Vector3f LightGrid::At(const Eigen::Vector3f& position_m) const {
  const Eigen::Vector3f p = position_m - origin_m_;
  const float x = std::clamp(right_.dot(p) * samples_per_m_.x(), 0.0f, columns_ - 1.001f);
  const float y = std::clamp(up_.dot(p) * samples_per_m_.y(), 0.0f, rows_ - 1.001f);
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const float right = x - column, up = y - row;
  const LightSample* const below = &samples_[static_cast<std::size_t>(row) * columns_ + column];
  const LightSample* const above = below + columns_;
  const LightSample light = (1.0f - up) * ((1.0f - right) * below[0] + right * below[1]) +
                            up * ((1.0f - right) * above[0] + right * above[1]);
  return light.head<3>() / std::max(light[3], 1e-6f);
}

void Smooth(LightSample* samples, int columns, int rows) {
  const std::vector<LightSample> rough(samples,
                                       samples + static_cast<std::ptrdiff_t>(columns) * rows);
  const auto at = [&](int row, int column) -> const LightSample& {
    return rough[static_cast<std::size_t>(row) * columns + column];
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (at(row, column)[3] <= 0.0f) continue;
      LightSample sum = LightSample::Zero();
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows - 1); ++r) {
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns - 1); ++c) {
          sum += (r == row ? 2.0f : 1.0f) * (c == column ? 2.0f : 1.0f) * at(r, c);
        }
      }
      samples[static_cast<std::size_t>(row) * columns + column] =
          sum * (at(row, column)[3] / sum[3]);
    }
  }
}

}  // namespace semantic_slam
