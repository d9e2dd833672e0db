#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "semantic_slam/worlds/pattern.h"
#include "semantic_slam/worlds/scenery.h"

namespace semantic_slam {
namespace {

// A picture with a title and small print on paper of the main colour.
void PaintPoster(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  painter.Fill(colour);
  const double edge_m = 0.05 * std::min(w_m, h_m);
  const bool title_first = painter.Chance(0.4);
  const double picture_m = title_first ? 0.2 * h_m : edge_m;
  Painter scene = painter.Part(edge_m, picture_m, w_m - 2 * edge_m, 0.66 * h_m);
  PaintScene(scene, Mix(colour, Hsv(painter.Uniform(0, 1), 0.6, 0.8), 0.7));
  const std::string title = Words(painter, 2);
  const double letter_m = LetterToFit(painter, title, w_m - 2 * edge_m, 0.1 * h_m);
  const Bgr ink = InkOn(colour);
  painter.Text(edge_m, title_first ? 0.16 * h_m : 0.74 * h_m + letter_m, letter_m, title,
               title_first ? ink : Hsv(painter.Uniform(0, 1), 0.8, Luma(ink) > 110 ? 1.0 : 0.5));
  const double print_m = std::max(0.02 * h_m, 2.5 * painter.texel_m());
  painter.Print(edge_m, 0.88 * h_m, 0.55 * w_m, 0.1 * h_m, print_m, ink);
  painter.Disc({w_m - 2.2 * edge_m, 0.925 * h_m}, 1.1 * edge_m,
               Hsv(painter.Uniform(0, 1), 0.8, 0.7));
  painter.AddNoise(0.004, 2);
}

// Oil on canvas, in the main colour's tone.
void PaintPainting(Painter& painter, const Bgr& colour) {
  const Bgr sky = Hsv(painter.Uniform(0.52, 0.61), painter.Uniform(0.2, 0.6), 0.85);
  PaintScene(painter, Mix(sky, colour, 0.4));
  painter.AddNoise(0.02, 0.004, 12);  // brush strokes
  painter.AddNoise(0.004, 0.015, 9);
}

// A photograph behind a mount of the main colour.
void PaintPhotograph(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double edge_m = painter.Uniform(0.08, 0.2) * std::min(w_m, h_m);
  painter.Fill(colour);
  Painter photo = painter.Part(edge_m, edge_m, w_m - 2 * edge_m, h_m - 2 * edge_m);
  PaintScene(photo, Hsv(painter.Uniform(0, 1), painter.Uniform(0.1, 0.4), 0.85));
  if (painter.Chance(0.4)) photo.RemoveColour();
  painter.Frame(edge_m, edge_m, w_m - 2 * edge_m, h_m - 2 * edge_m, 0.003, colour * 0.6);
}

// A few plain areas and lines on paper of the main colour.
void PaintGraphicPrint(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double size_m = std::min(w_m, h_m);
  painter.Fill(colour);
  const double hue = painter.Uniform(0, 1);
  for (int i = 0; i < 7; ++i) {
    const Bgr ink = Hsv(std::fmod(hue + 0.08 * painter.Integer(0, 3), 1.0),
                        painter.Uniform(0.3, 0.8), painter.Uniform(0.3, 0.95));
    const cv::Point2d at_m(painter.Uniform(0.15, 0.85) * w_m, painter.Uniform(0.15, 0.85) * h_m);
    const double r_m = painter.Uniform(0.08, 0.25) * size_m;
    const int shape = painter.Integer(0, 2);
    if (shape == 0) painter.Disc(at_m, r_m, ink);
    if (shape == 1) painter.Ellipse(at_m, 1.4 * r_m, 0.5 * r_m, ink, painter.Uniform(0, CV_PI));
    if (shape == 2)
      painter.Polygon({at_m, at_m + cv::Point2d(r_m, 1.5 * r_m), at_m - cv::Point2d(r_m, -r_m)},
                      ink);
  }
  for (int i = 0; i < 5; ++i) {
    const double y_m = painter.Uniform(0.1, 0.9) * h_m;
    painter.Line(
        {{0.1 * w_m, y_m}, {0.5 * w_m, y_m + painter.Uniform(-0.2, 0.2) * h_m}, {0.9 * w_m, y_m}},
        0.008 * size_m, InkOn(colour));
  }
  painter.AddNoise(0.004, 4);
}

// A plant in ink, with the names of its parts.
void PaintDrawing(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double size_m = std::min(w_m, h_m);
  const Bgr ink = InkOn(colour);
  painter.Fill(colour);
  for (int stem = -2; stem <= 2; ++stem) {
    const double lean = 0.16 * stem * w_m + painter.Uniform(-0.05, 0.05) * w_m;
    const double rise_m = painter.Uniform(0.5, 0.75) * h_m;
    const auto place = [&](double share) {
      return cv::Point2d(0.5 * w_m + lean * share * share, 0.88 * h_m - share * rise_m);
    };
    painter.Line({place(0), place(0.35), place(0.7), place(1)}, 0.008 * size_m, ink);
    for (int leaf = 2; leaf <= 8; ++leaf) {
      const double side = leaf % 2 == 0 ? 1 : -1;
      const cv::Point2d at_m = place(leaf / 8.0) + cv::Point2d(side * 0.045 * size_m, 0);
      painter.Ellipse(at_m, 0.05 * size_m, 0.018 * size_m, ink, side * -0.6);
      painter.Ellipse(at_m, 0.042 * size_m, 0.012 * size_m, Mix(colour, ink, 0.25), side * -0.6);
    }
  }
  const double letter_m = 0.03 * size_m;
  painter.Text(0.1 * w_m, 0.95 * h_m, letter_m, Words(painter, 2), ink);
  painter.Frame(0.03 * size_m, 0.03 * size_m, w_m - 0.06 * size_m, h_m - 0.06 * size_m,
                0.004 * size_m, ink);
  painter.AddNoise(0.1, 3);
  painter.AddNoise(0.004, 4);
}

// A dim room, out of focus, with the main colour's cast.
void PaintMirror(Painter& painter, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  painter.Gradient(colour, colour * 0.75);
  for (int i = 0; i < 5; ++i) {
    painter.Rectangle(painter.Uniform(-0.1, 0.8) * w_m, painter.Uniform(0.3, 0.8) * h_m,
                      painter.Uniform(0.1, 0.4) * w_m, h_m, painter.Near(colour * 0.8, 16));
  }
  painter.AddNoise(0.25, 12);
  painter.Blur(0.06);
}

void PaintHand(Painter& painter, const cv::Point2d& centre_m, double angle, double length_m,
               double width_m, const Bgr& ink) {
  const cv::Point2d along(std::sin(angle), -std::cos(angle));
  painter.Line({centre_m - 0.15 * length_m * along, centre_m + length_m * along}, width_m, ink);
}

// A dial of the main colour.
void PaintClockFace(Painter& painter, const Bgr& colour) {
  const cv::Point2d centre_m(painter.width_m() / 2, painter.height_m() / 2);
  const double r_m = 0.5 * std::min(painter.width_m(), painter.height_m());
  const Bgr ink = InkOn(colour);
  painter.Fill(ink);
  painter.Disc(centre_m, 0.97 * r_m, colour);
  for (int minute = 0; minute < 60; ++minute) {
    const double angle = 2 * CV_PI * minute / 60;
    const cv::Point2d out(std::sin(angle), -std::cos(angle));
    const bool is_hour = minute % 5 == 0;
    painter.Line({centre_m + (is_hour ? 0.78 : 0.84) * r_m * out, centre_m + 0.88 * r_m * out},
                 (is_hour ? 0.03 : 0.008) * r_m, ink);
    if (!is_hour) continue;
    const std::string numeral = std::to_string(minute == 0 ? 12 : minute / 5);
    const double letter_m = 0.15 * r_m;
    const cv::Point2d at_m = centre_m + 0.64 * r_m * out;
    painter.Text(at_m.x - painter.TextWidth(letter_m, numeral) / 2, at_m.y + letter_m / 2, letter_m,
                 numeral, ink);
  }
  const double hours = painter.Uniform(0.0, 12.0);
  PaintHand(painter, centre_m, 2 * CV_PI * hours / 12, 0.45 * r_m, 0.06 * r_m, ink);
  PaintHand(painter, centre_m, 2 * CV_PI * hours, 0.7 * r_m, 0.035 * r_m, ink);
  PaintHand(painter, centre_m, painter.Uniform(0, 6.28), 0.75 * r_m, 0.01 * r_m, Bgr(40, 40, 200));
}

void PaintGranules(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.03, 8);
  painter.Flecks(6000, 0.004, 0.012, colour * 0.95, 34);
  painter.Flecks(900, 0.004, 0.009, colour * 0.55, 16);
  painter.AddNoise(0.003, 7);
}

// A sheet, a card or a photograph on a pin.
void PaintNote(Painter& painter, double x_m, double y_m, double w_m, double h_m) {
  painter.Rectangle(x_m + 0.004, y_m + 0.004, w_m, h_m, Bgr(35, 50, 65));
  Painter note = painter.Part(x_m, y_m, w_m, h_m);
  if (painter.Chance(0.3)) {
    note.Fill(Bgr::all(240));
    Painter photo = note.Part(0.008, 0.008, w_m - 0.016, h_m - 0.016);
    PaintScene(photo, Hsv(painter.Uniform(0.5, 0.65), 0.4, 0.9));
  } else {
    note.Fill(painter.Pick<Bgr>(
        {{245, 245, 245}, {130, 235, 250}, {190, 240, 200}, {210, 190, 250}, {245, 225, 190}}));
    note.Text(0.012, 0.03, 0.014, Words(painter, 1), Bgr(40, 30, 60));
    note.Print(0.012, 0.04, w_m - 0.024, h_m - 0.05, 0.011, Bgr(60, 50, 50));
  }
  painter.Disc({x_m + w_m / 2, y_m + 0.008}, 0.006, Hsv(painter.Uniform(0, 1), 0.9, 0.8));
}

// Granules; as a picture with notes pinned to them.
void PaintCork(Painter& painter, const Bgr& colour) {
  PaintGranules(painter, colour);
  if (painter.wraps()) return;
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const int columns = std::max(1, cvRound(w_m / 0.24)), rows = std::max(1, cvRound(h_m / 0.28));
  for (int i = 0; i < columns * rows; ++i) {
    if (painter.Chance(0.15)) continue;
    const double note_w_m = painter.Uniform(0.09, 0.2), note_h_m = painter.Uniform(0.1, 0.24);
    PaintNote(painter, (i % columns + painter.Uniform(0.05, 0.2)) * w_m / columns,
              (i / columns + painter.Uniform(0.05, 0.2)) * h_m / rows,
              std::min(note_w_m, 0.9 * w_m), std::min(note_h_m, 0.9 * h_m));
  }
}

}  // namespace

PatternTable WallPicturePatterns() {
  Pattern cork = Repeating(PaintCork, 0.002, {512, 512});
  cork.extent = Pattern::Extent::kEither;
  return {{"poster", Picture(PaintPoster)},
          {"painting", Picture(PaintPainting)},
          {"photograph", Picture(PaintPhotograph)},
          {"graphic_print", Picture(PaintGraphicPrint)},
          {"drawing", Picture(PaintDrawing)},
          {"window_view", Picture(PaintStreet, 0.003)},
          {"mirror", Picture(PaintMirror, 0.004)},
          {"clock_face", Picture(PaintClockFace, 0.001)},
          {"cork", cork}};
}

}  // namespace semantic_slam
