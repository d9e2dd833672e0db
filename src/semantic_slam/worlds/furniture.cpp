#include "semantic_slam/worlds/furniture.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/furniture_builder.h"
#include "semantic_slam/worlds/furniture_families.h"

namespace semantic_slam {
namespace {

// World files name designs by their number, so that a new family belongs at the end.
DesignTable AllDesigns() {
  DesignTable all;
  for (auto* family :
       {ChairDesigns,       OfficeChairDesigns,  ArmchairDesigns,    SofaDesigns,
        TableDesigns,       DeskDesigns,         StorageDesigns,     ShelfDesigns,
        BedDesigns,         LampDesigns,         DoorDesigns,        OpeningDesigns,
        WallDesigns,        PlantDesigns,        WoodenChairDesigns, StackableChairDesigns,
        SwivelChairDesigns, EasyChairDesigns,    CouchDesigns,       BedsteadDesigns,
        WorkstationDesigns, MeetingTableDesigns, LowTableDesigns,    DiningTableDesigns,
        CupboardDesigns}) {
    for (const auto& [kind, more] : family()) {
      all[kind].insert(all[kind].end(), more.begin(), more.end());
    }
  }
  return all;
}

void AddDesigns(FurnitureKind& kind, const DesignTable& designs) {
  const auto others = designs.find(kind.name);
  if (others == designs.end()) return;
  kind.other_designs = others->second;
  kind.numbers.emplace("design", NumberRange{0, 0, double(kind.other_designs.size())});
}

std::vector<FurnitureKind> AllKinds() {
  std::vector<FurnitureKind> kinds;
  for (auto* family : {SeatingKinds, TableKinds, StorageKinds, ShelfKinds, BedKinds, KitchenKinds,
                       WallKinds, DoorKinds, OpeningKinds, ElectronicsKinds, LampKinds, PlantKinds,
                       ReadingKinds, TablewareKinds, HouseholdKinds, PersonKinds}) {
    std::vector<FurnitureKind> more = family();
    std::move(more.begin(), more.end(), std::back_inserter(kinds));
  }
  std::sort(kinds.begin(), kinds.end(),
            [](const FurnitureKind& a, const FurnitureKind& b) { return a.name < b.name; });
  const DesignTable designs = AllDesigns();
  for (FurnitureKind& kind : kinds) AddDesigns(kind, designs);
  return kinds;
}

template <typename Value>
std::string NamesOf(const std::map<std::string, Value>& known) {
  std::string names;
  for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "nothing" : names;
}

template <typename Asked, typename Known>
void CheckKnown(const std::string& what, const std::map<std::string, Asked>& asked,
                const std::map<std::string, Known>& known) {
  for (const auto& [name, value] : asked) {
    if (known.count(name) == 0) {
      throw ConfigError(what + " " + name + " is unknown, expected one of: " + NamesOf(known));
    }
  }
}

// Precondition: what is asked for is in range.
int DesignOf(const FurnitureRequest& request) {
  const auto asked = request.numbers.find("design");
  return asked == request.numbers.end() ? 0 : static_cast<int>(std::lround(asked->second));
}

void CheckSize(const FurnitureKind& kind, const Eigen::Vector3f& usual_m,
               const Eigen::Vector3f& size_m) {
  constexpr float kSmallest = 0.2f;  // times the usual
  constexpr float kLargest = 5.0f;
  const char* edges[] = {"depth", "width", "height"};
  for (int axis = 0; axis < 3; ++axis) {
    CheckInRange<float>(kind.name + "'s " + edges[axis], size_m[axis], kSmallest * usual_m[axis],
                        kLargest * usual_m[axis]);
  }
}

void CheckRequest(const FurnitureKind& kind, const FurnitureRequest& request) {
  CheckKnown(kind.name + "'s material", request.materials, kind.materials);
  CheckKnown(kind.name + "'s number", request.numbers, kind.numbers);
  for (const auto& [name, value] : request.numbers) {
    const NumberRange& range = kind.numbers.at(name);
    CheckInRange<double>(kind.name + "'s " + name, value, range.low, range.high);
  }
  if (request.size_m) CheckSize(kind, UsualSize(kind, DesignOf(request)), *request.size_m);
}

}  // namespace

const std::vector<FurnitureKind>& FurnitureKinds() {
  static const std::vector<FurnitureKind> kinds = AllKinds();
  return kinds;
}

int DesignCount(const FurnitureKind& kind) {
  return 1 + static_cast<int>(kind.other_designs.size());
}

const Eigen::Vector3f& UsualSize(const FurnitureKind& kind, int design) {
  return design == 0 ? kind.size_m : kind.other_designs[design - 1].size_m;
}

const FurnitureKind& FindFurnitureKind(const std::string& name) {
  std::string names;
  for (const FurnitureKind& kind : FurnitureKinds()) {
    if (kind.name == name) return kind;
    names += (names.empty() ? "" : ", ") + kind.name;
  }
  throw ConfigError("furniture kind " + name + " is unknown, expected one of: " + names);
}

Furniture MakeFurniture(const std::string& kind_name, const FurnitureRequest& request) {
  const FurnitureKind& kind = FindFurnitureKind(kind_name);
  CheckRequest(kind, request);
  const int design = DesignOf(request);
  FurnitureRequest sized = request;
  if (!sized.size_m) sized.size_m = UsualSize(kind, design);
  FurnitureBuilder builder(kind, sized);
  (design == 0 ? kind.build : kind.other_designs[design - 1].build)(builder);
  return builder.Finish();
}

}  // namespace semantic_slam
