#pragma once

#include <memory>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

struct CloudBuilderOptions {
  int stride_px = 2;                // every n-th pixel of every n-th row becomes a point
  double min_depth_m = 0.3;         // nearer pixels are dropped
  double max_depth_m = 5.0;         // farther ones too
  double max_depth_jump = 0.05;     // to any of the four neighbours, relative to the depth; 0: any
  double max_incidence_deg = 90.0;  // between the ray and the surface's normal; 90: any

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("stride_px", self.stride_px, 1, 32);
    visit("min_depth_m", self.min_depth_m, 0.0, 10.0);
    visit("max_depth_m", self.max_depth_m, 0.1, 30.0);
    visit("max_depth_jump", self.max_depth_jump, 0.0, 1.0);
    visit("max_incidence_deg", self.max_incidence_deg, 10.0, 90.0);
  }
};

// The options. Throws ConfigError if one is out of range or min_depth_m is not below max_depth_m.
const CloudBuilderOptions& Checked(const CloudBuilderOptions& options);

// Makes the semantic point cloud of an image, thesis section 3.3.2. Immutable, so safe from any
// thread.
class CloudBuilder {
 public:
  // Throws ConfigError as Checked() does.
  CloudBuilder(const CloudBuilderOptions& options, std::shared_ptr<const CameraModel> camera);

  // One point per pixel of the grid that has a usable depth: p = depth * ray of the pixel, thesis
  // eq. (3.16) with its ERRATA and the distortion. Depth is metres here whatever it came as, so
  // 16UC1 and 32FC1 of the same values give the same points. No depth, no points: not an error.
  //
  // Left out are pixels beside a jump in depth, where sensors report points in mid-air, and
  // surfaces seen at a grazing angle, where neither depth nor label is to be trusted.
  //
  // Throws InputError if image and segmentation differ in stamp or size, are not of the camera's
  // size or are of another type than they should be. Label ids are passed on unchecked.
  SemanticCloud Build(const RgbdImage& image, const Segmentation& segmentation) const;

 private:
  void CheckInputs(const RgbdImage& image, const Segmentation& segmentation) const;
  bool IsGrazing(const cv::Mat& depth_m, int u, int v) const;

  const CloudBuilderOptions options_;
  const std::shared_ptr<const CameraModel> camera_;
  const float cos_max_incidence_;
};

}  // namespace semantic_slam
