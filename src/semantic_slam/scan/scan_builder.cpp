#include "semantic_slam/scan/scan_builder.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "semantic_slam/camera/level_frame.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr float kMinHorizontal = 1e-3f;  // shorter rays (per metre of depth) count as vertical
constexpr float kLevel = 1e6f;  // metres ahead per metre up: a ray that is as good as level

const ScanBuilderOptions& Checked(const ScanBuilderOptions& options) {
  CheckScanBuilderOptions(options);
  return options;
}

// The widest angle [rad] between a ray and the optical axis.
double HalfDiagonalAngle(const CameraModel& camera) {
  double widest = 0.0;
  for (const int v : {0, camera.height_px() - 1}) {
    for (const int u : {0, camera.width_px() - 1}) {
      widest = std::max(widest, std::atan(static_cast<double>(camera.Ray(u, v).norm())));
    }
  }
  return widest;
}

// A sampled pixel on the optical axis of a level camera covers so much slope times bearing; divided
// by a beam's width it is the share of the beam's height.
float PixelSlope(const CameraIntrinsics& camera, const ScanBuilderOptions& options) {
  const double area = options.row_stride / (camera.fx_px * camera.fy_px);
  return static_cast<float>(area / (options.beam_spacing_deg * M_PI / 180.0));
}

}  // namespace

void CheckScanBuilderOptions(const ScanBuilderOptions& options) {
  Validate(options);
  if (options.band_lower_m < options.band_upper_m) return;
  std::ostringstream what;
  what << "band_lower_m = " << options.band_lower_m
       << ", but must be below band_upper_m = " << options.band_upper_m;
  throw ConfigError(what.str());
}

ScanBuilder::ScanBuilder(const ScanBuilderOptions& options,
                         std::shared_ptr<const CameraModel> camera)
    : options_(Checked(options)),
      camera_(std::move(camera)),
      step_rad_(static_cast<float>(options_.beam_spacing_deg * M_PI / 180.0)),
      beams_(2 * static_cast<int>(std::ceil(HalfDiagonalAngle(*camera_) / step_rad_))),
      pixel_slope_(PixelSlope(camera_->intrinsics(), options_)) {}

PlanarScan ScanBuilder::Build(const RgbdImage& image, const Rigid3d& T_map_camera) const {
  CheckRgbdImage(image, *camera_);
  if (!IsFinite(T_map_camera)) throw InputError("the camera's pose is not finite");
  const double base_m = options_.fixed_band ? T_map_camera.translation().z() : 0.0;
  const Band band{static_cast<float>(options_.band_lower_m - base_m),
                  static_cast<float>(options_.band_upper_m - base_m)};
  const Eigen::Vector3d up_camera = T_map_camera.linear().row(2).normalized();
  const BeamHistogram histogram =
      Collect(image.depth_m, LevelFromCamera(up_camera).cast<float>(), band);

  PlanarScan scan;
  scan.stamp = image.stamp;
  scan.bearing_step_rad = step_rad_;
  scan.first_bearing_rad = 0.5 * (1 - beams_) * scan.bearing_step_rad;
  scan.max_range_m = options_.max_range_m;
  scan.beams.reserve(beams_);
  for (int beam = 0; beam < beams_; ++beam) scan.beams.push_back(Summarise(histogram, beam));
  return scan;
}

BeamHistogram ScanBuilder::Collect(const cv::Mat& depth_m, const Eigen::Matrix3f& R_level_camera,
                                   const Band& band) const {
  BeamHistogram histogram(beams_, max_range_m());
  for (int v = 0; v < depth_m.rows; v += options_.row_stride) {
    const auto* depth_row = depth_m.ptr<float>(v);
    for (int u = 0; u < depth_m.cols; ++u) {
      const float pixel_depth_m = depth_row[u];
      if (!(pixel_depth_m > 0.0f) || !std::isfinite(pixel_depth_m)) continue;
      const Eigen::Vector3f ray = R_level_camera * camera_->Ray(u, v).homogeneous();
      const float horizontal = std::sqrt(ray.x() * ray.x() + ray.y() * ray.y());
      const float range_m = pixel_depth_m * horizontal;
      if (horizontal < kMinHorizontal || range_m < min_range_m()) continue;
      const RangeInterval inside = InsideBand(ray.z() / horizontal, band);
      if (inside.from_m >= std::min(inside.to_m, range_m)) continue;
      const int beam = BeamOf(ray.x(), ray.y());
      if (beam < 0) continue;
      // Turned away from the axis and tilted, a pixel covers less or more of slope and bearing.
      const float slope = pixel_slope_ / (horizontal * horizontal * horizontal);
      histogram.AddFree(beam, {inside.from_m, std::min(inside.to_m, range_m)}, slope);
      if (range_m <= inside.to_m && range_m < max_range_m()) histogram.AddHit(beam, range_m);
    }
  }
  return histogram;
}

// Where a ray that climbs by `slope` per metre is inside the band.
RangeInterval ScanBuilder::InsideBand(float slope, const Band& band) const {
  const float inverse = std::clamp(1.0f / slope, -kLevel, kLevel);  // a level ray's is infinite
  const float at_lower_m = band.lower_m * inverse, at_upper_m = band.upper_m * inverse;
  return {std::max(0.0f, std::min(at_lower_m, at_upper_m)),
          std::min(max_range_m(), std::max(at_lower_m, at_upper_m))};
}

// -1 outside the beams.
int ScanBuilder::BeamOf(float x, float y) const {
  const float beam = std::atan2(y, x) / step_rad_ + 0.5f * static_cast<float>(beams_);
  return beam >= 0.0f && beam < static_cast<float>(beams_) ? static_cast<int>(beam) : -1;
}

ScanBeam ScanBuilder::Summarise(const BeamHistogram& histogram, int beam) const {
  ScanBeam summary;
  summary.hit_m = histogram.NearestSurface(beam, options_.min_pixels,
                                           [this](float range_m) { return SurfaceDepth(range_m); });
  const double height_m = options_.min_free_share * (options_.band_upper_m - options_.band_lower_m);
  const RangeInterval free =
      histogram.FreeStretch(beam, options_.min_pixels, static_cast<float>(height_m));
  // The place of the robot itself is free.
  summary.free_from_m = free.from_m <= min_range_m() ? 0.0f : free.from_m;
  summary.free_to_m = std::isfinite(summary.hit_m) ? std::min(free.to_m, summary.hit_m) : free.to_m;
  return summary;
}

// Two standard deviations of the sensor to either side are added.
float ScanBuilder::SurfaceDepth(float range_m) const {
  return static_cast<float>(options_.surface_depth_m +
                            4.0 * options_.depth_sigma_at_1m_m * range_m * range_m);
}

}  // namespace semantic_slam
