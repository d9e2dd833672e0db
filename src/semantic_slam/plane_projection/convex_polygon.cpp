#include "semantic_slam/plane_projection/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace semantic_slam {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Goes on along the hull from its last corner to `point`, taking corners back that lie inside.
void Extend(ConvexPolygon& chain, std::size_t fixed, const Eigen::Vector2d& point) {
  while (chain.size() > fixed) {
    const Eigen::Vector2d& a = chain[chain.size() - 2];
    const Eigen::Vector2d& b = chain.back();
    if (Cross(b - a, point - b) > 0.0) break;
    chain.pop_back();
  }
  chain.push_back(point);
}

// Rounding gives points on one line an area of about 1e-16 of their extent squared.
constexpr double kMinAreaShare = 1e-12;

ConvexPolygon OrEmpty(ConvexPolygon polygon) {
  double outline = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    outline += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  }
  if (polygon.size() < 3 || Area(polygon) <= kMinAreaShare * outline * outline) polygon.clear();
  return polygon;
}

double DistanceFromLine(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const double length = (b - a).norm();
  return length > 0.0 ? std::abs(Cross(b - a, p - a)) / length : (p - a).norm();
}

}  // namespace

ConvexPolygon ConvexHull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  if (points.size() < 3) return {};
  ConvexPolygon hull;
  for (const Eigen::Vector2d& p : points) Extend(hull, 1, p);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) Extend(hull, lower, points[i]);
  hull.pop_back();  // the first point again
  return OrEmpty(std::move(hull));
}

double Area(const ConvexPolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += Cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * twice;
}

bool Contains(const ConvexPolygon& polygon, const Eigen::Vector2d& point) {
  if (polygon.empty()) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if (Cross(b - a, point - a) < 0.0) return false;
  }
  return true;
}

ConvexPolygon ClippedByHalfPlane(const ConvexPolygon& polygon, const Eigen::Vector2d& direction,
                                 double limit) {
  ConvexPolygon clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = direction.dot(a) - limit, beyond_b = direction.dot(b) - limit;
    if (beyond_a <= 0.0) clipped.push_back(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      clipped.push_back(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
    }
  }
  return OrEmpty(std::move(clipped));
}

ConvexPolygon Intersection(const ConvexPolygon& a, const ConvexPolygon& b) {
  if (b.empty()) return {};
  ConvexPolygon common = a;
  for (std::size_t i = 0; i < b.size() && !common.empty(); ++i) {
    const Eigen::Vector2d side = b[(i + 1) % b.size()] - b[i];
    const Eigen::Vector2d outwards(side.y(), -side.x());
    common = ClippedByHalfPlane(common, outwards, outwards.dot(b[i]));
  }
  return common;
}

ConvexPolygon Simplified(ConvexPolygon polygon, double tolerance) {
  while (polygon.size() > 3) {
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t before = (i + polygon.size() - 1) % polygon.size();
      const double distance =
          DistanceFromLine(polygon[i], polygon[before], polygon[(i + 1) % polygon.size()]);
      if (distance < least) least = distance, flattest = i;
    }
    if (least >= tolerance) break;
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
  return polygon;
}

double Support(const ConvexPolygon& polygon, const Eigen::Vector2d& direction) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : polygon) reach = std::max(reach, direction.dot(corner));
  return reach;
}

Rectangle MinimumAreaRectangle(const ConvexPolygon& polygon) {
  Rectangle best;
  double best_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (side.norm() == 0.0) continue;
    const Eigen::Vector2d x = side.normalized(), y(-x.y(), x.x());
    const double left = -Support(polygon, -x), right = Support(polygon, x);
    const double low = -Support(polygon, -y), high = Support(polygon, y);
    const double area = (right - left) * (high - low);
    if (area >= best_area) continue;
    best_area = area;
    const bool x_is_longer = right - left >= high - low;
    const Eigen::Vector2d axis = x_is_longer ? x : y;
    best.centre = 0.5 * (left + right) * x + 0.5 * (low + high) * y;
    best.size = {std::max(right - left, high - low), std::min(right - left, high - low)};
    best.yaw_rad = std::atan2(axis.y(), axis.x());
  }
  // An axis has no direction: half a turn more or less is the same rectangle.
  if (best.yaw_rad <= -M_PI_2) best.yaw_rad += M_PI;
  if (best.yaw_rad > M_PI_2) best.yaw_rad -= M_PI;
  return best;
}

}  // namespace semantic_slam
