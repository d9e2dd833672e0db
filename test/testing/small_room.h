#pragma once

#include <cstdint>
#include <memory>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"

namespace semantic_slam {

// Small pictures, so that a test can afford many of them: 320 x 240 pixels, f = 260 px, no
// distortion.
CameraIntrinsics SmallIntrinsics();
std::shared_ptr<const CameraModel> SmallCamera();

// The extractor of all features below: 500 of them, else the defaults.
const OrbExtractor& SmallExtractor();

// TexturedRoom without noise, as SmallCamera() sees it.
RgbdImage SmallRoomImage(const Rigid3d& T_world_camera, Stamp stamp);
std::shared_ptr<const FrameFeatures> SmallRoomFeatures(const Rigid3d& T_world_camera, Stamp stamp);

// An image of SmallCamera()'s full of corners that no other seed has: grey squares of 8 px, 2 m
// away.
RgbdImage SquaresImage(std::uint32_t seed);
std::shared_ptr<const FrameFeatures> SquaresFeatures(std::uint32_t seed);

// An image without a single corner, 2 m away.
RgbdImage BlankImage(Stamp stamp);

// Adds a keyframe, and a new point for each of its features that has depth.
KeyframeId AddKeyframeWithPoints(Map& map, std::shared_ptr<const FrameFeatures> features,
                                 const Rigid3d& T_map_camera);

// Where two poses differ: distance of the origins [m] and angle [rad].
double DistanceBetween(const Rigid3d& a, const Rigid3d& b);
double AngleBetween(const Rigid3d& a, const Rigid3d& b);

// A pose `distance_m` and `angle_rad` away from `T`, in a direction that the seed chooses.
Rigid3d Nudged(const Rigid3d& T, double distance_m, double angle_rad, std::uint32_t seed);

}  // namespace semantic_slam
