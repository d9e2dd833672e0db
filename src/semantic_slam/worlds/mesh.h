#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// Triangles with what shading needs, in the frame of the object they belong to. Corners are not
// shared between faces that meet at an edge, so that each has its own normal and texture.
struct Mesh {
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Eigen::Vector3f> normals;    // of unit length, out of the solid; one per position
  std::vector<Eigen::Vector2f> texture_m;  // place on the surface's texture [m]; one per position
  std::vector<Eigen::Vector3i> triangles;  // counter-clockwise as seen from outside
};

// Puts `part`, moved by T_mesh_part, into `mesh`.
void Append(Mesh& mesh, const Mesh& part, const Rigid3d& T_mesh_part = Rigid3d::Identity());

// Solids. Texture coordinates are metres along the surface, so a texture has the same scale on all
// of them; on a box's sides they run to the right and down as seen from outside.

// Centred at `centre_m`, edges along the axes.
Mesh BoxMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& size_m);

// A rectangle at `corner_m` (its upper left corner as seen from the front), spanned by `right_m`
// and `down_m`; its front is where right x down points away from: normal = down x right.
Mesh QuadMesh(const Eigen::Vector3f& corner_m, const Eigen::Vector3f& right_m,
              const Eigen::Vector3f& down_m);

// An upright cylinder or cone frustum with lids, from `foot_m` upwards; smooth sides.
Mesh CylinderMesh(const Eigen::Vector3f& foot_m, float bottom_radius_m, float top_radius_m,
                  float height_m, int sides = 16);

// What a lathe makes: `profile_m` (radius, height above `foot_m`) turned about an upright axis. The
// outside lies to the right of the profile's direction, so it goes up on the outside, and down
// again inside of what is hollow. Closed if it begins and ends on the axis or returns to where it
// began. Edges below 45 degrees look smooth; what is nearly horizontal has its texture seen from
// above.
Mesh LatheMesh(const Eigen::Vector3f& foot_m, const std::vector<Eigen::Vector2f>& profile_m,
               int sides = 16);

// An ellipsoid with smooth normals.
Mesh EllipsoidMesh(const Eigen::Vector3f& centre_m, const Eigen::Vector3f& radii_m, int sides = 16);

}  // namespace semantic_slam
