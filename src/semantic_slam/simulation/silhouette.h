#pragma once

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// The pixels that an object would cover if nothing hid it, also where it leaves the image: as far
// as an image's width and height beyond each edge. What is nearer than 5 cm to the camera's plane
// is left out, and parts of it hang still.
int SilhouettePixels(const WorldObject& object, const Rigid3d& T_camera_object,
                     const CameraIntrinsics& intrinsics);

}  // namespace semantic_slam
