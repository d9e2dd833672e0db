#include "semantic_slam/ground_truth/map_comparison_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/evaluation/map_legend.h"
#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {
namespace {

// The layout, in pixels: three panels beside each other, the legend to the right of them.
constexpr int kPanels = 3;
constexpr double kPanelWidth = 620.0;
constexpr double kMaxPanelHeight = 900.0;
constexpr double kMinPanelHeight = 240.0;
constexpr int kMargin = 24;
constexpr int kTitle = 44;
constexpr int kFooter = 56;
constexpr int kLegendWidth = 190;
constexpr double kText = 13.0;
constexpr double kNameText = 8.0;

const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kTruePath(150, 150, 150);
const cv::Scalar kEstimatedPath(178, 114, 0);
const cv::Vec3b kUnknownGrey(222, 222, 222);
constexpr double kTint = 0.45;  // of an object's colour over the floor plan

cv::Scalar ColourOf(const MapObject& object, const LabelVocabulary& vocabulary) {
  const auto& rgb = vocabulary[object.labels.front().label].rgb;
  return cv::Scalar(rgb[2], rgb[1], rgb[0]);
}

cv::Vec3b Grey(std::int8_t percent) {
  if (percent < 0) return kUnknownGrey;
  const auto grey = cv::saturate_cast<std::uint8_t>(255.0 - 2.25 * percent);
  return {grey, grey, grey};
}

// One of the three views of the same area.
class Panel {
 public:
  Panel(const OccupancyMap& area, int column)
      : area_(area),
        extent_m_(area.resolution_m * Eigen::Vector2d(area.width, area.height)),
        pixels_per_metre_(std::min(kPanelWidth / extent_m_.x(), kMaxPanelHeight / extent_m_.y())),
        corner_(kMargin + column * (Size().width + kMargin), kTitle) {}

  cv::Size Size() const {
    return {cvCeil(extent_m_.x() * pixels_per_metre_), cvCeil(extent_m_.y() * pixels_per_metre_)};
  }
  double pixels_per_metre() const { return pixels_per_metre_; }
  cv::Rect Box() const { return {corner_, Size()}; }

  cv::Point2d ToPage(const Eigen::Vector2d& world_m) const {
    const Eigen::Vector2d from_corner = (world_m - area_.origin_m) * pixels_per_metre_;
    return {corner_.x + from_corner.x(), corner_.y + Size().height - from_corner.y()};
  }

  cv::Mat Draw(const OccupancyMap& map, const Rigid2d& T_world_map) const {
    const Rigid2d T_map_world = T_world_map.inverse();
    cv::Mat image(Size(), CV_8UC3);
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        const Eigen::Vector2d from_corner(u + 0.5, image.rows - v - 0.5);
        const Eigen::Vector2d world_m = area_.origin_m + from_corner / pixels_per_metre_;
        image.at<cv::Vec3b>(v, u) = Grey(PercentAt(map, T_map_world * world_m));
      }
    }
    return image;
  }

 private:
  const OccupancyMap& area_;
  const Eigen::Vector2d extent_m_;
  const double pixels_per_metre_;
  const cv::Point corner_;
};

// The page with one panel after the other.
class Figure {
 public:
  Figure(const MapEvaluation& evaluation, const RunOutputs& outputs,
         const LabelVocabulary& vocabulary)
      : evaluation_(evaluation),
        outputs_(outputs),
        vocabulary_(vocabulary),
        T_world_map_(Flattened(evaluation.T_world_map)),
        page_(PageSize(Panel(evaluation.flight_plan, 0).Size())),
        canvas_(page_) {
    if (!outputs.objects) return;
    for (const MapObject& object : outputs.objects->objects) {
      mapped_objects_.push_back(InWorld(object, evaluation.T_world_map));
    }
  }

  cv::Mat Draw() {
    DrawTruth();
    DrawEstimate();
    DrawSemanticGrid();
    DrawLegendAndScale();
    return canvas_.Image();
  }

 private:
  using Objects = std::vector<MapObject>;

  static cv::Size PageSize(cv::Size panel) {
    const int height = std::max(panel.height, cvCeil(kMinPanelHeight));
    return {kPanels * (panel.width + kMargin) + 2 * kMargin + kLegendWidth,
            kTitle + height + kFooter};
  }

  void DrawTruth() {
    const Panel panel = Begin(0, "truth");
    Paste(panel, &evaluation_.flight_plan, Rigid2d::Identity(), evaluation_.true_objects);
    DrawOutlines(panel, evaluation_.true_objects);
    DrawNames(panel, evaluation_.true_objects);
    Frame(panel);
  }

  void DrawEstimate() {
    const Panel panel = Begin(1, "floor plan and objects of the run");
    Paste(panel, outputs_.grid ? &*outputs_.grid : nullptr, T_world_map_, mapped_objects_);
    DrawOutlines(panel, mapped_objects_);
    DrawPath(
        panel, [](const MatchedPose& m) { return m.T_reference_sensor; }, kTruePath, 3.0);
    DrawPath(
        panel,
        [this](const MatchedPose& m) { return evaluation_.T_world_map * m.T_estimate_sensor; },
        kEstimatedPath, 1.5);
    DrawNames(panel, mapped_objects_);
    Frame(panel);
  }

  void DrawSemanticGrid() {
    const Panel panel = Begin(2, "cost of the semantic grid");
    Paste(panel, outputs_.semantic_grid ? &*outputs_.semantic_grid : nullptr, T_world_map_, {});
    for (std::size_t i = 0; i < evaluation_.true_objects.size(); ++i) {
      if (evaluation_.is_expected[i]) DrawDashed(panel, evaluation_.true_objects[i]);
    }
    DrawOutlines(panel, mapped_objects_);
    Frame(panel);
  }

  Panel Begin(int column, const std::string& title) {
    Panel panel(evaluation_.flight_plan, column);
    canvas_.Text(title, {1.0 * panel.Box().x, kTitle - 14.0}, HorizontalAlign::kLeft, kText, kInk);
    return panel;
  }

  // A map with the areas of objects tinted.
  void Paste(const Panel& panel, const OccupancyMap* map, const Rigid2d& T_world_map,
             const Objects& objects) {
    cv::Mat image = panel.Draw(map != nullptr ? *map : OccupancyMap(), T_world_map);
    cv::Mat tinted = image.clone();
    for (const MapObject* object : LargestFirst(objects)) {
      std::vector<cv::Point> outline;
      for (const Eigen::Vector2d& corner : object->footprint_m) {
        outline.push_back(cv::Point(panel.ToPage(corner)) - panel.Box().tl());
      }
      cv::fillConvexPoly(tinted, outline, ColourOf(*object, vocabulary_), cv::LINE_AA);
    }
    cv::addWeighted(tinted, kTint, image, 1.0 - kTint, 0.0, image);
    canvas_.Paste(image, panel.Box().tl());
  }

  void Frame(const Panel& panel) { canvas_.Rectangle(cv::Rect2d(panel.Box()), kInk, 1.0); }

  static std::vector<const MapObject*> LargestFirst(const Objects& objects) {
    std::vector<const MapObject*> sorted;
    for (const MapObject& object : objects) {
      if (!object.footprint_m.empty()) sorted.push_back(&object);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](const MapObject* a, const MapObject* b) {
      return Area(a->footprint_m) > Area(b->footprint_m);
    });
    return sorted;
  }

  std::vector<cv::Point2d> Outline(const Panel& panel, const MapObject& object) const {
    std::vector<cv::Point2d> outline;
    for (const Eigen::Vector2d& corner : object.footprint_m)
      outline.push_back(panel.ToPage(corner));
    if (!outline.empty()) outline.push_back(outline.front());
    return outline;
  }

  void DrawOutlines(const Panel& panel, const Objects& objects) {
    for (const MapObject* object : LargestFirst(objects)) {
      canvas_.Polyline(Outline(panel, *object), 0.6 * ColourOf(*object, vocabulary_), 1.2);
      shown_.insert(object->labels.front().label);
    }
  }

  void DrawDashed(const Panel& panel, const MapObject& object) {
    const std::vector<cv::Point2d> outline = Outline(panel, object);
    for (std::size_t i = 1; i < outline.size(); ++i) {
      canvas_.DashedLine(outline[i - 1], outline[i], kInk, 0.8);
    }
  }

  // Larger objects first; those without room go without.
  void DrawNames(const Panel& panel, const Objects& objects) {
    std::vector<cv::Rect2d> taken;
    for (const MapObject* object : LargestFirst(objects)) {
      const std::string& name = vocabulary_[object->labels.front().label].name;
      const cv::Point2d centre = panel.ToPage(object->T_map_box.translation().head<2>());
      const double width = PlotCanvas::TextWidth(name, kNameText);
      const cv::Rect2d box(centre.x - 0.5 * width, centre.y - kNameText, width, 2.0 * kNameText);
      const auto is_in_the_way = [&box](const cv::Rect2d& other) { return !(box & other).empty(); };
      if (std::any_of(taken.begin(), taken.end(), is_in_the_way)) continue;
      taken.push_back(box);
      canvas_.RimmedText(name, centre + cv::Point2d(0.0, 0.5 * kNameText), HorizontalAlign::kCentre,
                         kNameText, kInk);
    }
  }

  void DrawPath(const Panel& panel, const std::function<Rigid3d(const MatchedPose&)>& pose_of,
                const cv::Scalar& colour, double width) {
    std::vector<cv::Point2d> path;
    for (const MatchedPose& match : evaluation_.trajectory.matches) {
      path.push_back(panel.ToPage(pose_of(match).translation().head<2>()));
    }
    canvas_.Polyline(path, colour, width);
  }

  void DrawLegendAndScale() {
    std::vector<LegendEntry> entries{{"true path", kTruePath},
                                     {"estimated path", kEstimatedPath},
                                     {"not seen", cv::Scalar(kUnknownGrey)}};
    for (const LabelId label : shown_) {
      const auto& rgb = vocabulary_[label].rgb;
      entries.push_back({vocabulary_[label].name, cv::Scalar(rgb[2], rgb[1], rgb[0])});
    }
    const Panel last(evaluation_.flight_plan, kPanels - 1);
    const cv::Rect box = last.Box();
    DrawLegend(entries, {box.br().x + 1.0 * kMargin, 1.0 * kTitle}, page_.height - 1.0 * kTitle,
               canvas_);
    DrawScaleBar(last.pixels_per_metre(), 0.3 * box.width,
                 {1.0 * kMargin, box.br().y + 0.5 * kFooter}, canvas_);
  }

  const MapEvaluation& evaluation_;
  const RunOutputs& outputs_;
  const LabelVocabulary& vocabulary_;
  const Rigid2d T_world_map_;
  Objects mapped_objects_;  // in the world
  std::set<LabelId> shown_;
  const cv::Size page_;
  PlotCanvas canvas_;
};

}  // namespace

cv::Mat DrawMapComparison(const MapEvaluation& evaluation, const RunOutputs& outputs,
                          const LabelVocabulary& vocabulary) {
  return Figure(evaluation, outputs, vocabulary).Draw();
}

}  // namespace semantic_slam
