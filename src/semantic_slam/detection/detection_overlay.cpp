#include "semantic_slam/detection/detection_overlay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_drawing.h"

namespace semantic_slam {
namespace {

constexpr int kLineWidthPx = 2;

std::string TagText(const LabelClass& label, float confidence) {
  return label.name + " " + std::to_string(std::lround(100.0f * confidence)) + " %";
}

// On top of the box, or inside it where there is no room above.
cv::Point TagCorner(const cv::Rect& box, int tag_width, cv::Size picture) {
  const int x = std::clamp(box.x, 0, std::max(0, picture.width - tag_width));
  const int above = box.y - kTagHeightPx;
  return {x, above >= 0 ? above : std::max(0, box.y)};
}

void DrawBox(cv::Mat& picture, ColourOrder order, const DetectedBox& found,
             const LabelClass& label) {
  const cv::Scalar colour = ColourOf(label, order);
  const cv::Rect2f whole_picture(-0.5f, -0.5f, static_cast<float>(picture.cols),
                                 static_cast<float>(picture.rows));
  const cv::Rect2f visible = found.box & whole_picture;
  if (visible.empty()) return;
  const cv::Rect box(cvRound(visible.x), cvRound(visible.y), cvRound(visible.width),
                     cvRound(visible.height));
  cv::rectangle(picture, box, colour, kLineWidthPx);
  const std::string text = TagText(label, found.confidence);
  DrawTag(picture, TagCorner(box, TagWidthPx(text), picture.size()), text, colour);
}

}  // namespace

cv::Mat DrawDetections(const cv::Mat& colour, ColourOrder order, const Detections& detections,
                       const LabelVocabulary& vocabulary) {
  CheckDetections(detections, vocabulary);
  if (colour.empty() || colour.type() != CV_8UC3) {
    throw InputError("detection overlay: the image is not CV_8UC3 with pixels");
  }
  cv::Mat picture = colour.clone();
  for (auto found = detections.boxes.rbegin(); found != detections.boxes.rend(); ++found) {
    DrawBox(picture, order, *found, vocabulary[found->label]);
  }
  return picture;
}

}  // namespace semantic_slam
