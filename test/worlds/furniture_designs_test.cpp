#include <set>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/furniture.h"
#include "testing/expect_error.h"
#include "worlds/furniture_requests.h"

namespace semantic_slam {
namespace {

// Share of the plan, in columns of a twelfth of each side, in which no surface is below `high_m`.
double FreeShareBelow(const Furniture& furniture, float high_m) {
  constexpr int kCells = 12;
  constexpr float kStepM = 0.03f;  // between the places of a surface that are looked at
  const Mesh whole = WholeMesh(furniture);
  std::set<std::pair<int, int>> taken;
  for (const Eigen::Vector3i& t : whole.triangles) {
    const Eigen::Vector3f& a = whole.positions_m[t[0]];
    const Eigen::Vector3f right = whole.positions_m[t[1]] - a;
    const Eigen::Vector3f up = whole.positions_m[t[2]] - a;
    const int steps = 1 + static_cast<int>((right.norm() + up.norm()) / kStepM);
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; i + j <= steps; ++j) {
        const Eigen::Vector3f p = a + (i * right + j * up) / static_cast<float>(steps);
        if (p.z() > high_m) continue;
        taken.emplace(static_cast<int>((p.x() / furniture.size_m.x() + 0.5f) * 0.999f * kCells),
                      static_cast<int>((p.y() / furniture.size_m.y() + 0.5f) * 0.999f * kCells));
      }
    }
  }
  return 1.0 - static_cast<double>(taken.size()) / (kCells * kCells);
}

TEST(FurnitureDesignsTest, ThereIsSpaceBelowEveryDesign) {
  // Up to this share of the height there are legs and feet alone, and the drawers of a desk; this
  // share of the plan is left free by them.
  for (const auto& [name, height_share, free_share] : {std::tuple("chair", 0.3f, 0.5),
                                                       {"table", 0.8f, 0.5},
                                                       {"round_table", 0.8f, 0.5},
                                                       {"conference_table", 0.8f, 0.5},
                                                       {"desk", 0.6f, 0.25}}) {
    const FurnitureKind& kind = FindFurnitureKind(name);
    for (int design = 0; design < DesignCount(kind); ++design) {
      const Furniture furniture = MakeFurniture(name, RequestOf(kind, design));
      EXPECT_GT(FreeShareBelow(furniture, height_share * furniture.size_m.z()), free_share)
          << name << ", design " << design;
    }
  }
}

TEST(FurnitureDesignsTest, ADesignHasASizeOfItsOwn) {
  FurnitureRequest request;
  request.numbers["design"] = 3;
  const FurnitureKind& chair = FindFurnitureKind("chair");
  EXPECT_EQ(MakeFurniture("chair", request).size_m, UsualSize(chair, 3));
  EXPECT_NE(UsualSize(chair, 3), chair.size_m);
  EXPECT_EQ(UsualSize(chair, 0), chair.size_m);
  request.numbers["design"] = DesignCount(chair);
  ExpectOneLineWith(MessageOf<ConfigError>([&] { MakeFurniture("chair", request); }),
                    {"chair's design = ", "but must be in [0, "});
}

TEST(FurnitureDesignsTest, EveryDesignOfLampsOnTheCeilingShinesDownwards) {
  for (const FurnitureKind& kind : FurnitureKinds()) {
    if (kind.mount != Mount::kCeiling) continue;
    for (int design = 0; design < DesignCount(kind); ++design) {
      const Furniture lamp = MakeFurniture(kind.name, RequestOf(kind, design));
      ASSERT_EQ(lamp.lights.size(), 1u) << kind.name << ", design " << design;
      EXPECT_LT(lamp.lights[0].centre_m.z(), 0.0) << kind.name << ", design " << design;
    }
  }
}

}  // namespace
}  // namespace semantic_slam
