#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

// What a kind's build function works with: everything that can be chosen, settled, and where its
// parts go. Frame: x to the front, y to the left, z up; depth, width and height along them. Not
// thread-safe.
class FurnitureBuilder {
 public:
  // Precondition: the request is valid for the kind.
  FurnitureBuilder(const FurnitureKind& kind, const FurnitureRequest& request);

  float depth() const { return size_m_.x(); }
  float width() const { return size_m_.y(); }
  float height() const { return size_m_.z(); }

  // Precondition: the kind has that number.
  float Number(const std::string& name) const;

  float Random(float low, float high);
  bool Chance(double probability) { return random_.Uniform() < probability; }

  // Adds a solid to a part, that is a material of the kind. Each solid is cut from another place of
  // the material. Parts that swing alike are one.
  void Add(const std::string& part, Mesh mesh, const Rigid3d& T_object_mesh = Rigid3d::Identity(),
           const std::optional<Swing>& swing = std::nullopt);

  // An upright box, from its lowest to its highest corner.
  void Box(const std::string& part, const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m);

  // A box whose front, to +x, is one picture of material `picture`; its other sides are of `part`.
  void BoxWithPicture(const std::string& part, const std::string& picture,
                      const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m,
                      const Rigid3d& T_object_box = Rigid3d::Identity());

  // The same with the picture on top, its upper edge to -x: who sits in front of it reads it.
  void BoxWithPictureOnTop(const std::string& part, const std::string& picture,
                           const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m,
                           const Rigid3d& T_object_box = Rigid3d::Identity());

  // Covers a mesh with one picture of `size_m`, which its texture coordinates measure from 0.
  void AddPicture(const std::string& picture, const Mesh& mesh, const Eigen::Vector2f& size_m,
                  const Rigid3d& T_object_mesh = Rigid3d::Identity());

  void AddLight(const Light& light) { furniture_.lights.push_back(light); }

  // Stretches what was built to the size asked for: for what grows as it likes.
  void FitToSize();

  Furniture Finish() { return std::move(furniture_); }

 private:
  FurniturePart& PartOf(const Material& material, const std::optional<Swing>& swing);

  const FurnitureKind& kind_;
  const Eigen::Vector3f size_m_;
  const std::uint64_t seed_;
  std::map<std::string, Material> materials_;
  std::map<std::string, double> numbers_;
  RandomStream random_;
  std::uint64_t pictures_ = 0;  // so far
  Furniture furniture_;
};

}  // namespace semantic_slam
