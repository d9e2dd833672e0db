#include "semantic_slam/object_mapping/object_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include "semantic_slam/plane_projection/plane_ransac.h"

namespace semantic_slam {
namespace {

using Points = std::vector<Eigen::Vector3f>;

constexpr int kMaxBackgroundPlanes = 3;
constexpr int kMaxSurroundPoints = 400;
constexpr int kMinSurroundPoints = 30;  // fewer say nothing about a plane
// Of pixels that are read, columns are four times farther apart than rows: what lies level is seen
// at a flat angle, 7 degrees at worst, so that its rows are eight times farther apart in space.
constexpr double kRowsPerColumn = 4.0;
constexpr double kRowSlant = 8.0;
constexpr double kColumnSlant = 2.0;
constexpr double kFrontQuantile = 0.2;  // of the depths in the middle of a box: its nearest surface

// The pixels whose centre is in the box: an edge may lie half a pixel outside of the image.
cv::Rect PixelsIn(const cv::Rect2f& box, cv::Size image) {
  const auto clamped = [](float value, int size) {
    return static_cast<int>(std::ceil(std::clamp(value, 0.0f, static_cast<float>(size))));
  };
  const int left = clamped(box.x, image.width), right = clamped(box.x + box.width, image.width);
  const int top = clamped(box.y, image.height), bottom = clamped(box.y + box.height, image.height);
  return {left, top, right - left, bottom - top};
}

// Distances [px] between the columns and the rows that are read.
struct Grid {
  int du = 1;
  int dv = 1;
};

Grid GridFor(int pixels, int max_points) {
  const double pixels_per_point = static_cast<double>(pixels) / max_points;
  Grid grid;
  grid.dv =
      std::max(1, static_cast<int>(std::lround(std::sqrt(pixels_per_point / kRowsPerColumn))));
  grid.du = std::max(1, static_cast<int>(std::ceil(pixels_per_point / grid.dv)));
  return grid;
}

cv::Rect2f Grown(const cv::Rect2f& box, double share) {
  const auto dx = static_cast<float>(share * box.width),
             dy = static_cast<float>(share * box.height);
  return {box.x - dx, box.y - dy, box.width + 2.0f * dx, box.height + 2.0f * dy};
}

float MedianDepth(const Points& points) {
  std::vector<float> depths;
  for (const Eigen::Vector3f& p : points) depths.push_back(p.z());
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

// Splits the points of one box into object and others, step by step.
class Extraction {
 public:
  Extraction(const RgbdImage& image, const CameraModel& camera, const ObjectPointsOptions& options)
      : image_(image), camera_(camera), options_(options) {}

  std::optional<ObjectPoints> Run(const cv::Rect2f& box) {
    inner_ = PixelsIn(box, image_.depth_m.size());
    if (inner_.empty()) return std::nullopt;
    grid_ = GridFor(inner_.area(), options_.max_points);
    points_ = Read(inner_, grid_, cv::Rect());
    if (IsTooFew(points_.size())) return std::nullopt;
    RemoveBackgroundPlanes();
    RemoveFarBehind();
    if (IsTooFew(points_.size()) || !KeepLargestCluster() || !SpansBox()) return std::nullopt;
    return ObjectPoints{std::move(points_), std::move(others_), IsComplete(box)};
  }

 private:
  bool IsTooFew(std::size_t count) const {
    return count < static_cast<std::size_t>(options_.min_points);
  }

  bool IsComplete(const cv::Rect2f& box) const {
    const auto border = static_cast<float>(options_.border_px);
    const auto width = static_cast<float>(image_.depth_m.cols);
    const auto height = static_cast<float>(image_.depth_m.rows);
    return box.x > border && box.y > border && box.x + box.width < width - border &&
           box.y + box.height < height - border;
  }

  Points Read(const cv::Rect& region, const Grid& grid, const cv::Rect& except) const {
    Points points;
    for (int v = region.y + grid.dv / 2; v < region.y + region.height; v += grid.dv) {
      const float* depth = image_.depth_m.ptr<float>(v);
      for (int u = region.x + grid.du / 2; u < region.x + region.width; u += grid.du) {
        const float z = depth[u];
        if (!(z > 0.0f && z <= options_.max_depth_m) || except.contains({u, v})) continue;
        const Eigen::Vector2f& ray = camera_.Ray(u, v);
        points.emplace_back(ray.x() * z, ray.y() * z, z);
      }
    }
    return points;
  }

  // Moves the points for which `is_other` holds to the others.
  template <typename Predicate>
  void MoveToOthers(Predicate&& is_other) {
    const auto first_other = std::stable_partition(
        points_.begin(), points_.end(), [&](const Eigen::Vector3f& p) { return !is_other(p); });
    others_.insert(others_.end(), first_other, points_.end());
    points_.erase(first_other, points_.end());
  }

  double Tolerance(float depth_m) const {
    return options_.plane_tolerance_m + options_.depth_noise_per_m2 * depth_m * depth_m;
  }

  bool IsOn(const Plane& plane, const Eigen::Vector3f& p) const {
    return std::abs(plane.SignedDistance(p.cast<double>())) <= Tolerance(p.z());
  }

  void RemoveBackgroundPlanes() {
    const cv::Rect outer = PixelsIn(Grown(inner_, options_.surround_share), image_.depth_m.size());
    const int pixels = outer.area() - inner_.area();
    Points surroundings = Read(outer, GridFor(pixels, kMaxSurroundPoints), inner_);
    if (surroundings.size() < kMinSurroundPoints) return;
    const auto enough = static_cast<int>(options_.min_plane_share * surroundings.size());
    const auto least = static_cast<std::size_t>(options_.min_foreground_share * points_.size());
    PlaneConstraint constraint;
    constraint.tolerance_m = Tolerance(MedianDepth(surroundings));
    for (int i = 0; i < kMaxBackgroundPlanes; ++i) {
      const auto fit = FitPlane(surroundings, std::max(enough, kMinSurroundPoints), constraint);
      if (!fit) return;
      const auto is_on = [&](const Eigen::Vector3f& p) { return IsOn(fit->plane, p); };
      surroundings.erase(std::remove_if(surroundings.begin(), surroundings.end(), is_on),
                         surroundings.end());
      const auto on = std::count_if(points_.begin(), points_.end(), is_on);
      const std::size_t left = points_.size() - static_cast<std::size_t>(on);
      if (left >= least && !IsTooFew(left)) MoveToOthers(is_on);
    }
  }

  void RemoveFarBehind() {
    std::vector<float> depths;
    const Eigen::Vector2f low =
        camera_.Ray(inner_.x + inner_.width / 4, inner_.y + inner_.height / 4);
    const Eigen::Vector2f high =
        camera_.Ray(inner_.x + 3 * inner_.width / 4, inner_.y + 3 * inner_.height / 4);
    for (const Eigen::Vector3f& p : points_) {
      const Eigen::Vector2f ray = p.head<2>() / p.z();
      if ((ray.array() >= low.array()).all() && (ray.array() <= high.array()).all()) {
        depths.push_back(p.z());
      }
    }
    if (depths.empty()) return;
    const auto front = depths.begin() + static_cast<std::ptrdiff_t>(kFrontQuantile * depths.size());
    std::nth_element(depths.begin(), front, depths.end());
    const double width = inner_.width / camera_.intrinsics().fx_px;
    const double height = inner_.height / camera_.intrinsics().fy_px;
    const double until = *front * (1.0 + options_.max_depth_to_size * std::max(width, height));
    MoveToOthers([&](const Eigen::Vector3f& p) { return p.z() > until; });
  }

  bool KeepLargestCluster() {
    const auto cloud = pcl::PointCloud<pcl::PointXYZ>::Ptr(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Eigen::Vector3f& p : points_) cloud->push_back({p.x(), p.y(), p.z()});
    const double spacing_px = std::max(kColumnSlant * grid_.du, kRowSlant * grid_.dv);
    const double spacing_m = spacing_px * MedianDepth(points_) / camera_.intrinsics().fx_px;
    pcl::EuclideanClusterExtraction<pcl::PointXYZ> clustering;
    clustering.setClusterTolerance(std::max(options_.cluster_gap_m, spacing_m));
    clustering.setMinClusterSize(options_.min_points);
    constexpr bool kSorted = false;  // by distance: clusters do not need it
    clustering.setSearchMethod(
        pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>(kSorted)));
    clustering.setInputCloud(cloud);
    std::vector<pcl::PointIndices> clusters;
    clustering.extract(clusters);
    if (clusters.empty()) return false;
    // PCL sorts clusters by size alone; of equally large ones the one with the first point.
    const auto largest =
        std::max_element(clusters.begin(), clusters.end(),
                         [](const pcl::PointIndices& a, const pcl::PointIndices& b) {
                           if (a.indices.size() != b.indices.size())
                             return a.indices.size() < b.indices.size();
                           return *std::min_element(a.indices.begin(), a.indices.end()) >
                                  *std::min_element(b.indices.begin(), b.indices.end());
                         });
    std::vector<char> in_cluster(points_.size(), 0);
    for (const int i : largest->indices) in_cluster[i] = 1;
    Points object;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      (in_cluster[i] ? object : others_).push_back(points_[i]);
    }
    points_.swap(object);
    return true;
  }

  bool SpansBox() const {
    Eigen::Array2f low = Eigen::Array2f::Constant(std::numeric_limits<float>::max());
    Eigen::Array2f high = -low;
    for (const Eigen::Vector3f& p : points_) {
      const Eigen::Array2f ray = (p.head<2>() / p.z()).array();
      low = low.min(ray);
      high = high.max(ray);
    }
    // A reading stands for as many pixels as are between it and the next.
    const auto width = (high - low).x() * camera_.intrinsics().fx_px + grid_.du;
    const auto height = (high - low).y() * camera_.intrinsics().fy_px + grid_.dv;
    return width >= options_.min_extent_share * inner_.width &&
           height >= options_.min_extent_share * inner_.height;
  }

  const RgbdImage& image_;
  const CameraModel& camera_;
  const ObjectPointsOptions& options_;
  cv::Rect inner_;  // the box's pixels
  Grid grid_;
  Points points_;
  Points others_;
};

}  // namespace

std::optional<ObjectPoints> ExtractObjectPoints(const cv::Rect2f& box, const RgbdImage& image,
                                                const CameraModel& camera,
                                                const ObjectPointsOptions& options) {
  return Extraction(image, camera, options).Run(box);
}

}  // namespace semantic_slam
