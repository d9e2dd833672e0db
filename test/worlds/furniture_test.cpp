#include "semantic_slam/worlds/furniture.h"

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/worlds/pattern.h"
#include "testing/expect_error.h"
#include "testing/mesh_checks.h"
#include "worlds/furniture_requests.h"

namespace semantic_slam {
namespace {

// True if a triangle reaches into an upright box.
bool Touches(const Furniture& furniture, const Eigen::AlignedBox3f& box) {
  const Mesh whole = WholeMesh(furniture);
  for (const Eigen::Vector3i& t : whole.triangles) {
    Eigen::AlignedBox3f bounds;
    for (int i = 0; i < 3; ++i) bounds.extend(whole.positions_m[t[i]]);
    if (bounds.intersects(box)) return true;
  }
  return false;
}

// Which design a request is for, for what a failed test says.
std::string DesignIn(const FurnitureRequest& request) {
  const auto design = request.numbers.find("design");
  return "design " + std::to_string(design == request.numbers.end() ? 0 : design->second);
}

class EveryKind : public testing::TestWithParam<std::string> {
 protected:
  const FurnitureKind& kind() const { return FindFurnitureKind(GetParam()); }

  // Of every design: the usual size, and one stretched differently along each axis.
  std::vector<FurnitureRequest> Requests() const {
    std::vector<FurnitureRequest> requests;
    for (int design = 0; design < DesignCount(kind()); ++design) {
      FurnitureRequest request = RequestOf(kind(), design);
      requests.push_back(request);
      request.seed = 77;
      requests.push_back(request);
      request.seed = 1;
      request.size_m = UsualSize(kind(), design).cwiseProduct(Eigen::Vector3f(1.15f, 1.3f, 1.1f));
      requests.push_back(request);
    }
    return requests;
  }

  // Of all that can be asked for.
  std::vector<FurniturePart> AllParts() const {
    std::vector<FurniturePart> all;
    for (const FurnitureRequest& request : Requests()) {
      const Furniture furniture = MakeFurniture(GetParam(), request);
      all.insert(all.end(), furniture.parts.begin(), furniture.parts.end());
    }
    return all;
  }
};

TEST_P(EveryKind, IsClosedAndWoundOutwards) {
  for (const FurnitureRequest& request : Requests()) {
    SCOPED_TRACE(DesignIn(request));
    const Furniture furniture = MakeFurniture(GetParam(), request);
    for (const FurniturePart& part : furniture.parts) EXPECT_EQ(FaultOf(part.mesh), "");
    const Mesh whole = WholeMesh(furniture);
    EXPECT_EQ(OpenEdgeOf(whole), "");
    EXPECT_GT(VolumeOf(whole), 0.0);
  }
}

TEST_P(EveryKind, IsAsLargeAsAsked) {
  for (const FurnitureRequest& request : Requests()) {
    SCOPED_TRACE(DesignIn(request));
    const Furniture furniture = MakeFurniture(GetParam(), request);
    const Eigen::Vector3f size_m = furniture.size_m;
    EXPECT_EQ(size_m, request.size_m.value_or(size_m));
    const Eigen::AlignedBox3f bounds = BoundsOf(WholeMesh(furniture));
    Eigen::Vector3f low_m(-0.5f * size_m.x(), -0.5f * size_m.y(), 0);
    if (kind().mount == Mount::kWall) low_m.x() = 0;
    // 1e-5 m: single precision.
    EXPECT_LT((bounds.min() - low_m).norm(), 1e-5f) << bounds.min().transpose();
    EXPECT_LT((bounds.sizes() - size_m).norm(), 1e-5f) << bounds.sizes().transpose();
  }
}

TEST_P(EveryKind, HasALabelOfTheVocabulary) {
  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/labels.yaml");
  EXPECT_TRUE(vocabulary.Find(kind().label).has_value()) << kind().label;
}

TEST_P(EveryKind, TakesOtherMaterialsForEachPart) {
  for (const auto& [part, usual] : kind().materials) {
    bool found = false;  // in one design at least
    for (int design = 0; design < DesignCount(kind()); ++design) {
      FurnitureRequest request;
      for (const auto& [name, range] : kind().numbers) request.numbers[name] = range.high;
      if (DesignCount(kind()) > 1) request.numbers["design"] = design;
      request.materials[part] = usual;
      request.materials[part].rgb = {1, 2, 3};
      for (const FurniturePart& made : MakeFurniture(GetParam(), request).parts) {
        found = found || made.material.rgb == std::array<std::uint8_t, 3>{1, 2, 3};
      }
    }
    EXPECT_TRUE(found) << part;
  }
}

TEST_P(EveryKind, IsMadeOfWhatCanBePainted) {
  for (const FurniturePart& part : AllParts()) {
    const auto pattern = Patterns().find(part.material.pattern);
    ASSERT_NE(pattern, Patterns().end()) << part.material.pattern;
    const bool is_picture = !part.material.picture_size_m.isZero();
    const auto other = is_picture ? Pattern::Extent::kRepeats : Pattern::Extent::kPicture;
    EXPECT_NE(pattern->second.extent, other) << part.material.pattern;
  }
}

TEST_P(EveryKind, HasDesignsThatDiffer) {
  std::vector<std::vector<Eigen::Vector3f>> shapes;
  for (int design = 0; design < DesignCount(kind()); ++design) {
    const Mesh mesh = WholeMesh(MakeFurniture(GetParam(), RequestOf(kind(), design)));
    for (const auto& other : shapes) EXPECT_NE(mesh.positions_m, other) << "design " << design;
    shapes.push_back(mesh.positions_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Furniture, EveryKind, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const FurnitureKind& kind : FurnitureKinds()) {
                             names.push_back(kind.name);
                           }
                           return names;
                         }()),
                         [](const auto& kind) { return kind.param; });

TEST(FurnitureTest, EveryNameIsThereOnce) {
  std::set<std::string> names;
  for (const FurnitureKind& kind : FurnitureKinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  }
}

TEST(FurnitureTest, TheSameRequestGivesTheSamePiece) {
  for (const char* kind : {"bookshelf", "plant", "book_stack"}) {
    FurnitureRequest request;
    const Mesh first = WholeMesh(MakeFurniture(kind, request));
    EXPECT_EQ(first.positions_m, WholeMesh(MakeFurniture(kind, request)).positions_m) << kind;
    request.seed = 2;
    EXPECT_NE(first.positions_m, WholeMesh(MakeFurniture(kind, request)).positions_m) << kind;
  }
}

TEST(FurnitureTest, PicturesOfOtherSeedsDiffer) {
  FurnitureRequest request;
  const auto picture_of = [&] {
    for (const FurniturePart& part : MakeFurniture("poster", request).parts) {
      if (part.material.pattern == "poster") return part.material;
    }
    return Material();
  };
  const Material first = picture_of();
  EXPECT_TRUE(first.picture_size_m.isApprox(Eigen::Vector2f(0.6f, 0.84f)));
  request.seed = 2;
  EXPECT_NE(picture_of().seed, first.seed);
}

TEST(FurnitureTest, ThereIsSpaceBelowTops) {
  for (const char* kind : {"table", "desk", "coffee_table", "conference_table", "round_table"}) {
    const Furniture furniture = MakeFurniture(kind);
    const Eigen::Vector3f half = 0.5f * furniture.size_m;
    // A third of the space below, in the middle.
    const Eigen::AlignedBox3f legs(
        Eigen::Vector3f(-0.3f * half.x(), -0.3f * half.y(), 0.0f),
        Eigen::Vector3f(0.3f * half.x(), 0.3f * half.y(), 0.8f * furniture.size_m.z()));
    EXPECT_FALSE(Touches(furniture, legs)) << kind;
  }
}

TEST(FurnitureTest, ThereIsSpaceBelowSeatsAndBeds) {
  for (const auto& [kind, high_m] :
       {std::pair("chair", 0.38f), {"stool", 0.38f}, {"bed", 0.15f}, {"sofa", 0.09f}}) {
    const Furniture furniture = MakeFurniture(kind);
    const Eigen::Vector3f half = 0.25f * furniture.size_m;
    EXPECT_FALSE(Touches(furniture, {Eigen::Vector3f(-half.x(), -half.y(), 0),
                                     Eigen::Vector3f(half.x(), half.y(), high_m)}))
        << kind;
  }
}

TEST(FurnitureTest, ADoorOpensToItsFront) {
  const FurnitureKind& kind = FindFurnitureKind("door");
  for (int design = 0; design < DesignCount(kind); ++design) {
    FurnitureRequest request = RequestOf(kind, design);
    request.numbers["open_deg"] = 90;
    for (const double hinge_left : {0.0, 1.0}) {
      request.numbers["hinge_left"] = hinge_left;
      const Furniture door = MakeFurniture("door", request);
      EXPECT_GT(BoundsOf(WholeMesh(door)).max().x(), 0.8f) << DesignIn(request);
      // Whoever goes through meets nothing.
      EXPECT_FALSE(
          Touches(door, {Eigen::Vector3f(-0.5f, -0.3f, 0.0f), Eigen::Vector3f(1.0f, 0.3f, 1.9f)}))
          << DesignIn(request);
    }
  }
}

TEST(FurnitureTest, WhoWalksSwingsArmsAndLegsAgainstEachOther) {
  FurnitureRequest request;
  request.numbers = {{"walking", 1.0}, {"step_period_s", 1.0}};
  std::set<long> phases;
  int swinging = 0;
  for (const FurniturePart& part : MakeFurniture("person", request).parts) {
    if (!part.swing) continue;
    ++swinging;
    EXPECT_EQ(part.swing->period_s, 1.0);
    phases.insert(std::lround(std::cos(part.swing->phase_rad)));
  }
  EXPECT_GE(swinging, 8);  // sleeve, hand, trousers and shoe on each side
  EXPECT_EQ(phases.size(), 2u);
  for (const FurniturePart& part : MakeFurniture("person").parts) EXPECT_FALSE(part.swing);
}

TEST(FurnitureTest, CeilingLampsCarryALight) {
  FurnitureRequest request;
  request.numbers["light"] = 2.0;
  const Furniture lamp = MakeFurniture("ceiling_lamp", request);
  ASSERT_EQ(lamp.lights.size(), 1u);
  EXPECT_LT(lamp.lights[0].centre_m.z(), 0.0);  // or the lamp's own shade would hide it
  request.numbers["light"] = 0.0;
  EXPECT_TRUE(MakeFurniture("ceiling_lamp", request).lights.empty());
}

TEST(FurnitureTest, RefusesByName) {
  EXPECT_EQ(MessageOf<ConfigError>([] {
              MakeFurniture("throne");
            }).rfind("furniture kind throne is unknown, expected one of: armchair, bag, bed", 0),
            0u);
  FurnitureRequest request;
  request.materials["gold"] = Material();
  EXPECT_EQ(MessageOf<ConfigError>([&] { MakeFurniture("stool", request); }),
            "stool's material gold is unknown, expected one of: frame, seat");
  request = {};
  request.numbers["legs"] = 3;
  EXPECT_EQ(MessageOf<ConfigError>([&] { MakeFurniture("stool", request); }),
            "stool's number legs is unknown, expected one of: nothing");
  request = {};
  request.numbers["open_deg"] = 170;
  EXPECT_EQ(MessageOf<ConfigError>([&] { MakeFurniture("door", request); }),
            "door's open_deg = 170, but must be in [0, 95]");
  request = {};
  request.size_m = Eigen::Vector3f(0.4f, 40.0f, 0.4f);
  ExpectOneLineWith(MessageOf<ConfigError>([&] { MakeFurniture("stool", request); }),
                    {"stool's width = 40, but must be in [0.07"});
}

}  // namespace
}  // namespace semantic_slam
