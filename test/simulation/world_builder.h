#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// Makes small worlds by hand. Every object is one surface of dull white plaster unless told
// otherwise.
class WorldBuilder {
 public:
  WorldBuilder() {
    AddMaterial({"plaster", {200, 200, 200}});
    world_.ambient_rgb = {0.0f, 0.0f, 0.0f};
  }

  int AddMaterial(Material material) {
    world_.materials.push_back(std::move(material));
    return static_cast<int>(world_.materials.size()) - 1;
  }

  WorldObject& Add(LabelId label, const Mesh& mesh, int material = 0) {
    WorldObject object;
    object.instance = static_cast<InstanceId>(world_.objects.size() + 1);
    object.label = label;
    object.surfaces.push_back({mesh, material, {}});
    world_.objects.push_back(object);
    return world_.objects.back();
  }

  // A closed room of walls 10 cm thick from `min_m` to `max_m` (inside): one object.
  WorldObject& AddRoom(LabelId label, const Eigen::Vector3f& min_m, const Eigen::Vector3f& max_m) {
    const Eigen::Vector3f middle_m = 0.5f * (min_m + max_m), size_m = max_m - min_m;
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        Eigen::Vector3f wall_m = size_m.array() + 0.2f;
        wall_m[axis] = 0.1f;
        Append(mesh, BoxMesh(middle_m +
                                 side * (0.5f * size_m[axis] + 0.05f) * Eigen::Vector3f::Unit(axis),
                             wall_m));
      }
    }
    WorldObject& room = Add(label, mesh);
    room.is_structure = true;
    return room;
  }

  void AddLight(const Eigen::Vector3d& centre_m, double side_m = 0.4) {
    world_.lights.push_back({centre_m, side_m, {1.0f, 1.0f, 1.0f}});
  }

  World& world() { return world_; }
  std::shared_ptr<const World> Build() const { return std::make_shared<World>(world_); }

 private:
  World world_;
};

// The pose of a camera at `from_m` that looks at `to_m`, upright; T_world_camera.
inline Rigid3d LookAt(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m,
                      const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ()) {
  Rigid3d T = Rigid3d::Identity();
  const Eigen::Vector3d z = (to_m - from_m).normalized();
  const Eigen::Vector3d x = z.cross(up).normalized();
  T.linear() << x, z.cross(x), z;
  T.translation() = from_m;
  return T;
}

// A pinhole camera whose view is 90 degrees wide.
inline CameraModel SmallCamera(int width_px = 64, int height_px = 48) {
  return CameraModel({width_px,
                      height_px,
                      0.5 * width_px,
                      0.5 * width_px,
                      0.5 * (width_px - 1),
                      0.5 * (height_px - 1),
                      {}});
}

}  // namespace semantic_slam
