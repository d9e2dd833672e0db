#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/octree/voxel_colours.h"

namespace semantic_slam {

struct VoxelViewOptions {
  double near_m = 0.3;  // nearer voxels are left out: they would fill the view
  double far_m = 30.0;
  double max_z_m =
      1000.0;  // in the map: higher voxels are left out, so that one sees under a ceiling
};

// The occupied voxels as a camera in the map sees them: cubes, shaded by the side that one looks
// at, on white. The camera's distortion is left out. CV_8UC3, BGR, of the camera's size.
cv::Mat RenderVoxels(const SemanticOcTree& tree, const VoxelColours& colours,
                     const CameraIntrinsics& intrinsics, const Rigid3d& T_map_camera,
                     const VoxelViewOptions& options = {});

}  // namespace semantic_slam
