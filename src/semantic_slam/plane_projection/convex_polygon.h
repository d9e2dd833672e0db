#pragma once

#include <vector>

#include <Eigen/Core>

namespace semantic_slam {

// Corners of a convex polygon, counter-clockwise, without three on a line. Empty if there is no
// area.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

// The smallest convex polygon that holds all points (Andrew's monotone chain, 1979); it begins at
// the corner with least x. Empty if the points span no area.
ConvexPolygon ConvexHull(std::vector<Eigen::Vector2d> points);

double Area(const ConvexPolygon& polygon);

bool Contains(const ConvexPolygon& polygon, const Eigen::Vector2d& point);

// The part of the polygon where direction . p <= limit (Sutherland and Hodgman, 1974).
ConvexPolygon ClippedByHalfPlane(const ConvexPolygon& polygon, const Eigen::Vector2d& direction,
                                 double limit);

ConvexPolygon Intersection(const ConvexPolygon& a, const ConvexPolygon& b);

// The polygon without the corners that stand out by less than `tolerance` from the line between
// their neighbours, the flattest first.
ConvexPolygon Simplified(ConvexPolygon polygon, double tolerance);

// How far the polygon reaches in a direction: the greatest direction . p of its points.
// Precondition: not empty.
double Support(const ConvexPolygon& polygon, const Eigen::Vector2d& direction);

struct Rectangle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  // along its own x and y; x is the longer
  double yaw_rad = 0.0;                            // of its x axis, in (-pi/2, pi/2]
};

// The rectangle of least area that holds the polygon: one side lies on a side of the polygon
// (Freeman and Shapira, 1975). Precondition: not empty.
Rectangle MinimumAreaRectangle(const ConvexPolygon& polygon);

}  // namespace semantic_slam
