#pragma once

#include <memory>
#include <random>
#include <vector>

#include "semantic_slam/features/frame_features.h"
#include "testing/small_room.h"

namespace semantic_slam {

// Points in the world that a camera sees at 30 images/s, each as the same feature of every image
// and with a descriptor of its own.
class PointWorld {
 public:
  // `count` points about `centre_m` that move with `velocity_mps`; in the first camera's axes.
  void Add(int count, const Eigen::Vector3d& centre_m, const Eigen::Vector3d& half_m,
           const Eigen::Vector3d& velocity_mps = Eigen::Vector3d::Zero()) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d off(uniform(random_), uniform(random_), uniform(random_));
      points_.push_back({centre_m + off.cwiseProduct(half_m), velocity_mps});
      descriptors_.push_back({bits_(), bits_(), bits_(), bits_()});
    }
  }

  // A wall 4 m ahead that fills the view.
  void AddWall(int count = 400) { Add(count, {0.0, 0.0, 4.0}, {2.4, 1.8, 0.1}); }

  // With noise of 0.3 px and 5 mm at 1 m.
  std::shared_ptr<const FrameFeatures> See(int image, const Rigid3d& T_world_camera) {
    std::normal_distribution<double> normal;
    std::vector<Feature> features;
    for (const Point& point : points_) {
      const Eigen::Vector3d p =
          T_world_camera.inverse() * (point.start_m + image / 30.0 * point.velocity_mps);
      Feature feature{};
      feature.pixel =
          (SmallCamera()->Project(p) + 0.3 * Eigen::Vector2d(normal(random_), normal(random_)))
              .cast<float>();
      feature.raw = feature.exposed = feature.pixel;
      feature.depth_m = static_cast<float>(1.0 / (1.0 / p.z() + 0.005 * normal(random_)));
      features.push_back(feature);
    }
    return std::make_shared<const FrameFeatures>(Stamp{1'000'000'000 + 33'333'333LL * image},
                                                 features, descriptors_, *SmallCamera());
  }

 private:
  struct Point {
    Eigen::Vector3d start_m, velocity_mps;
  };
  std::mt19937 random_{1};
  std::mt19937_64 bits_{2};
  std::vector<Point> points_;
  std::vector<Descriptor> descriptors_;
};

// A camera that goes to the right with 0.3 m/s and turns with 0.2 rad/s.
inline Rigid3d MovingCamera(int image) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = ExpSo3(Eigen::Vector3d(0.0, -0.2 * image / 30.0, 0.0));
  T.translation().x() = 0.3 * image / 30.0;
  return T;
}

// The way from the image before.
inline Rigid3d MovingCameraStep(int image) {
  return image > 0 ? MovingCamera(image - 1).inverse() * MovingCamera(image) : Rigid3d::Identity();
}

}  // namespace semantic_slam
