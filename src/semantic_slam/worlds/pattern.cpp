#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

PatternTable AllPatterns() {
  PatternTable all;
  for (PatternTable family :
       {BuildingPatterns(), WallPatterns(), FloorPatterns(), WoodPatterns(), TextilePatterns(),
        UpholsteryPatterns(), RugPatterns(), PlainPatterns(), LivingPatterns(),
        WallPicturePatterns(), PrintPatterns(), DevicePatterns()}) {
    all.merge(family);
  }
  return all;
}

}  // namespace

const PatternTable& Patterns() {
  static const PatternTable kPatterns = AllPatterns();
  return kPatterns;
}

}  // namespace semantic_slam
