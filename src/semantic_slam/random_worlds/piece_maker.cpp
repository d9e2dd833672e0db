#include "semantic_slam/random_worlds/piece_maker.h"

#include <algorithm>
#include <set>

#include "semantic_slam/random_worlds/choice.h"
#include "semantic_slam/random_worlds/random_material.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kStock = 4;  // materials of a pattern per world

// Kinds whose width is that of what they belong to, or of which there are standard sizes.
bool HasFixedWidth(const std::string& kind) {
  static const std::set<std::string> kinds{"oven", "fridge", "microwave", "sink", "person"};
  return kinds.count(kind) > 0;
}

// Numbers that say what a piece is, not what it is like.
bool IsStructural(const std::string& number) {
  static const std::set<std::string> numbers{"design",    "leaf",    "open_deg",      "hinge_left",
                                             "sink_hole", "walking", "step_period_s", "light"};
  return numbers.count(number) > 0;
}

}  // namespace

Material PieceMaker::MaterialLike(const Material& usual) {
  std::vector<Material>& stock = stock_[{usual.pattern, usual.brightness > 0.0f}];
  const bool has_palette = usual.pattern != "skin" && usual.pattern != "carpet";
  if (has_palette && stock.size() >= kStock) return OneOf(random_, stock);
  Material material = RandomMaterial(split_, usual, random_);
  stock.push_back(material);
  return material;
}

int PieceMaker::ChooseDesign(const FurnitureKind& kind) {
  return OneOf(random_, DesignsFor(split_, kind));
}

Eigen::Vector3f PieceMaker::ChooseSize(const FurnitureKind& kind, int design) {
  Eigen::Vector3f size_m = UsualSize(kind, design);
  const double proportion = ProportionFor(split_, kind, random_);
  const double longer = Between(random_, 0.95, 1.1);
  size_m.z() *= static_cast<float>(Between(random_, 0.96, 1.05));
  if (HasFixedWidth(kind.name)) return size_m;
  const bool is_round = size_m.x() == size_m.y();
  size_m.x() *= static_cast<float>(proportion);
  size_m.y() *= static_cast<float>(proportion * (is_round ? 1.0 : longer));
  return size_m;
}

void PieceMaker::ChooseDetails(const FurnitureKind& kind, int design, FurnitureRequest& request) {
  for (const auto& [name, range] : kind.numbers) {
    if (IsStructural(name)) continue;
    const bool is_switch = range.low == 0.0 && range.high == 1.0 && range.usual == 0.0;
    request.numbers[name] = is_switch
                                ? WholeBetween(random_, 0, 1)
                                : 0.5 * (range.usual + Between(random_, range.low, range.high));
  }
  if (kind.numbers.count("design") > 0) request.numbers["design"] = design;
  for (const auto& [part, usual] : kind.materials) request.materials[part] = MaterialLike(usual);
  request.seed = SeedFor(split_, random_);
}

Item PieceMaker::Make(const std::string& kind_name) {
  const FurnitureKind& kind = FindFurnitureKind(kind_name);
  Item item;
  item.kind = kind_name;
  const int design = ChooseDesign(kind);
  item.request.size_m = ChooseSize(kind, design);
  ChooseDetails(kind, design, item.request);
  return item;
}

Item PieceMaker::MakeOfSize(const std::string& kind_name, const Eigen::Vector3f& size_m) {
  const FurnitureKind& kind = FindFurnitureKind(kind_name);
  Item item;
  item.kind = kind_name;
  const int design = ChooseDesign(kind);
  const Eigen::Vector3f usual_m = UsualSize(kind, design);
  item.request.size_m = size_m.cwiseMax(0.21f * usual_m).cwiseMin(4.9f * usual_m);
  ChooseDetails(kind, design, item.request);
  return item;
}

}  // namespace semantic_slam
