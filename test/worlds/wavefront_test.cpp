#include "semantic_slam/worlds/wavefront.h"

#include <sstream>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Surface Facade(int material) {
  // 2 m wide, 1 m high, seen from -y.
  return {QuadMesh({0, 0, 1}, {2, 0, 0}, {0, 0, -1}), material, std::nullopt};
}

World TwoMaterials() {
  World world;
  world.materials.resize(2);
  world.materials[0].pattern = "brick";
  world.materials[1].pattern = "poster";
  world.materials[1].gloss = 0.5f;
  world.materials[1].brightness = 1.0f;
  WorldObject object;
  object.name = "wall";
  object.surfaces = {Facade(1), Facade(0)};
  world.objects = {object};
  return world;
}

int CountOf(const std::string& text, const std::string& begin) {
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line);) count += line.rfind(begin, 0) == 0;
  return count;
}

TEST(WavefrontTest, NamesOfTexturesTellThePatternAndAreUnique) {
  EXPECT_EQ(TextureNames(TwoMaterials()), (std::vector<std::string>{"brick_0", "poster_1"}));
}

TEST(WavefrontTest, PicturesStandUpright) {
  World world = TwoMaterials();
  world.objects[0].surfaces.resize(1);
  const std::string text =
      ObjText(world.objects[0], TextureNames(world), {{1, 1}, {2, 0.5f}}, "wall.mtl");
  // The upper left corner of the surface is the upper left one of the picture, (0, 1); the surface
  // is as wide as the picture and twice as high.
  EXPECT_EQ(text,
            "mtllib wall.mtl\no wall\n"
            "v 0 0 1\nvt 0 1\nvn 0 -1 0\n"
            "v 2 0 1\nvt 1 1\nvn 0 -1 0\n"
            "v 2 0 0\nvt 1 -1\nvn 0 -1 0\n"
            "v 0 0 0\nvt 0 -1\nvn 0 -1 0\n"
            "usemtl poster_1\n"
            "f 1/1/1 4/4/4 3/3/3\n"
            "f 1/1/1 3/3/3 2/2/2\n");
}

TEST(WavefrontTest, CornersCountOnOverSurfaces) {
  const World world = TwoMaterials();
  const std::string text =
      ObjText(world.objects[0], TextureNames(world), {{1, 1}, {1, 1}}, "wall.mtl");
  EXPECT_EQ(CountOf(text, "v "), 8);
  EXPECT_EQ(CountOf(text, "f 5/5/5 8/8/8 7/7/7"), 1);
  EXPECT_LT(text.find("usemtl poster_1"), text.find("usemtl brick_0"));
}

TEST(WavefrontTest, MaterialsAreThoseOfTheObject) {
  World world = TwoMaterials();
  const std::string both = MtlText(world.objects[0], world, TextureNames(world), "../textures");
  EXPECT_EQ(CountOf(both, "newmtl "), 2);
  EXPECT_EQ(CountOf(both, "map_Kd ../textures/poster_1.png"), 1);
  EXPECT_EQ(CountOf(both, "Ks 0.5 0.5 0.5"), 1);
  EXPECT_EQ(CountOf(both, "Ke 1 1 1"), 1);
  world.objects[0].surfaces.resize(1);
  EXPECT_EQ(CountOf(MtlText(world.objects[0], world, TextureNames(world), "."), "newmtl "), 1);
}

}  // namespace
}  // namespace semantic_slam
