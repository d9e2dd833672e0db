#include "semantic_slam/segmentation/segmentation_overlay.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/label_drawing.h"

namespace semantic_slam {
namespace {

constexpr double kTint = 0.6;              // share of the label's colour
constexpr double kMinLegendShare = 0.005;  // of the image

using Pixel = cv::Vec3b;

// Per label id: its colour times kTint.
std::array<Pixel, 256> Tints(const LabelVocabulary& vocabulary, ColourOrder order) {
  std::array<Pixel, 256> tints{};
  for (const LabelClass& label : vocabulary.classes()) {
    const cv::Scalar colour = ColourOf(label, order) * kTint;
    for (int i = 0; i < 3; ++i) tints[label.id][i] = cv::saturate_cast<std::uint8_t>(colour[i]);
  }
  return tints;
}

// Per grey level: what of it remains.
std::array<std::uint8_t, 256> Remainders() {
  std::array<std::uint8_t, 256> remainders{};
  for (int grey = 0; grey < 256; ++grey) {
    remainders[grey] = cv::saturate_cast<std::uint8_t>(grey * (1.0 - kTint));
  }
  return remainders;
}

// The labels worth naming, the one with most pixels first.
std::vector<LabelId> LegendLabels(const std::array<int, 256>& pixels, double total) {
  std::vector<LabelId> labels;
  for (int id = 0; id < 256; ++id) {
    if (pixels[id] >= kMinLegendShare * total) labels.push_back(static_cast<LabelId>(id));
  }
  std::stable_sort(labels.begin(), labels.end(),
                   [&](LabelId a, LabelId b) { return pixels[a] > pixels[b]; });
  return labels;
}

// Row upon row from the lower left corner.
void DrawLegend(cv::Mat& picture, ColourOrder order, const std::vector<LabelId>& labels,
                const LabelVocabulary& vocabulary) {
  cv::Point corner(0, picture.rows - kTagHeightPx);
  for (const LabelId id : labels) {
    const LabelClass& label = vocabulary[id];
    const int width = TagWidthPx(label.name);
    if (corner.x > 0 && corner.x + width > picture.cols) {
      corner = {0, corner.y - kTagHeightPx};
    }
    if (corner.y < picture.rows / 2) return;
    DrawTag(picture, corner, label.name, ColourOf(label, order));
    corner.x += width;
  }
}

}  // namespace

cv::Mat DrawSegmentation(const cv::Mat& colour, ColourOrder order, const Segmentation& segmentation,
                         const LabelVocabulary& vocabulary) {
  CheckSegmentation(segmentation, vocabulary);
  if (colour.type() != CV_8UC3 || colour.size() != segmentation.size()) {
    throw InputError("segmentation overlay: the image is not CV_8UC3 of the segmentation's size");
  }
  const std::array<Pixel, 256> tints = Tints(vocabulary, order);
  const std::array<std::uint8_t, 256> remainders = Remainders();
  std::array<int, 256> pixels{};
  cv::Mat picture(colour.size(), CV_8UC3);
  for (int v = 0; v < colour.rows; ++v) {
    const LabelId* labels = segmentation.labels[0].ptr<LabelId>(v);
    const Pixel* from = colour.ptr<Pixel>(v);
    Pixel* to = picture.ptr<Pixel>(v);
    for (int u = 0; u < colour.cols; ++u) {
      const Pixel& tint = tints[labels[u]];
      // No sum exceeds 255: the shares of tint and image add up to one.
      for (int i = 0; i < 3; ++i)
        to[u][i] = static_cast<std::uint8_t>(tint[i] + remainders[from[u][i]]);
      ++pixels[labels[u]];
    }
  }
  DrawLegend(picture, order, LegendLabels(pixels, static_cast<double>(colour.total())), vocabulary);
  return picture;
}

}  // namespace semantic_slam
