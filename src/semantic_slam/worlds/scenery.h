#pragma once

#include <string>

#include "semantic_slam/worlds/painter.h"

namespace semantic_slam {

// What paintings, photographs and windows show; each fills the painter's whole image.

// Hills behind hills under a cloudy sky, a lake or a meadow with trees in front.
void PaintLandscape(Painter& painter, const Bgr& sky);
// Houses and trees across a lawn.
void PaintStreet(Painter& painter, const Bgr& sky);
// Somebody's head and shoulders.
void PaintPortrait(Painter& painter, const Bgr& background);
// Fruit and a vase on a table.
void PaintStillLife(Painter& painter, const Bgr& background);
// Overlapping plain shapes.
void PaintAbstract(Painter& painter, const Bgr& main_colour);
// One of the above, as the seed decides.
void PaintScene(Painter& painter, const Bgr& colour);

// `count` words in capitals, for titles.
std::string Words(Painter& painter, int count);

// The largest lettering of `text` that is not wider than `width_m` nor higher than `tallest_m`.
double LetterToFit(const Painter& painter, const std::string& text, double width_m,
                   double tallest_m);

}  // namespace semantic_slam
