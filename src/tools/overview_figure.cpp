#include "tools/overview_figure.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

const cv::Size kPanel(640, 480);
constexpr int kTitlePx = 34;
constexpr int kGapPx = 8;
const cv::Scalar kPaper(255, 255, 255);
const cv::Scalar kInk(40, 40, 40);

// The largest rectangle of the picture's shape in the middle of `area`.
cv::Rect Centred(const cv::Size& picture, const cv::Rect& area) {
  const double scale = std::min(static_cast<double>(area.width) / picture.width,
                                static_cast<double>(area.height) / picture.height);
  const cv::Size size(std::max(1, static_cast<int>(std::lround(picture.width * scale))),
                      std::max(1, static_cast<int>(std::lround(picture.height * scale))));
  return {area.x + (area.width - size.width) / 2, area.y + (area.height - size.height) / 2,
          size.width, size.height};
}

void Draw(const FigurePanel& panel, const cv::Point& corner, cv::Mat& figure) {
  assert(panel.picture.type() == CV_8UC3 && !panel.picture.empty());
  cv::putText(figure, panel.title, corner + cv::Point(4, kTitlePx - 11), cv::FONT_HERSHEY_SIMPLEX,
              0.7, kInk, 1, cv::LINE_AA);
  const cv::Rect place = Centred(panel.picture.size(), {corner + cv::Point(0, kTitlePx), kPanel});
  cv::resize(panel.picture, figure(place), place.size(), 0.0, 0.0, cv::INTER_AREA);
}

}  // namespace

cv::Mat ComposeFigure(const std::vector<FigurePanel>& panels, int columns) {
  const int count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  const cv::Size cell(kPanel.width + kGapPx, kPanel.height + kTitlePx + kGapPx);
  cv::Mat figure(rows * cell.height + kGapPx, columns * cell.width + kGapPx, CV_8UC3, kPaper);
  for (int i = 0; i < count; ++i) {
    Draw(panels[i], {kGapPx + (i % columns) * cell.width, kGapPx + (i / columns) * cell.height},
         figure);
  }
  return figure;
}

}  // namespace semantic_slam
