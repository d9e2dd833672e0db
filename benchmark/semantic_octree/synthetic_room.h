#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

// A room of 6 x 5 x 2.6 m with thirty boxes, seen by a 640 x 480 camera on a loop of 100 poses: the
// sequence on which mappers are compared. It is a function of its own arithmetic alone, so every
// program that contains it sees the same.
namespace synthetic_room {

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kClasses = 13;  // 0 is "unknown"
constexpr int kFrames = 100;
constexpr float kFocalLength = 525.0f;
constexpr float kCentreX = 319.5f;
constexpr float kCentreY = 239.5f;

struct Frame {
  int id = 0;
  Eigen::Matrix3f R_map_camera;
  Eigen::Vector3f position;           // of the camera, in the map [m]
  std::vector<SemanticPoint> points;  // in the camera's frame; without pixels that have no depth
  std::vector<std::uint8_t> true_classes;  // per pixel
  std::vector<float> true_depth_m;         // per pixel

  Rigid3d T_map_camera() const;
};

// The image of that id in 0..kFrames-1. Points have an Xtion's noise and 1 % drop-outs, labels
// bleed by up to 4 px, and in 15 % of 8 x 8 px blocks the first label is wrong.
void Render(int id, Frame& frame);

// What of a frame Render() makes without points: pose, classes and depth.
void RenderTruth(int id, Frame& frame);

// Twelve classes and "unknown".
LabelVocabulary Vocabulary();

}  // namespace synthetic_room
}  // namespace semantic_slam
