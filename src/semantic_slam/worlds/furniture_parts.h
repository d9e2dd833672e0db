#pragma once

#include <string>
#include <vector>

#include "semantic_slam/worlds/furniture_builder.h"

namespace semantic_slam {

// Parts that several kinds of furniture have.

// Turns about an upright axis.
Rigid3d Turned(float angle_rad);

// At `at_m`, leaning by `angle_rad` about the axis to the left: the top moves to the front.
Rigid3d Leaning(const Eigen::Vector3f& at_m, float angle_rad);

// A padded part that lies between two corners.
void AddPadding(FurnitureBuilder& b, const std::string& part, const Eigen::Vector3f& low_m,
                const Eigen::Vector3f& high_m, float radius_m);

// Four legs of thickness `leg_m`, tapering towards the floor, inside a rectangle.
void AddLegs(FurnitureBuilder& b, const std::string& part, float depth_m, float width_m,
             float height_m, float leg_m);

// Four round legs from the corners of a rectangle on the floor up to those of a smaller one.
void AddSplayedLegs(FurnitureBuilder& b, const std::string& part, const Eigen::Vector2f& floor_m,
                    const Eigen::Vector2f& head_m, float height_m, float radius_m);

// A bent tube through all points.
void AddTube(FurnitureBuilder& b, const std::string& part,
             const std::vector<Eigen::Vector3f>& points_m, float radius_m);

// The same, once as given and once mirrored to the other side (y).
void AddTubePair(FurnitureBuilder& b, const std::string& part,
                 const std::vector<Eigen::Vector3f>& points_m, float radius_m);

// A column on a foot of `arms` arms, up to `top_m`.
void AddStarFoot(FurnitureBuilder& b, const std::string& part, int arms, float radius_m,
                 float top_m);

// Five arms with castors, and the column in their middle up to `top_m`.
void AddCastorFoot(FurnitureBuilder& b, const std::string& part, float radius_m, float top_m);

// A board over the whole plan, of material "top".
void AddTableTop(FurnitureBuilder& b, float thickness_m);

// A bowl-like shell of a seat and its back, from the front of the seat to the top of the back.
// `profile_m` is its middle line in the plane of symmetry (x, z); its sides come forward and up by
// `wrap_m`.
void AddShell(FurnitureBuilder& b, const std::string& part,
              const std::vector<Eigen::Vector2f>& profile_m, float width_m, float wrap_m);

}  // namespace semantic_slam
