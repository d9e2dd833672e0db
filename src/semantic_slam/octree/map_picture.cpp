#include "semantic_slam/octree/map_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/evaluation/map_legend.h"
#include "semantic_slam/evaluation/plot_canvas.h"
#include "semantic_slam/octree/occupied_voxels.h"

namespace semantic_slam {
namespace {

// The layout, in pixels.
constexpr int kMapSide = 1000;  // about, of the longer side of the map
constexpr int kMargin = 24;
constexpr int kLegendWidth = 230;
constexpr int kFooter = 56;
constexpr double kText = 11.0;
constexpr int kMinHeight = 320;

constexpr double kDarkest = 0.45;      // of the lowest voxels
constexpr double kShadow = 0.72;       // beside something higher
constexpr double kShadowStepM = 0.12;  // how much higher

const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kPathColour(30, 30, 220);
const cv::Vec3b kNothing(246, 246, 246);

// The highest voxel of a column.
struct Top {
  double z_m = -std::numeric_limits<double>::infinity();
  std::array<std::uint8_t, 3> rgb{};
};

// The columns of a map, coarser than its voxels where it is very large.
class ColumnImage {
 public:
  ColumnImage(const SemanticOcTree& tree, const LabelVocabulary& vocabulary,
              const MapPictureOptions& options)
      : tree_(tree), options_(options) {
    for (const std::string& name : options.hidden_classes) {
      if (const auto label = vocabulary.Find(name)) hidden_.push_back(*label);
    }
    FindBounds();
    if (empty()) return;
    const int longer = std::max(high_[0] - low_[0], high_[1] - low_[1]) + 1;
    keys_per_cell_ = (longer + kMapSide - 1) / kMapSide;
    pixels_per_cell_ = std::max(1, std::min(16, kMapSide * keys_per_cell_ / longer));
    columns_.resize(static_cast<std::size_t>(Width()) * Height());
    FillColumns(vocabulary);
  }

  bool empty() const { return low_[0] > high_[0]; }
  double PixelsPerMetre() const {
    return pixels_per_cell_ / (keys_per_cell_ * tree_.getResolution());
  }
  const std::map<LabelId, std::size_t>& voxels_per_label() const { return voxels_per_label_; }

  cv::Mat Draw() const {
    cv::Mat cells(Height(), Width(), CV_8UC3, cv::Scalar(kNothing));
    const auto [lowest, highest] = HeightRange();
    for (int y = 0; y < Height(); ++y) {
      for (int x = 0; x < Width(); ++x) {
        const Top& top = At(x, y);
        if (!std::isfinite(top.z_m)) continue;
        double shade =
            1.0 - (1.0 - kDarkest) * std::clamp((highest - top.z_m) / (highest - lowest), 0.0, 1.0);
        if (LiesInShadow(x, y)) shade *= kShadow;
        for (int c = 0; c < 3; ++c) {
          cells.at<cv::Vec3b>(Height() - 1 - y, x)[c] =
              cv::saturate_cast<std::uint8_t>(shade * top.rgb[2 - c]);
        }
      }
    }
    cv::Mat image;
    cv::resize(cells, image, {}, pixels_per_cell_, pixels_per_cell_, cv::INTER_NEAREST);
    DrawPath(image);
    return image;
  }

 private:
  int Width() const { return (high_[0] - low_[0]) / keys_per_cell_ + 1; }
  int Height() const { return (high_[1] - low_[1]) / keys_per_cell_ + 1; }
  const Top& At(int x, int y) const { return columns_[static_cast<std::size_t>(y) * Width() + x]; }

  template <typename Visit>
  void ForEachShown(Visit&& visit) const {
    ForEachOccupiedVoxel(tree_, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
      if (tree_.keyToCoord(key[2]) > options_.max_z_m) return;
      if (std::find(hidden_.begin(), hidden_.end(), node.labels().label(0)) != hidden_.end())
        return;
      visit(key, node);
    });
  }

  void FindBounds() {
    ForEachShown([this](const octomap::OcTreeKey& key, const SemanticNode&) {
      for (int i = 0; i < 3; ++i) {
        low_[i] = std::min<int>(low_[i], key[i]);
        high_[i] = std::max<int>(high_[i], key[i]);
      }
    });
  }

  void FillColumns(const LabelVocabulary& vocabulary) {
    const VoxelColours colours(options_.colour_mode, vocabulary, ZOf(low_[2]), ZOf(high_[2] + 1));
    ForEachShown([&](const octomap::OcTreeKey& key, const SemanticNode& node) {
      ++voxels_per_label_[node.labels().label(0)];
      const int x = (key[0] - low_[0]) / keys_per_cell_, y = (key[1] - low_[1]) / keys_per_cell_;
      Top& top = columns_[static_cast<std::size_t>(y) * Width() + x];
      const double z_m = ZOf(key[2]);
      if (z_m > top.z_m) top = {z_m, colours(node, z_m)};
    });
  }

  double ZOf(int key) const { return tree_.keyToCoord(static_cast<octomap::key_type>(key)); }

  // From the lowest to the highest tenth, so that a few stray voxels do not take all the contrast.
  std::pair<double, double> HeightRange() const {
    std::vector<double> heights;
    for (const Top& top : columns_) {
      if (std::isfinite(top.z_m)) heights.push_back(top.z_m);
    }
    std::sort(heights.begin(), heights.end());
    const double low = heights[heights.size() / 10],
                 high = heights[heights.size() - 1 - heights.size() / 10];
    return {low, std::max(high, low + 0.1)};
  }

  // The light comes from the upper left.
  bool LiesInShadow(int x, int y) const {
    const double z = At(x, y).z_m + kShadowStepM;
    return (x > 0 && At(x - 1, y).z_m > z) || (y + 1 < Height() && At(x, y + 1).z_m > z);
  }

  void DrawPath(cv::Mat& image) const {
    std::vector<cv::Point> path;
    const double scale = PixelsPerMetre(), half = 0.5 * tree_.getResolution();
    const double left = tree_.keyToCoord(static_cast<octomap::key_type>(low_[0])) - half;
    const double bottom = tree_.keyToCoord(static_cast<octomap::key_type>(low_[1])) - half;
    for (const Eigen::Vector3d& p : options_.camera_path_m) {
      path.emplace_back(cvRound((p.x() - left) * scale),
                        cvRound(image.rows - (p.y() - bottom) * scale));
    }
    cv::polylines(image, path, false, cv::Scalar(255, 255, 255), 4, cv::LINE_AA);
    cv::polylines(image, path, false, kPathColour, 2, cv::LINE_AA);
  }

  const SemanticOcTree& tree_;
  const MapPictureOptions& options_;
  std::vector<LabelId> hidden_;
  std::array<int, 3> low_{65536, 65536, 65536};  // keys
  std::array<int, 3> high_{-1, -1, -1};
  int keys_per_cell_ = 1;
  int pixels_per_cell_ = 1;
  std::vector<Top> columns_;  // row-major, y from below
  std::map<LabelId, std::size_t> voxels_per_label_;
};

// The classes in the map, those of most voxels first.
std::vector<LegendEntry> Legend(const std::map<LabelId, std::size_t>& voxels_per_label,
                                const LabelVocabulary& vocabulary) {
  std::vector<std::pair<LabelId, std::size_t>> rows(voxels_per_label.begin(),
                                                    voxels_per_label.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::vector<LegendEntry> entries;
  for (const auto& [label, count] : rows) {
    const LabelClass& shown = vocabulary[vocabulary.Contains(label) ? label : kUnknownLabel];
    entries.push_back({shown.name, cv::Scalar(shown.rgb[2], shown.rgb[1], shown.rgb[0])});
  }
  return entries;
}

}  // namespace

cv::Mat DrawMapFromAbove(const SemanticOcTree& tree, const LabelVocabulary& vocabulary,
                         const MapPictureOptions& options) {
  const ColumnImage columns(tree, vocabulary, options);
  if (columns.empty()) {
    PlotCanvas canvas({kMapSide / 2, kMinHeight});
    canvas.Text("the map is empty", {kMapSide / 4.0, kMinHeight / 2.0}, HorizontalAlign::kCentre,
                kText, kInk);
    return canvas.Image();
  }
  const cv::Mat map = columns.Draw();
  const bool has_legend = options.colour_mode == ColourMode::kClass;
  const cv::Size size(map.cols + 2 * kMargin + (has_legend ? kMargin + kLegendWidth : 0),
                      std::max(map.rows, kMinHeight) + kMargin + kFooter);
  PlotCanvas canvas(size);
  if (has_legend) {
    DrawLegend(Legend(columns.voxels_per_label(), vocabulary), {map.cols + 2.0 * kMargin, kMargin},
               size.height - 2.0 * kMargin, canvas);
  }
  DrawScaleBar(columns.PixelsPerMetre(), std::max(60.0, 0.3 * map.cols),
               {1.0 * kMargin, size.height - 0.5 * kFooter}, canvas);
  cv::Mat picture = canvas.Image();
  map.copyTo(picture(cv::Rect(kMargin, kMargin, map.cols, map.rows)));
  return picture;
}

void WriteMapFromAbove(const std::string& path, const SemanticOcTree& tree,
                       const LabelVocabulary& vocabulary, const MapPictureOptions& options) {
  const cv::Mat picture = DrawMapFromAbove(tree, vocabulary, options);
  WriteFileAtomicallyVia(
      path, [&](const std::string& temporary) { return cv::imwrite(temporary, picture); });
}

}  // namespace semantic_slam
