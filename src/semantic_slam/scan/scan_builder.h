#pragma once

#include <memory>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/scan/beam_histogram.h"
#include "semantic_slam/scan/planar_scan.h"

namespace semantic_slam {

struct ScanBuilderOptions {
  // The band of heights that a thing must reach into to be an obstacle. A drone flies at its
  // camera's height, so by default the band goes up and down with the camera.
  bool fixed_band = false;     // true: the heights are the map's z and stay where they are
  double band_lower_m = -0.2;  // from the camera's height, or in the map
  double band_upper_m = 0.2;   // likewise
  double min_range_m = 0.3;    // nearer things are the robot's own
  double max_range_m = 5.0;    // horizontal; farther depth is too noisy
  double beam_spacing_deg = 0.5;
  int row_stride = 4;             // every so many rows of the image are looked at
  int min_pixels = 4;             // that must agree before a beam hits something or is free
  double min_free_share = 0.5;    // of the band's height that must be in view and seen to be free
  double surface_depth_m = 0.05;  // how far the hits of one surface spread along a beam
  double depth_sigma_at_1m_m = 0.0015;  // of the sensor; grows with depth squared

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("fixed_band", self.fixed_band);
    visit("band_lower_m", self.band_lower_m, -100.0, 100.0);
    visit("band_upper_m", self.band_upper_m, -100.0, 100.0);
    visit("min_range_m", self.min_range_m, 0.0, 5.0);
    visit("max_range_m", self.max_range_m, 0.5, 30.0);
    visit("beam_spacing_deg", self.beam_spacing_deg, 0.05, 10.0);
    visit("row_stride", self.row_stride, 1, 16);
    visit("min_pixels", self.min_pixels, 1, 1000);
    visit("min_free_share", self.min_free_share, 0.0, 1.0);
    visit("surface_depth_m", self.surface_depth_m, 0.0, 1.0);
    visit("depth_sigma_at_1m_m", self.depth_sigma_at_1m_m, 0.0, 0.1);
  }
};

// Throws ConfigError if an option is out of range or the band is empty.
void CheckScanBuilderOptions(const ScanBuilderOptions& options);

// Turns depth images into planar scans of a band of heights (thesis section 3.4.2), whichever way
// the camera is tilted. Immutable, so safe from any thread.
//
// A beam hits the nearest surface inside the band. It is free where most of the band's height was
// in view and seen to be free: a pixel without depth says nothing, and a camera that is tilted away
// from the band does not clear it. All else is unknown. The beams cover what the camera can see
// ahead when it is rolled in any way: half the angle across the image's diagonal to either side.
class ScanBuilder {
 public:
  // Throws ConfigError as CheckScanBuilderOptions() does.
  ScanBuilder(const ScanBuilderOptions& options, std::shared_ptr<const CameraModel> camera);

  // The scan in LevelPose(T_map_camera), stamped as the image. The map has z up. Throws InputError
  // if the image does not fit the camera or the pose is not finite.
  PlanarScan Build(const RgbdImage& image, const Rigid3d& T_map_camera) const;

 private:
  // The band, by height over the camera [m].
  struct Band {
    float lower_m;
    float upper_m;
  };

  BeamHistogram Collect(const cv::Mat& depth_m, const Eigen::Matrix3f& R_level_camera,
                        const Band& band) const;
  RangeInterval InsideBand(float slope, const Band& band) const;
  int BeamOf(float x, float y) const;
  ScanBeam Summarise(const BeamHistogram& histogram, int beam) const;
  float SurfaceDepth(float range_m) const;
  float min_range_m() const { return static_cast<float>(options_.min_range_m); }
  float max_range_m() const { return static_cast<float>(options_.max_range_m); }

  const ScanBuilderOptions options_;
  const std::shared_ptr<const CameraModel> camera_;
  const float step_rad_;
  const int beams_;
  const float pixel_slope_;  // height per distance, spread over a beam, of a sampled level pixel
};

}  // namespace semantic_slam
