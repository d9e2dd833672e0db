#include "semantic_slam/semantic_cloud/cloud_builder.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

constexpr double kDegree = M_PI / 180.0;

// Half the width of the stencil that a surface's slope is taken from: depth is too noisy for less.
constexpr int kSlopeReachPx = 4;

std::string SizeText(const cv::Mat& image) {
  return std::to_string(image.cols) + " x " + std::to_string(image.rows) + " px";
}

void CheckPlanes(const std::array<cv::Mat, kTopLabels>& planes, const cv::Mat& colour,
                 const char* what) {
  for (const cv::Mat& plane : planes) {
    if (plane.type() == CV_8UC1 && plane.size() == colour.size()) continue;
    throw InputError("segmentation: a plane of " + std::string(what) + " is " +
                     cv::typeToString(plane.type()) + " of " + SizeText(plane) +
                     ", expected CV_8UC1 of " + SizeText(colour));
  }
}

// Marks in `usable` the pixels of row v whose depth lies in [min_m, max_m] and differs by at most
// `jump` times itself from its four neighbours. Comparisons with NaN are false, so a missing depth
// is never usable and never an edge. Plain loops over whole rows: the compiler makes vectors of
// them.
void MarkUsable(const cv::Mat& depth_m, int v, float min_m, float max_m, float jump,
                std::vector<std::uint8_t>& usable) {
  const int width = depth_m.cols;
  const float* const here = depth_m.ptr<float>(v);
  for (int u = 0; u < width; ++u) usable[u] = (here[u] >= min_m) & (here[u] <= max_m);
  if (jump <= 0.0f) return;
  const float* const above = depth_m.ptr<float>(std::max(v - 1, 0));
  const float* const below = depth_m.ptr<float>(std::min(v + 1, depth_m.rows - 1));
  for (int u = 0; u < width; ++u) {
    const float limit = jump * here[u];
    usable[u] &=
        !(std::fabs(above[u] - here[u]) > limit) & !(std::fabs(below[u] - here[u]) > limit);
  }
  for (int u = 1; u < width; ++u) usable[u] &= !(std::fabs(here[u - 1] - here[u]) > jump * here[u]);
  for (int u = 0; u + 1 < width; ++u)
    usable[u] &= !(std::fabs(here[u + 1] - here[u]) > jump * here[u]);
}

// Reads the pixels of one row as points.
class RowReader {
 public:
  RowReader(const RgbdImage& image, const Segmentation& segmentation, int v)
      : depth_m_(image.depth_m.ptr<float>(v)),
        colour_(image.colour.ptr<cv::Vec3b>(v)),
        first_channel_(image.order == ColourOrder::kRgb ? 0 : 2) {
    for (int i = 0; i < kTopLabels; ++i) {
      labels_[i] = segmentation.labels[i].ptr<LabelId>(v);
      confidences_[i] = segmentation.confidences[i].ptr<std::uint8_t>(v);
    }
  }

  SemanticPoint Read(int u, const Eigen::Vector2f& ray) const {
    const float z = depth_m_[u];
    const cv::Vec3b& c = colour_[u];
    SemanticPoint point;
    point.position = Eigen::Vector3f(ray.x() * z, ray.y() * z, z);
    point.rgb = {c[first_channel_], c[1], c[2 - first_channel_]};
    for (int i = 0; i < kTopLabels; ++i) {
      point.labels[i] = labels_[i][u];
      point.confidences[i] = static_cast<float>(confidences_[i][u]) * (1.0f / 255.0f);
    }
    return point;
  }

 private:
  const float* depth_m_;
  const cv::Vec3b* colour_;
  int first_channel_;  // of red
  std::array<const LabelId*, kTopLabels> labels_{};
  std::array<const std::uint8_t*, kTopLabels> confidences_{};
};

}  // namespace

const CloudBuilderOptions& Checked(const CloudBuilderOptions& options) {
  Validate(options);
  if (options.min_depth_m >= options.max_depth_m) {
    std::ostringstream what;
    what << "min_depth_m = " << options.min_depth_m
         << ", but must be below max_depth_m = " << options.max_depth_m;
    throw ConfigError(what.str());
  }
  return options;
}

CloudBuilder::CloudBuilder(const CloudBuilderOptions& options,
                           std::shared_ptr<const CameraModel> camera)
    : options_(Checked(options)),
      camera_(std::move(camera)),
      cos_max_incidence_(static_cast<float>(std::cos(options_.max_incidence_deg * kDegree))) {}

SemanticCloud CloudBuilder::Build(const RgbdImage& image, const Segmentation& segmentation) const {
  CheckInputs(image, segmentation);
  const auto min_m = static_cast<float>(options_.min_depth_m);
  const auto max_m = static_cast<float>(options_.max_depth_m);
  const auto jump = static_cast<float>(options_.max_depth_jump);
  const bool any_incidence = options_.max_incidence_deg >= 90.0;
  const int stride = options_.stride_px;
  const int width = image.depth_m.cols, height = image.depth_m.rows;

  SemanticCloud cloud;
  cloud.stamp = image.stamp;
  cloud.vocabulary_hash = segmentation.vocabulary_hash;
  cloud.points.reserve(static_cast<std::size_t>(width / stride + 1) * (height / stride + 1));
  std::vector<std::uint8_t> usable(width);
  for (int v = stride / 2; v < height; v += stride) {
    MarkUsable(image.depth_m, v, min_m, max_m, jump, usable);
    const RowReader row(image, segmentation, v);
    for (int u = stride / 2; u < width; u += stride) {
      if (!usable[u] || (!any_incidence && IsGrazing(image.depth_m, u, v))) continue;
      cloud.points.push_back(row.Read(u, camera_->Ray(u, v)));
    }
  }
  return cloud;
}

void CloudBuilder::CheckInputs(const RgbdImage& image, const Segmentation& segmentation) const {
  CheckRgbdImage(image, *camera_);
  if (segmentation.stamp != image.stamp) {
    throw InputError("segmentation is of the image at " + ToString(segmentation.stamp) +
                     " s, expected " + ToString(image.stamp));
  }
  CheckPlanes(segmentation.labels, image.colour, "labels");
  CheckPlanes(segmentation.confidences, image.colour, "confidences");
}

// On a plane n . p = d the inverse depth is linear in the ray r = (x, y, 1): 1/z = n . r / d. So
// its gradient gives the normal, and the cosine of the incidence is n . r / (|n| |r|). False where
// depth is missing nearby.
bool CloudBuilder::IsGrazing(const cv::Mat& depth_m, int u, int v) const {
  const int left = std::max(u - kSlopeReachPx, 0),
            right = std::min(u + kSlopeReachPx, depth_m.cols - 1);
  const int top = std::max(v - kSlopeReachPx, 0),
            bottom = std::min(v + kSlopeReachPx, depth_m.rows - 1);
  const float inverse = 1.0f / depth_m.at<float>(v, u);
  const Eigen::Vector3f ray{camera_->Ray(u, v).x(), camera_->Ray(u, v).y(), 1.0f};
  const float slope_x = (1.0f / depth_m.at<float>(v, right) - 1.0f / depth_m.at<float>(v, left)) /
                        (camera_->Ray(right, v).x() - camera_->Ray(left, v).x());
  const float slope_y = (1.0f / depth_m.at<float>(bottom, u) - 1.0f / depth_m.at<float>(top, u)) /
                        (camera_->Ray(u, bottom).y() - camera_->Ray(u, top).y());
  const Eigen::Vector3f normal(slope_x, slope_y, inverse - slope_x * ray.x() - slope_y * ray.y());
  return inverse < cos_max_incidence_ * normal.norm() * ray.norm();
}

}  // namespace semantic_slam
