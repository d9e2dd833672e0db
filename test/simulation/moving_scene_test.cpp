#include "semantic_slam/simulation/moving_scene.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/world_builder.h"

namespace semantic_slam {
namespace {

const std::vector<Reflectance> kGrey{{Eigen::Vector3f::Constant(0.5f), 0.0f}};

// Somebody of the size of a box walks over a floor below a lamp, from x = 0 to 4 m and back.
class Street {
 public:
  explicit Street(std::optional<Swing> swing = {}) {
    builder_.Add(2, BoxMesh({0, 0, -0.05f}, {20, 20, 0.1f}));
    WorldObject& walker = builder_.Add(3, BoxMesh({0, 0, 0.9f}, {0.4f, 0.4f, 1.8f}));
    walker.walk = Walk({{0, 0}, {4, 0}}, 1.0);
    walker.surfaces[0].swing = swing;
    builder_.AddLight({0, 2, 3}, 0.3);
    world_ = builder_.Build();
    lamps_ = {world_->lights.begin(), world_->lights.end()};
    still_ = std::make_unique<StillScene>(*world_);
    moving_ = std::make_unique<MovingScene>(*world_, still_->part_count());
  }

  const MovingScene& At(double time_s) {
    const LightGatherer gatherer(*still_, kGrey, Eigen::Vector3f::Constant(0.2f));
    moving_->MoveTo(time_s, lamps_, *still_, gatherer);
    return *moving_;
  }

  Eigen::Vector3f TakenLight(float x_m, float y_m) const {
    return moving_->TakenLight(lamps_, *still_, {x_m, y_m, 0}, Eigen::Vector3f::UnitZ());
  }
  float Lamplight(float x_m, float y_m) const {
    return LightOf(lamps_, still_->rays(), {x_m, y_m, 0.002f}, Eigen::Vector3f::UnitZ())
        .irradiance[0];
  }
  const StillScene& still() const { return *still_; }
  const std::vector<Lamp>& lamps() const { return lamps_; }

 private:
  WorldBuilder builder_;
  std::shared_ptr<const World> world_;
  std::vector<Lamp> lamps_;
  std::unique_ptr<StillScene> still_;
  std::unique_ptr<MovingScene> moving_;
};

Eigen::Vector3f Middle(const SceneTriangles& scene) {
  Eigen::AlignedBox3f box;
  for (const SceneCorner& corner : scene.corners) box.extend(corner.position_m);
  return box.center();
}

TEST(MovingSceneTest, ThingsAreWhereTheyWalk) {
  Street street;
  EXPECT_NEAR(Middle(street.At(0.0).triangles()).x(), 0.0f, 1e-5f);
  EXPECT_NEAR(Middle(street.At(1.5).triangles()).x(), 1.5f, 1e-5f);
  EXPECT_NEAR(Middle(street.At(0.5).triangles()).x(), 0.5f, 1e-5f);
}

TEST(MovingSceneTest, RaysMeetThemThere) {
  Street street;
  const MovingScene& scene = street.At(2.0);
  RayPacket packet;
  packet.Clear();
  packet.Set(0, {-1, 0, 1}, {1, 0, 0});
  packet.Set(1, {0, -1, 1}, {0, 1, 0});
  scene.rays().FindHits(packet, true);
  ASSERT_TRUE(packet.IsHit(0));
  EXPECT_EQ(packet.Geometry(0), MovingScene::kGeometry);
  EXPECT_NEAR(packet.Distance(0), 2.8f, 1e-5f);
  EXPECT_FALSE(packet.IsHit(1));
  const SurfacePoint point = scene.PointAt(packet, 0, {1.8f, 0, 1}, {1, 0, 0});
  EXPECT_EQ(point.surface->label, 3);
  EXPECT_GE(point.triangle->part, street.still().part_count());
}

TEST(MovingSceneTest, SwingsAboutItsPivot) {
  Swing swing;
  swing.amplitude_rad = M_PI / 2;
  swing.period_s = 4.0;
  Street street(swing);
  // After a quarter of the period what was above the pivot lies ahead of it: 0.9 m, and 1 m walked.
  const Eigen::Vector3f middle_m = Middle(street.At(1.0).triangles());
  EXPECT_NEAR(middle_m.x(), 1.9f, 1e-5f);
  EXPECT_NEAR(middle_m.z(), 0.0f, 1e-5f);
}

TEST(MovingSceneTest, TheyTakeTheLampsLightFromWhatIsBehindThem) {
  Street street;
  street.At(0.0);
  EXPECT_NEAR(street.TakenLight(0.0f, -0.5f)[0], street.Lamplight(0.0f, -0.5f), 1e-5f);
  EXPECT_EQ(street.TakenLight(0.0f, 1.5f)[0], 0.0f);
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  EXPECT_EQ(street.At(0.0).TakenLight(street.lamps(), street.still(), {0, -0.5f, 0}, up, 0).norm(),
            0.0f)
      << "no lamp shines there";
  street.At(3.0);
  EXPECT_EQ(street.TakenLight(0.0f, -0.5f)[0], 0.0f);
}

TEST(MovingSceneTest, TheyAreLit) {
  Street street;
  const SceneTriangles& scene = street.At(0.0).triangles();
  for (std::size_t i = 0; i < scene.corners.size(); ++i) {
    const float light = scene.corner_light[i][0];
    if (scene.corners[i].normal.y() > 0.5f) {
      EXPECT_GT(light, 0.25f);  // towards the lamp
    }
    if (scene.corners[i].normal.y() < -0.5f) {
      EXPECT_LT(light, 0.25f);
      EXPECT_GT(light, 0.05f);
    }
  }
}

TEST(MovingSceneTest, NothingNeedMove) {
  WorldBuilder builder;
  builder.Add(3, BoxMesh({0, 0, 0}, {1, 1, 1}));
  const StillScene still(builder.world());
  MovingScene moving(builder.world(), still.part_count());
  moving.MoveTo(1.0, {}, still, LightGatherer(still, kGrey, Eigen::Vector3f::Zero()));
  EXPECT_TRUE(moving.triangles().triangles.empty());
  EXPECT_EQ(moving.TakenLight({}, still, {0, 0, 0}, {0, 0, 1}).norm(), 0.0f);
}

}  // namespace
}  // namespace semantic_slam
