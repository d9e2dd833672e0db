#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

enum class HorizontalAlign { kLeft, kCentre, kRight };

// A white page to draw figures on: lines and lettering are anti-aliased by OpenCV and by drawing at
// twice the size. Positions and sizes are pixels of the final image, x to the right, y down;
// colours are BGR. Not thread-safe.
class PlotCanvas {
 public:
  explicit PlotCanvas(cv::Size size);

  void Line(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour, double width);
  void DashedLine(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour, double width);
  void Polyline(const std::vector<cv::Point2d>& points, const cv::Scalar& colour, double width);
  void Rectangle(const cv::Rect2d& box, const cv::Scalar& colour, double width);
  // Filled, with a white rim that sets it off from what lies beneath.
  void Dot(cv::Point2d centre, double radius, const cv::Scalar& colour);
  void Square(cv::Point2d centre, double half_side, const cv::Scalar& colour);
  // A picture as it is, CV_8UC3. Precondition: it lies inside the page.
  void Paste(const cv::Mat& picture, cv::Point top_left);

  // ASCII only. `anchor` is on the base line; `height` is that of a capital letter.
  void Text(const std::string& text, cv::Point2d anchor, HorizontalAlign align, double height,
            const cv::Scalar& colour);
  // The same with a white rim, for pictures beneath.
  void RimmedText(const std::string& text, cv::Point2d anchor, HorizontalAlign align, double height,
                  const cv::Scalar& colour);
  // Upwards, centred on `centre`.
  void VerticalText(const std::string& text, cv::Point2d centre, double height,
                    const cv::Scalar& colour);
  static double TextWidth(const std::string& text, double height);

  cv::Mat Image() const;  // CV_8UC3

 private:
  void PutText(const std::string& text, cv::Point2d anchor, HorizontalAlign align, double height,
               const cv::Scalar& colour, double rim);

  cv::Size size_;
  cv::Mat pixels_;  // larger than size_
};

}  // namespace semantic_slam
