#include "semantic_slam/octree/ray_layer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "semantic_slam/common/lanes.h"

namespace semantic_slam {
namespace {

// The other axes are left at most once between two borders of the fastest one, if rounding does not
// make it twice: not so if they are all but as fast.
constexpr double kFaster = 1.0 + 1e-9;

// The last layers are left to the plain walk, which looks at every step whether it is at the end.
constexpr int kLastLayers = 2;

constexpr unsigned kBrickDepth = 13;

// Whether the other two axes are left before, or with, axis A. Of two that are left at once RayWalk
// takes the later one first.
template <int kA>
Longs2 AreLeftFirst(Doubles2 others, double next_a) {
  const Doubles2 border{next_a, next_a};
  if constexpr (kA == 0) {
    return others <= border;
  } else if constexpr (kA == 2) {
    return others < border;
  } else {
    return (others < border) | ((others == border) & Longs2{0, -1});
  }
}

}  // namespace

void RayLayer::Reset(const ScanLayout& layout, const SemanticOcTree& tree) {
  layout_ = &layout;
  tree_ = &tree;
  places_.assign(layout.bricks(), kUnknown);
  bricks_.assign(1, 0);
  bytes_.assign(ScanLayout::kBrickVoxels, 0);
}

void RayLayer::LookUp(Number brick) {
  const octomap::OcTreeKey corner = layout_->CornerOf(brick);
  const SemanticNode* node =
      tree_->getRoot() == nullptr ? nullptr : tree_->search(corner, kBrickDepth);
  if (node != nullptr && tree_->CanGetNoFreer(node)) {
    places_[brick] = kNeedless;
    return;
  }
  places_[brick] = static_cast<std::int32_t>(bricks_.size());
  bricks_.push_back(static_cast<std::uint32_t>(brick));
  bytes_.resize(bytes_.size() + ScanLayout::kBrickVoxels);
}

void RayLayer::Mark(RayWalk ray) {
  const double x = ray.axis(0).delta, y = ray.axis(1).delta, z = ray.axis(2).delta;
  if (y > x * kFaster && z > x * kFaster) {
    MarkFast<0>(ray);
  } else if (x > y * kFaster && z > y * kFaster) {
    MarkFast<1>(ray);
  } else if (x > z * kFaster && y > z * kFaster) {
    MarkFast<2>(ray);
  }
  const ScanLayout& layout = *layout_;
  ray.ForEachVoxel([&](int x_key, int y_key, int z_key) {
    const Number voxel = layout.On(0, x_key) + layout.On(1, y_key) + layout.On(2, z_key);
    const std::int32_t place = PlaceOf(voxel >> ScanLayout::kBrickBits);
    bytes_[ByteOf(voxel, place)] = 1;
  });
}

// Between two borders of axis A, a layer of voxels, each of the other axes is left once or not at
// all. So a layer has up to three voxels: the one where the ray comes in, the one after the first
// of the others is left, and the one after both are. All three are marked, be they the same or not:
// that takes no branch, which could not be foretold.
//
// Layers are taken brick by brick. Where the brick needs no marks the ray first runs through all of
// its layers without any; if the bricks beside that it can have met need none either, that was all.
template <int kA>
void RayLayer::MarkFast(RayWalk& ray) {
  constexpr int kB = kA == 0 ? 1 : 0, kC = kA == 2 ? 1 : 2;
  const RayWalk::Axis a = ray.axis(kA), b = ray.axis(kB), c = ray.axis(kC);
  int layers = std::abs(a.end_key - a.key) - kLastLayers;
  if (layers <= 0) return;
  const Number* const numbers_a = layout_->numbers(kA) - layout_->lowest(kA);
  const Number* const numbers_b = layout_->numbers(kB) - layout_->lowest(kB);
  const Number* const numbers_c = layout_->numbers(kC) - layout_->lowest(kC);
  const Doubles2 delta{b.delta, c.delta};
  const Longs2 steps{b.step, c.step};
  int key_a = a.key;
  Longs2 keys{b.key, c.key};
  double next_a = a.next;
  Doubles2 next{b.next, c.next};
  while (layers > 0) {
    const int to_border = a.step > 0 ? 8 - (key_a & 7) : (key_a & 7) + 1;
    const int count = std::min(layers, to_border);
    layers -= count;
    const auto needs_none = [&](std::int64_t key_b, std::int64_t key_c) {
      const Number voxel = numbers_a[key_a] + numbers_b[key_b] + numbers_c[key_c];
      return PlaceOf(voxel >> ScanLayout::kBrickBits) == kNeedless;
    };
    if (needs_none(keys[0], keys[1])) {
      double run_a = next_a;
      Doubles2 run = next;
      Longs2 run_keys = keys;
      for (int i = 0; i < count; ++i, run_a += a.delta) {
        const Longs2 leaves = AreLeftFirst<kA>(run, run_a);
        run = leaves ? run + delta : run;
        run_keys += leaves & steps;
      }
      if (needs_none(run_keys[0], run_keys[1]) && needs_none(keys[0], run_keys[1]) &&
          needs_none(run_keys[0], keys[1])) {
        key_a += count * a.step;
        next_a = run_a;
        next = run;
        keys = run_keys;
        continue;
      }
    }
    Number at_b = numbers_b[keys[0]], at_c = numbers_c[keys[1]];
    for (int i = 0; i < count; ++i, key_a += a.step, next_a += a.delta) {
      const Longs2 leaves = AreLeftFirst<kA>(next, next_a);
      const bool c_first = next[1] <= next[0];
      next = leaves ? next + delta : next;
      keys += leaves & steps;
      const Number after_b = numbers_b[keys[0]], after_c = numbers_c[keys[1]];
      const Number here = numbers_a[key_a];
      const Number first = here + at_b + at_c;
      const Number second = here + (c_first ? at_b + after_c : after_b + at_c);
      const Number third = here + after_b + after_c;
      std::int32_t first_place = places_[first >> ScanLayout::kBrickBits],
                   second_place = places_[second >> ScanLayout::kBrickBits],
                   third_place = places_[third >> ScanLayout::kBrickBits];
      if ((first_place | second_place | third_place) < 0) {
        first_place = PlaceOf(first >> ScanLayout::kBrickBits);
        second_place = PlaceOf(second >> ScanLayout::kBrickBits);
        third_place = PlaceOf(third >> ScanLayout::kBrickBits);
      }
      std::uint8_t* const bytes = bytes_.data();
      bytes[ByteOf(first, first_place)] = 1;
      bytes[ByteOf(second, second_place)] = 1;
      bytes[ByteOf(third, third_place)] = 1;
      at_b = after_b;
      at_c = after_c;
    }
  }
  ray.Set(kA, key_a, next_a);
  ray.Set(kB, static_cast<int>(keys[0]), next[0]);
  ray.Set(kC, static_cast<int>(keys[1]), next[1]);
}

}  // namespace semantic_slam
