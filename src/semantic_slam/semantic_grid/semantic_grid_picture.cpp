#include "semantic_slam/semantic_grid/semantic_grid_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/evaluation/map_legend.h"
#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {
namespace {

// The layout, in pixels.
constexpr int kMapSide = 1000;  // about, of the longer side of the map
constexpr int kMaxCellSide = 12;
constexpr int kMargin = 24;
constexpr int kLegendWidth = 200;
constexpr int kFooter = 56;
constexpr int kMinHeight = 320;
constexpr double kText = 11.0;
constexpr double kNameText = 10.0;

constexpr int kBorderCells = 3;        // kept around what is known
constexpr double kColourShare = 0.75;  // of a sure class; the rest lets the floor plan through

const cv::Scalar kInk(40, 40, 40);
const cv::Vec3b kUnknownGrey(205, 205, 205);
constexpr double kWhite = 255.0;
constexpr double kBlack = 30.0;

cv::Scalar Bgr(const LabelClass& label) {
  return {static_cast<double>(label.rgb[2]), static_cast<double>(label.rgb[1]),
          static_cast<double>(label.rgb[0])};
}

cv::Vec3b Grey(std::int8_t percent) {
  if (percent == OccupancyMap::kUnknown) return kUnknownGrey;
  const auto grey = cv::saturate_cast<std::uint8_t>(kWhite + (kBlack - kWhite) * 0.01 * percent);
  return {grey, grey, grey};
}

// The floor plan in the cells of the grid, row 0 having the least y.
cv::Mat DrawFloorPlan(const SemanticCells& cells, const OccupancyMap& map) {
  cv::Mat image(cells.height, cells.width, CV_8UC3, cv::Scalar(kUnknownGrey));
  const Eigen::Vector2d shift = (map.origin_m - cells.origin_m) / cells.resolution_m;
  const cv::Point corner(cvRound(shift.x()), cvRound(shift.y()));
  for (int y = 0; y < map.height; ++y) {
    const auto* row = map.cells.data() + static_cast<std::size_t>(y) * map.width;
    for (int x = 0; x < map.width; ++x) {
      image.at<cv::Vec3b>(corner.y + y, corner.x + x) = Grey(row[x]);
    }
  }
  return image;
}

// Mixes the colours of the cell's classes, each with its probability, into the floor plan's.
cv::Vec3b Tinted(const cv::Vec3b& plan, const LabelId* labels, const std::uint8_t* probabilities,
                 int classes, const LabelVocabulary& vocabulary) {
  cv::Scalar colour;
  double sum = 0.0, greatest = 0.0;
  for (int i = 0; i < classes; ++i) {
    const double probability = probabilities[i] / 255.0;
    colour += probability * Bgr(vocabulary[labels[i]]);
    sum += probability;
    greatest = std::max(greatest, probability);
  }
  if (sum == 0.0) return plan;
  const double share = kColourShare * greatest;
  cv::Vec3b tinted;
  for (int c = 0; c < 3; ++c) {
    tinted[c] = cv::saturate_cast<std::uint8_t>((1.0 - share) * plan[c] + share * colour[c] / sum);
  }
  return tinted;
}

void DrawClasses(const SemanticCells& cells, const LabelVocabulary& vocabulary, cv::Mat& image) {
  std::size_t first = 0;
  for (int y = 0; y < image.rows; ++y) {
    auto* row = image.ptr<cv::Vec3b>(y);
    for (int x = 0; x < image.cols; ++x, first += cells.classes_per_cell) {
      row[x] = Tinted(row[x], &cells.labels[first], &cells.probabilities[first],
                      cells.classes_per_cell, vocabulary);
    }
  }
}

bool IsKnown(const SemanticCells& cells, int x, int y) {
  const std::size_t cell = static_cast<std::size_t>(y) * cells.width + x;
  return cells.cost[cell] != SemanticCells::kUnknown ||
         cells.probabilities[cell * cells.classes_per_cell] > 0;
}

// The cells to show: all that are known and a few around.
cv::Rect KnownArea(const SemanticCells& cells) {
  cv::Rect known;
  for (int y = 0; y < cells.height; ++y) {
    int left = 0, right = cells.width;
    while (left < right && !IsKnown(cells, left, y)) ++left;
    while (right > left && !IsKnown(cells, right - 1, y)) --right;
    if (left < right) known |= cv::Rect(left, y, right - left, 1);
  }
  if (known.empty()) return known;
  known -= cv::Point(kBorderCells, kBorderCells);
  known += cv::Size(2 * kBorderCells, 2 * kBorderCells);
  return known & cv::Rect(0, 0, cells.width, cells.height);
}

// How cells become pixels.
class Projection {
 public:
  Projection(const SemanticCells& cells, const cv::Rect& area) : area_(area) {
    const int longer = std::max(area.width, area.height);
    scale_ = longer > kMapSide ? static_cast<double>(kMapSide) / longer
                               : std::min(kMapSide / longer, kMaxCellSide);
    pixels_per_metre_ = scale_ / cells.resolution_m;
    top_left_m_ = cells.origin_m + cells.resolution_m * Eigen::Vector2d(area.x, area.br().y);
  }

  double pixels_per_metre() const { return pixels_per_metre_; }
  cv::Size size() const {
    return {std::max(1, cvRound(area_.width * scale_)),
            std::max(1, cvRound(area_.height * scale_))};
  }

  cv::Mat Scaled(const cv::Mat& image) const {
    cv::Mat shown, scaled;
    cv::flip(image(area_), shown, 0);
    cv::resize(shown, scaled, size(), 0.0, 0.0, scale_ < 1.0 ? cv::INTER_AREA : cv::INTER_NEAREST);
    return scaled;
  }

  // On the page.
  cv::Point2d ToPixel(const Eigen::Vector2d& point_m) const {
    return {kMargin + (point_m.x() - top_left_m_.x()) * pixels_per_metre_,
            kMargin + (top_left_m_.y() - point_m.y()) * pixels_per_metre_};
  }

 private:
  const cv::Rect area_;
  double scale_;  // pixels per cell
  double pixels_per_metre_;
  Eigen::Vector2d top_left_m_;
};

// The objects that have an outline, the largest first.
std::vector<const MapObject*> ByArea(const ObjectMap& objects) {
  std::vector<const MapObject*> sorted;
  for (const MapObject& object : objects.objects) {
    if (!object.footprint_m.empty() && !object.labels.empty()) sorted.push_back(&object);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const MapObject* a, const MapObject* b) {
    return Area(a->footprint_m) > Area(b->footprint_m);
  });
  return sorted;
}

void DrawOutlines(const std::vector<const MapObject*>& objects, const LabelVocabulary& vocabulary,
                  const Projection& projection, PlotCanvas& canvas) {
  for (const MapObject* object : objects) {
    std::vector<cv::Point2d> outline;
    for (const Eigen::Vector2d& corner : object->footprint_m) {
      outline.push_back(projection.ToPixel(corner));
    }
    outline.push_back(outline.front());
    canvas.Polyline(outline, 0.6 * Bgr(vocabulary[object->labels[0].label]), 1.5);
  }
}

Eigen::Vector2d MeanCorner(const MapObject& object) {
  const Eigen::Vector2d sum = std::accumulate(object.footprint_m.begin(), object.footprint_m.end(),
                                              Eigen::Vector2d(Eigen::Vector2d::Zero()));
  return sum / static_cast<double>(object.footprint_m.size());
}

// Names in the middle of their objects, or a line or two above or below where others are in the
// way; smaller objects give way to larger ones, and go without a name where there is no room.
void DrawNames(const std::vector<const MapObject*>& objects, const LabelVocabulary& vocabulary,
               const Projection& projection, PlotCanvas& canvas) {
  constexpr double kLine = 1.5 * kNameText;
  std::vector<cv::Rect2d> taken;
  for (const MapObject* object : objects) {
    const LabelProbability& label = object->labels[0];
    const std::string text = vocabulary[label.label].name + " " +
                             std::to_string(cvRound(100.0 * label.probability)) + "%";
    const double width = PlotCanvas::TextWidth(text, kNameText);
    const cv::Point2d centre = projection.ToPixel(MeanCorner(*object));
    for (const int line : {0, -1, 1, -2, 2}) {
      const cv::Point2d anchor(centre.x, centre.y + line * kLine + 0.5 * kNameText);
      const cv::Rect2d box(anchor.x - 0.5 * width, anchor.y - kNameText, width, kLine);
      const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const cv::Rect2d& other) {
        return !(box & other).empty();
      });
      if (!is_free) continue;
      taken.push_back(box);
      canvas.RimmedText(text, anchor, HorizontalAlign::kCentre, kNameText, kInk);
      break;
    }
  }
}

// The classes that are the most probable ones of a cell or an object, those of most cells first,
// after the greys.
std::vector<LegendEntry> Legend(const SemanticCells& cells,
                                const std::vector<const MapObject*>& objects,
                                const LabelVocabulary& vocabulary) {
  std::array<int, 256> counts{};
  for (std::size_t i = 0; i < cells.labels.size(); i += cells.classes_per_cell) {
    if (cells.probabilities[i] > 0) ++counts[cells.labels[i]];
  }
  for (const MapObject* object : objects) ++counts[object->labels[0].label];
  std::vector<const LabelClass*> shown;
  for (const LabelClass& label : vocabulary.classes()) {
    if (counts[label.id] > 0) shown.push_back(&label);
  }
  std::stable_sort(shown.begin(), shown.end(), [&](const LabelClass* a, const LabelClass* b) {
    return counts[a->id] > counts[b->id];
  });
  std::vector<LegendEntry> entries{{"occupied", cv::Scalar::all(kBlack)},
                                   {"not seen", cv::Scalar(kUnknownGrey)}};
  for (const LabelClass* label : shown) entries.push_back({label->name, Bgr(*label)});
  return entries;
}

cv::Mat EmptyPicture() {
  PlotCanvas canvas({kMapSide / 2, kMinHeight});
  canvas.Text("the grid is empty", {kMapSide / 4.0, kMinHeight / 2.0}, HorizontalAlign::kCentre,
              kText, kInk);
  return canvas.Image();
}

}  // namespace

cv::Mat DrawSemanticGrid(const SemanticCells& cells, const OccupancyMap& map,
                         const ObjectMap& objects, const LabelVocabulary& vocabulary) {
  const cv::Rect area = KnownArea(cells);
  if (area.empty()) return EmptyPicture();
  cv::Mat image = DrawFloorPlan(cells, map);
  DrawClasses(cells, vocabulary, image);
  const Projection projection(cells, area);
  const cv::Size map_size = projection.size();
  const cv::Size size(map_size.width + 3 * kMargin + kLegendWidth,
                      std::max(map_size.height, kMinHeight) + kMargin + kFooter);
  PlotCanvas canvas(size);
  canvas.Paste(projection.Scaled(image), {kMargin, kMargin});
  canvas.Rectangle({cv::Point2d(kMargin, kMargin), cv::Size2d(map_size)}, kInk, 1.0);
  const std::vector<const MapObject*> by_area = ByArea(objects);
  DrawOutlines(by_area, vocabulary, projection, canvas);
  DrawNames(by_area, vocabulary, projection, canvas);
  DrawLegend(Legend(cells, by_area, vocabulary), {map_size.width + 2.0 * kMargin, 1.0 * kMargin},
             size.height - 2.0 * kMargin, canvas);
  DrawScaleBar(projection.pixels_per_metre(), std::max(60.0, 0.3 * map_size.width),
               {1.0 * kMargin, size.height - 0.5 * kFooter}, canvas);
  return canvas.Image();
}

}  // namespace semantic_slam
