#pragma once

#include <map>
#include <string>

#include "semantic_slam/worlds/painter.h"

namespace semantic_slam {

// How one stuff is painted.
struct Pattern {
  enum class Extent {
    kRepeats,  // for ever: takes no picture size
    kPicture,  // one picture: needs a picture size
    kEither
  };
  using Paint = void (*)(Painter& painter, const Bgr& colour);

  Extent extent = Extent::kPicture;
  Paint paint = nullptr;
  double texel_m = 0.002;   // of a picture: at least
  cv::Size period_px;       // of what repeats: powers of two
  bool keeps_mean = false;  // the picture's mean is the material's colour
};

using PatternTable = std::map<std::string, Pattern>;

// What repeats for ever, painted over one period.
inline Pattern Repeating(Pattern::Paint paint, double texel_m, cv::Size period_px,
                         bool keeps_mean = true) {
  return {Pattern::Extent::kRepeats, paint, texel_m, period_px, keeps_mean};
}

inline Pattern Picture(Pattern::Paint paint, double texel_m = 0.002) {
  return {Pattern::Extent::kPicture, paint, texel_m, {}, false};
}

// The families, one file each.
PatternTable BuildingPatterns();  // walls, floors, ceilings
PatternTable WallPatterns();      // more of walls and ceilings
PatternTable FloorPatterns();     // more of floors
PatternTable WoodPatterns();
PatternTable TextilePatterns();
PatternTable UpholsteryPatterns();   // more of what seats are covered with, and of curtains
PatternTable RugPatterns();          // more of rugs
PatternTable PlainPatterns();        // smooth stuff of furniture and packaging
PatternTable LivingPatterns();       // plants and skin
PatternTable WallPicturePatterns();  // what hangs on a wall
PatternTable PrintPatterns();        // what is printed to be read
PatternTable DevicePatterns();

// All of them.
const PatternTable& Patterns();

}  // namespace semantic_slam
