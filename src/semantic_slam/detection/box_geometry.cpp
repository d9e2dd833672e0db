#include "semantic_slam/detection/box_geometry.h"

#include <cmath>

namespace semantic_slam {

cv::Size2f UnitOf(const ModelCard& card) {
  if (card.head.units == BoxUnits::kPixels) return {1.0f, 1.0f};
  return {static_cast<float>(card.input.width_px), static_cast<float>(card.input.height_px)};
}

cv::Rect2f BoxOfCorners(const float* values, cv::Size2f unit) {
  return {values[0] * unit.width, values[1] * unit.height, (values[2] - values[0]) * unit.width,
          (values[3] - values[1]) * unit.height};
}

cv::Rect2f BoxOfCentre(const float* values, cv::Size2f unit) {
  return {(values[0] - 0.5f * values[2]) * unit.width, (values[1] - 0.5f * values[3]) * unit.height,
          values[2] * unit.width, values[3] * unit.height};
}

bool IsUsable(const cv::Rect2f& box) {
  return std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) &&
         std::isfinite(box.height) && box.width > 0.0f && box.height > 0.0f;
}

std::optional<cv::Rect2f> PartInImage(const cv::Rect2f& box, const ImageFit& fit, cv::Size image) {
  const cv::Point2f half(0.5f, 0.5f);  // from corners of pixels to their centres
  const cv::Rect2f in_image(fit.ToImage(box.tl() - half), fit.ToImage(box.br() - half));
  const cv::Rect2f visible = in_image & cv::Rect2f(-half, cv::Size2f(image));
  return IsUsable(visible) ? std::optional(visible) : std::nullopt;
}

double IntersectionOverUnion(const cv::Rect2f& a, const cv::Rect2f& b) {
  const cv::Rect2d wide_a(a), wide_b(b);
  const double both = (wide_a & wide_b).area();
  return both > 0.0 ? both / (wide_a.area() + wide_b.area() - both) : 0.0;
}

}  // namespace semantic_slam
