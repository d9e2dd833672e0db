#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "semantic_slam/worlds/pattern.h"
#include "semantic_slam/worlds/scenery.h"

namespace semantic_slam {
namespace {

// A quarter of the books have the main colour.
Bgr BookCloth(Painter& painter, const Bgr& colour) {
  if (painter.Chance(0.25)) return painter.Near(colour, 30);
  return Hsv(painter.Uniform(0, 1), painter.Uniform(0.1, 0.85), painter.Uniform(0.2, 0.9));
}

void PaintSpine(Painter& spine, const Bgr& cloth) {
  const double w_m = spine.width_m(), h_m = spine.height_m();
  spine.Fill(cloth);
  const Bgr ink = spine.Chance(0.4) ? Bgr(110, 190, 225) : InkOn(cloth);
  if (spine.Chance(0.6)) {  // bands
    const Bgr band = spine.Chance(0.5) ? ink : Hsv(spine.Uniform(0, 1), 0.7, 0.6);
    const double tall_m = spine.Uniform(0.003, 0.02);
    spine.Rectangle(0, 0.06 * h_m, w_m, tall_m, band);
    spine.Rectangle(0, 0.9 * h_m - tall_m, w_m, tall_m, band);
  }
  Bgr behind = cloth;
  if (spine.Chance(0.35)) {  // a label
    behind = Mix(cloth, Bgr(215, 230, 235), 0.85);
    spine.Rectangle(0.08 * w_m, 0.18 * h_m, 0.84 * w_m, 0.54 * h_m, behind);
  }
  const std::string title = Words(spine, spine.Integer(1, 3));
  const double letter_m = LetterToFit(spine, title, 0.48 * h_m, std::min(0.5 * w_m, 0.014));
  spine.Text((w_m - letter_m) / 2, 0.21 * h_m, letter_m, title, InkOn(behind), true);
  spine.Disc({w_m / 2, 0.8 * h_m}, 0.22 * w_m, ink);
  // Backs are round.
  for (const double x_m : {0.0, w_m - 0.0015}) spine.Rectangle(x_m, 0, 0.0015, h_m, cloth * 0.45);
}

// One row standing on the lower edge.
void PaintBookRow(Painter& row, const Bgr& colour) {
  const double h_m = row.height_m();
  row.Fill(colour * 0.22);
  double usual = row.Uniform(0.88, 1.0);
  for (double x_m = 0.0; x_m < row.width_m();) {
    if (row.Chance(0.15)) usual = row.Uniform(0.88, 1.0);  // the next series
    const double thick_m = row.Uniform(0.014, 0.048);
    const double tall_m = h_m * std::min(1.0, usual + row.Uniform(-0.04, 0.04));
    Painter spine = row.Part(x_m, h_m - tall_m, thick_m, tall_m);
    PaintSpine(spine, BookCloth(row, colour));
    x_m += thick_m + (row.Chance(0.06) ? row.Uniform(0.01, 0.04) : 0.0008);
  }
}

// One above the other.
void PaintLyingBooks(Painter& painter, const Bgr& colour) {
  const int books = std::max(1, cvRound(painter.height_m() / 0.028));
  const double thick_m = painter.height_m() / books;
  painter.Fill(colour * 0.22);
  for (int i = 0; i < books; ++i) {
    const double w_m = painter.width_m() * (i + 1 == books ? 1.0 : painter.Uniform(0.85, 1.0));
    Painter spine = painter.Part(0, i * thick_m, w_m, thick_m);
    const Bgr cloth = BookCloth(painter, colour), ink = InkOn(cloth);
    spine.Fill(cloth);
    for (const double at : {0.05, 0.93}) spine.Rectangle(at * w_m, 0, 0.02 * w_m, thick_m, ink);
    const std::string title = Words(spine, 2);
    const double letter_m = LetterToFit(spine, title, 0.7 * w_m, 0.5 * thick_m);
    spine.Text(0.12 * w_m, 0.5 * (thick_m + letter_m), letter_m, title, ink);
    spine.Rectangle(0, thick_m - 0.002, w_m, 0.002, cloth * 0.4);
  }
}

// A row of books, or several with shelves of the main colour between them; lying ones where there
// is no room to stand.
void PaintBooks(Painter& painter, const Bgr& colour) {
  if (painter.height_m() < 0.13) return PaintLyingBooks(painter, colour);
  const int rows = std::max(1, cvRound(painter.height_m() / 0.33));
  const double step_m = painter.height_m() / rows, shelf_m = rows > 1 ? 0.022 : 0.0;
  painter.Fill(colour);
  for (int i = 0; i < rows; ++i) {
    Painter row = painter.Part(0, i * step_m, painter.width_m(), step_m - shelf_m);
    PaintBookRow(row, colour);
  }
  painter.AddNoise(0.003, 3);
}

// A cover: a photograph with a masthead and headlines over it.
void PaintMagazine(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double edge_m = 0.05 * w_m;
  if (painter.Chance(0.6)) {
    PaintPortrait(painter, colour);
  } else {
    PaintScene(painter, colour);
  }
  const Bgr ink = Luma(colour) > 150 ? Bgr(40, 30, 180) : Bgr(235, 245, 250);
  const std::string masthead = Words(painter, 1);
  const double letter_m = LetterToFit(painter, masthead, w_m - 2 * edge_m, 0.14 * h_m);
  painter.Text(edge_m, edge_m + letter_m, letter_m, masthead, ink);
  for (int i = 0; i < 4; ++i) {
    const double y_m = (0.5 + 0.11 * i) * h_m;
    const double x_m = i % 2 == 0 ? edge_m : 0.55 * w_m;
    const std::string headline = Words(painter, 1);
    painter.Text(x_m, y_m, LetterToFit(painter, headline, 0.35 * w_m, 0.035 * h_m), headline,
                 i % 2 == 0 ? Bgr(60, 230, 250) : Bgr::all(250));
    painter.Print(x_m, y_m + 0.01 * h_m, 0.36 * w_m, 0.05 * h_m, 0.02 * h_m, Bgr::all(240));
  }
  painter.Rectangle(w_m - 0.25 * w_m, h_m - 0.1 * h_m, 0.2 * w_m, 0.07 * h_m, Bgr::all(250));
  for (double at = 0.77; at < 0.93; at += 0.02) {
    painter.Rectangle(at * w_m, 0.91 * h_m, painter.Uniform(0.003, 0.012) * w_m, 0.05 * h_m,
                      Bgr::all(20));
  }
}

// A front page on paper of the main colour.
void PaintNewspaper(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const Bgr ink = Mix(InkOn(colour), colour, 0.12);
  const double edge_m = 0.05 * w_m, inner_m = w_m - 2 * edge_m;
  painter.Fill(colour);
  painter.AddNoise(0.05, 3);
  const std::string masthead = "THE " + Words(painter, 1) + " POST";
  const double letter_m = LetterToFit(painter, masthead, inner_m, 0.08 * h_m);
  painter.Text(edge_m, edge_m + letter_m, letter_m, masthead, ink);
  painter.Rectangle(edge_m, 0.14 * h_m, inner_m, 0.004 * h_m, ink);
  const std::string headline = Words(painter, 3);
  const double headline_m = LetterToFit(painter, headline, inner_m, 0.05 * h_m);
  painter.Text(edge_m, 0.16 * h_m + headline_m, headline_m, headline, ink);
  constexpr int kColumns = 4;
  const double step_m = inner_m / kColumns,
               print_m = std::max(0.011 * h_m, 2.5 * painter.texel_m());
  for (int i = 0; i < kColumns; ++i) {
    const bool under_photo = i == 1 || i == 2;
    const double top_m = (under_photo ? 0.56 : 0.24) * h_m;
    painter.Print(edge_m + i * step_m, top_m, 0.92 * step_m, 0.95 * h_m - top_m, print_m,
                  Mix(ink, colour, 0.35));
    const std::string heading = Words(painter, 1);
    const double y_m = painter.Uniform(0.62, 0.82) * h_m;
    painter.Rectangle(edge_m + i * step_m, y_m - 0.03 * h_m, 0.94 * step_m, 0.045 * h_m, colour);
    painter.Text(edge_m + i * step_m, y_m, LetterToFit(painter, heading, 0.9 * step_m, 0.02 * h_m),
                 heading, ink);
  }
  Painter photo = painter.Part(edge_m + 1.02 * step_m, 0.24 * h_m, 1.9 * step_m, 0.3 * h_m);
  PaintScene(photo, Mix(colour, Bgr::all(128), 0.3));
  photo.RemoveColour();
  painter.Rectangle(0, 0.5 * h_m, w_m, 0.002, colour * 0.8);  // the fold
}

// A word in a running hand.
void PaintScrawl(Painter& painter, cv::Point2d at_m, double letter_m, int letters, const Bgr& ink) {
  std::vector<cv::Point2d> stroke{at_m};
  for (int i = 0; i < letters; ++i) {
    const double tall = painter.Chance(0.25) ? 1.8 : painter.Uniform(0.75, 1.0);
    const double down = painter.Chance(0.12) ? 0.7 : 0.0;
    const double x_m = at_m.x + i * 0.75 * letter_m;
    const auto go = [&](double right, double up) {
      stroke.emplace_back(x_m + right * letter_m, at_m.y - up * letter_m);
    };
    go(0.25, tall);
    go(0.45, tall * painter.Uniform(0.6, 0.95));
    go(painter.Uniform(0.2, 0.4), -down);
    go(painter.Uniform(0.45, 0.6), -0.5 * down);
    go(0.7, painter.Uniform(0.1, 0.4));
  }
  painter.Line(stroke, 0.08 * letter_m, ink);
}

void PaintScrawledLines(Painter& painter, int lines, const Bgr& ink) {
  const double letter_m = 0.03;
  for (int line = 0; line < lines; ++line) {
    const double y_m = (line + 1) * 0.08;
    painter.Disc({0.01, y_m - 0.5 * letter_m}, 0.005, ink);
    for (double x_m = 0.04; x_m < 0.75 * painter.width_m();) {
      const int letters = painter.Integer(2, 7);
      PaintScrawl(painter, {x_m, y_m + painter.Uniform(-0.005, 0.005)}, letter_m, letters, ink);
      x_m += (0.75 * letters + 1.2) * letter_m;
    }
  }
}

// Boxes with words, joined by arrows.
void PaintDiagram(Painter& painter, const std::vector<Bgr>& inks) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  for (int i = 0; i < 4; ++i) {
    const cv::Point2d corner_m((0.05 + 0.55 * (i % 2)) * w_m, (0.1 + 0.48 * (i / 2)) * h_m);
    const double box_w_m = 0.36 * w_m, box_h_m = 0.28 * h_m;
    const Bgr ink = painter.Pick(inks);
    const auto shaky = [&](double x, double y) {
      return corner_m + cv::Point2d(x * box_w_m, y * box_h_m) +
             cv::Point2d(painter.Uniform(-0.006, 0.006), painter.Uniform(-0.006, 0.006));
    };
    painter.Line({shaky(0, 0), shaky(1, 0), shaky(1, 1), shaky(0, 1)}, 0.004, ink, true);
    PaintScrawl(painter, shaky(0.12, 0.65), 0.24 * box_h_m, 4, ink);
    const cv::Point2d from = shaky(1.02, 0.5), to = from + cv::Point2d(0.17 * w_m, 0);
    const cv::Point2d below = shaky(0.5, 1.05), foot = below + cv::Point2d(0, 0.16 * h_m);
    if (i % 2 == 0) {
      painter.Line(
          {from, to, to + cv::Point2d(-0.015, -0.012), to, to + cv::Point2d(-0.015, 0.012)}, 0.004,
          ink);
    }
    if (i / 2 == 0) {
      painter.Line({below, foot, foot + cv::Point2d(-0.012, -0.015), foot,
                    foot + cv::Point2d(0.012, -0.015)},
                   0.004, ink);
    }
  }
}

void PaintGraph(Painter& painter, const std::vector<Bgr>& inks) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  painter.Line({{0.1 * w_m, 0.08 * h_m}, {0.1 * w_m, 0.88 * h_m}, {0.95 * w_m, 0.88 * h_m}}, 0.004,
               inks[0]);
  for (const Bgr& ink : inks) {
    std::vector<cv::Point2d> curve;
    const double rise = painter.Uniform(0.2, 0.7), wave = painter.Uniform(3, 9);
    for (int i = 0; i <= 24; ++i) {
      const double x = i / 24.0;
      curve.emplace_back((0.1 + 0.82 * x) * w_m,
                         (0.82 - rise * x - 0.07 * std::sin(wave * x)) * h_m);
    }
    painter.Line(curve, 0.004, ink);
  }
}

// A board of the main colour with notes, diagrams and graphs.
void PaintWhiteboard(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const std::vector<Bgr> inks{{120, 50, 30}, {40, 40, 40}, {40, 40, 190}, {60, 120, 30}};
  painter.Fill(colour);
  painter.AddNoise(0.3, 0.08, 4);  // wiped
  const int columns = std::max(1, cvRound(w_m / 0.6)), rows = std::max(1, cvRound(h_m / 0.55));
  const int first = painter.Integer(0, 2);
  for (int i = 0; i < columns * rows; ++i) {
    Painter part =
        painter.Part((i % columns + 0.1) * w_m / columns, (i / columns + 0.1) * h_m / rows,
                     0.85 * w_m / columns, 0.85 * h_m / rows);
    const int kind = (first + i + i / columns) % 3;
    if (kind == 0) PaintScrawledLines(part, 5, painter.Pick(inks));
    if (kind == 1) PaintDiagram(part, inks);
    if (kind == 2) PaintGraph(part, inks);
  }
  for (int i = 0; i < 4; ++i) {
    painter.Disc({painter.Uniform(0.05, 0.95) * w_m, 0.06}, 0.012,
                 Hsv(painter.Uniform(0, 1), 0.8, 0.7));
  }
}

}  // namespace

PatternTable PrintPatterns() {
  return {{"books", Picture(PaintBooks, 0.001)},
          {"magazine", Picture(PaintMagazine, 0.001)},
          {"newspaper", Picture(PaintNewspaper, 0.001)},
          {"whiteboard", Picture(PaintWhiteboard)}};
}

}  // namespace semantic_slam
