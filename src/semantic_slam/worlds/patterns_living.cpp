#include <cmath>
#include <vector>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

void PaintLeaf(Painter& painter, const cv::Point2d& foot_m, double length_m, double heading,
               const Bgr& colour) {
  const cv::Point2d along = length_m * cv::Point2d(std::cos(heading), std::sin(heading));
  const cv::Point2d across(-0.24 * along.y, 0.24 * along.x);
  const Bgr shadow = colour * 0.72;
  painter.Polygon({foot_m, foot_m + 0.3 * along + 0.85 * across, foot_m + 0.55 * along + across,
                   foot_m + 0.8 * along + 0.6 * across, foot_m + along},
                  colour);
  painter.Polygon({foot_m, foot_m + 0.3 * along - 0.85 * across, foot_m + 0.55 * along - across,
                   foot_m + 0.8 * along - 0.6 * across, foot_m + along},
                  shadow);
  painter.Line({foot_m, foot_m + along}, 0.02 * length_m, Mix(colour, Bgr(150, 230, 220), 0.45));
}

// Leaves over leaves, the upper ones in more light.
void PaintFoliage(Painter& painter, const Bgr& colour) {
  painter.Fill(colour * 0.22);
  const int leaves = cvRound(900 * painter.width_m() * painter.height_m());
  for (int i = 0; i < leaves; ++i) {
    const double light = 0.4 + 0.8 * i / leaves;
    const cv::Point2d foot_m(painter.Uniform(0, painter.width_m()),
                             painter.Uniform(0, painter.height_m()));
    PaintLeaf(painter, foot_m, painter.Uniform(0.04, 0.1), painter.Uniform(0, 2 * CV_PI),
              painter.Near(colour * light, 18));
  }
  painter.AddNoise(0.006, 4);
}

void PaintSkin(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.Flecks(250, 0.002, 0.005, Mix(colour, Bgr(40, 70, 120), 0.3), 8);  // freckles
  painter.AddNoise(0.06, 5);
  painter.AddNoise(0.01, 3);
}

}  // namespace

PatternTable LivingPatterns() {
  return {{"foliage", Repeating(PaintFoliage, 0.002, {512, 512}, false)},
          {"skin", Repeating(PaintSkin, 0.002, {256, 256})}};
}

}  // namespace semantic_slam
