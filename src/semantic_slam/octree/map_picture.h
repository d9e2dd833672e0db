#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/octree/voxel_colours.h"

namespace semantic_slam {

struct MapPictureOptions {
  ColourMode colour_mode = ColourMode::kClass;
  double max_z_m = std::numeric_limits<double>::max();  // in the map: higher voxels are left out
  std::vector<std::string> hidden_classes{"ceiling"};   // they would cover everything
  std::vector<Eigen::Vector3d> camera_path_m;           // drawn on top; may be empty
};

// The map from above, x to the right and y up: of each column the highest occupied voxel, the
// darker the lower, with a scale, and in the colours of the classes with a legend of those that are
// in the map. An empty map gives a picture that says so. CV_8UC3, BGR.
cv::Mat DrawMapFromAbove(const SemanticOcTree& tree, const LabelVocabulary& vocabulary,
                         const MapPictureOptions& options = {});

// The same into a PNG file. Throws InputError naming the path if it cannot be written.
void WriteMapFromAbove(const std::string& path, const SemanticOcTree& tree,
                       const LabelVocabulary& vocabulary, const MapPictureOptions& options = {});

}  // namespace semantic_slam
