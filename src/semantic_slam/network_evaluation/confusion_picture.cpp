#include "semantic_slam/network_evaluation/confusion_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {
namespace {

// The layout, in pixels; texts by the height of a capital letter.
constexpr int kRoom = 1600;  // for the cells, as far as they may be that small
constexpr int kLeastCell = 12;
constexpr int kMostCell = 44;
constexpr int kLeastNumberedCell = 26;
constexpr int kMargin = 24;
constexpr int kTitle = 40;
constexpr int kGap = 8;
constexpr int kCountWidth = 90;
constexpr int kAxisTitle = 30;
constexpr double kTitleText = 14.0;
constexpr double kNameText = 10.0;

const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kPaper(255, 255, 255);
const cv::Scalar kGrid(225, 225, 225);
const cv::Scalar kRight(110, 140, 40);  // a teal, for the diagonal
const cv::Scalar kWrong(60, 80, 200);   // a red

cv::Scalar CellColour(double share, bool is_right) {
  const cv::Scalar full = is_right ? kRight : kWrong;
  return kPaper + (full - kPaper) * std::sqrt(share);  // small shares are to be seen too
}

class ConfusionFigure {
 public:
  ConfusionFigure(const ConfusionMatrix& matrix, const std::vector<std::string>& names,
                  const std::string& none_name)
      : matrix_(matrix), names_(names) {
    names_.push_back(none_name);
    for (int i = 0; i <= matrix.none(); ++i) {
      const bool is_class = i != matrix.none();
      const bool is_true = matrix.TruthCount(i) > 0, is_predicted = matrix.PredictedCount(i) > 0;
      if (is_true || (is_class && is_predicted)) rows_.push_back(i);
      if (is_predicted || (is_class && is_true)) columns_.push_back(i);
    }
    const int most = static_cast<int>(std::max<std::size_t>({rows_.size(), columns_.size(), 1}));
    cell_ = std::clamp(kRoom / most, kLeastCell, kMostCell);
    for (const std::string& name : names_) {
      names_px_ = std::max(names_px_, cvCeil(PlotCanvas::TextWidth(name, NameText())));
    }
    corner_ = {kMargin + kAxisTitle + names_px_ + kGap, kMargin + kTitle + names_px_ + kGap};
  }

  cv::Mat Draw(const std::string& title) const {
    const cv::Size cells(Size(columns_), Size(rows_));
    const int title_px = cvCeil(PlotCanvas::TextWidth(title, kTitleText));
    PlotCanvas canvas({std::max(corner_.x + cells.width + kCountWidth, title_px) + 2 * kMargin,
                       corner_.y + cells.height + kAxisTitle + kMargin});
    canvas.Text(title, {kMargin, kMargin + kTitleText}, HorizontalAlign::kLeft, kTitleText, kInk);
    if (!rows_.empty()) DrawMatrix(cells, canvas);
    return canvas.Image();
  }

 private:
  int Size(const std::vector<int>& classes) const {
    return static_cast<int>(classes.size()) * cell_;
  }
  double NameText() const { return std::min(kNameText, 0.6 * cell_); }

  double Share(int row, int column) const {
    const std::int64_t all = matrix_.TruthCount(row);
    return all == 0 ? 0.0 : static_cast<double>(matrix_.count(row, column)) / all;
  }

  void DrawMatrix(cv::Size cells, PlotCanvas& canvas) const {
    DrawCells(cells, canvas);
    for (std::size_t i = 0; i < rows_.size(); ++i) DrawRow(i, cells, canvas);
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const std::string& name = names_[columns_[j]];
      const double x = corner_.x + (static_cast<double>(j) + 0.5) * cell_;
      const double middle = 0.5 * PlotCanvas::TextWidth(name, NameText());
      canvas.VerticalText(name, {x, corner_.y - kGap - middle}, NameText(), kInk);
    }
    canvas.Text("predicted, % of the row",
                {corner_.x + 0.5 * cells.width, corner_.y + cells.height + 1.0 * kAxisTitle},
                HorizontalAlign::kCentre, kNameText, kInk);
    canvas.VerticalText("true", {kMargin + 0.3 * kAxisTitle, corner_.y + 0.5 * cells.height},
                        kNameText, kInk);
  }

  void DrawCells(cv::Size cells, PlotCanvas& canvas) const {
    cv::Mat picture(cells, CV_8UC3, kPaper);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      for (std::size_t j = 0; j < columns_.size(); ++j) {
        const cv::Rect cell(static_cast<int>(j) * cell_, static_cast<int>(i) * cell_, cell_, cell_);
        const bool is_right = rows_[i] == columns_[j];
        cv::rectangle(picture, cell, CellColour(Share(rows_[i], columns_[j]), is_right),
                      cv::FILLED);
        cv::rectangle(picture, cell, kGrid);
      }
    }
    canvas.Paste(picture, corner_);
  }

  void DrawRow(std::size_t i, cv::Size cells, PlotCanvas& canvas) const {
    const double base = corner_.y + (static_cast<double>(i) + 0.5) * cell_ + 0.5 * NameText();
    const int row = rows_[i];
    canvas.Text(names_[row], {static_cast<double>(corner_.x - kGap), base}, HorizontalAlign::kRight,
                NameText(), kInk);
    canvas.Text(std::to_string(matrix_.TruthCount(row)),
                {static_cast<double>(corner_.x + cells.width + kGap), base}, HorizontalAlign::kLeft,
                NameText(), kInk);
    if (cell_ < kLeastNumberedCell) return;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const double share = Share(row, columns_[j]);
      if (matrix_.count(row, columns_[j]) == 0) continue;
      const std::string percent = share < 0.005 ? "<1" : std::to_string(std::lround(100.0 * share));
      canvas.Text(percent, {corner_.x + (static_cast<double>(j) + 0.5) * cell_, base},
                  HorizontalAlign::kCentre, NameText(), share > 0.4 ? kPaper : kInk);
    }
  }

  const ConfusionMatrix& matrix_;
  std::vector<std::string> names_;  // by class; the last is that of none()
  std::vector<int> rows_;
  std::vector<int> columns_;
  int cell_ = kMostCell;
  int names_px_ = 0;  // width of the longest
  cv::Point corner_;  // of the cells
};

}  // namespace

cv::Mat DrawConfusion(const ConfusionMatrix& matrix, const std::vector<std::string>& names,
                      const std::string& none_name, const std::string& title) {
  assert(static_cast<int>(names.size()) == matrix.classes());
  return ConfusionFigure(matrix, names, none_name).Draw(title);
}

}  // namespace semantic_slam
