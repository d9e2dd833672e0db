#include "semantic_slam/worlds/looks.h"

#include <algorithm>
#include <iterator>

namespace semantic_slam {
namespace {

bool LookAlike(const Surface& a, const Surface& b) {
  return a.material == b.material && a.mesh.positions_m == b.mesh.positions_m &&
         a.mesh.texture_m == b.mesh.texture_m && a.mesh.triangles == b.mesh.triangles;
}

bool LookAlike(const WorldObject& a, const WorldObject& b) {
  return a.label == b.label &&
         std::equal(a.surfaces.begin(), a.surfaces.end(), b.surfaces.begin(), b.surfaces.end(),
                    [](const Surface& x, const Surface& y) { return LookAlike(x, y); });
}

}  // namespace

std::vector<int> LooksOf(const World& world) {
  std::vector<const WorldObject*> first;  // of each look
  std::vector<int> looks;
  for (const WorldObject& object : world.objects) {
    const auto found = std::find_if(first.begin(), first.end(), [&](const WorldObject* other) {
      return LookAlike(object, *other);
    });
    looks.push_back(1 + static_cast<int>(std::distance(first.begin(), found)));
    if (found == first.end()) first.push_back(&object);
  }
  return looks;
}

}  // namespace semantic_slam
