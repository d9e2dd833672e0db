#include "semantic_slam/worlds/furniture_builder.h"

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

bool SwingsAlike(const std::optional<Swing>& a, const std::optional<Swing>& b) {
  if (!a || !b) return !a && !b;
  return a->pivot_m == b->pivot_m && a->axis == b->axis && a->amplitude_rad == b->amplitude_rad &&
         a->period_s == b->period_s && a->phase_rad == b->phase_rad;
}

// A box without the side whose normal is `missing`, which is returned apart.
struct OpenBox {
  Mesh sides;
  Mesh missing;
};

OpenBox SplitBox(const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m,
                 const Eigen::Vector3f& missing) {
  const Mesh box = BoxMesh(0.5f * (low_m + high_m), high_m - low_m);
  OpenBox split;
  for (std::size_t corner = 0; corner < box.positions_m.size(); corner += 4) {
    Mesh& target = box.normals[corner].dot(missing) > 0.5f ? split.missing : split.sides;
    const int first = static_cast<int>(target.positions_m.size());
    for (std::size_t i = corner; i < corner + 4; ++i) {
      target.positions_m.push_back(box.positions_m[i]);
      target.normals.push_back(box.normals[i]);
      target.texture_m.push_back(box.texture_m[i]);
    }
    target.triangles.emplace_back(first, first + 3, first + 2);
    target.triangles.emplace_back(first, first + 2, first + 1);
  }
  return split;
}

}  // namespace

FurnitureBuilder::FurnitureBuilder(const FurnitureKind& kind, const FurnitureRequest& request)
    : kind_(kind),
      size_m_(request.size_m.value_or(kind.size_m)),
      seed_(request.seed),
      materials_(request.materials),
      random_(HashOf({request.seed, 0x6675726eu})) {
  materials_.insert(kind.materials.begin(), kind.materials.end());  // where nothing was asked for
  numbers_ = request.numbers;
  for (const auto& [name, range] : kind.numbers) numbers_.emplace(name, range.usual);
  furniture_.kind = kind.name;
  furniture_.label = kind.label;
  furniture_.mount = kind.mount;
  furniture_.size_m = size_m_;
}

float FurnitureBuilder::Number(const std::string& name) const {
  return static_cast<float>(numbers_.at(name));
}

float FurnitureBuilder::Random(float low, float high) {
  return low + (high - low) * static_cast<float>(random_.Uniform());
}

FurniturePart& FurnitureBuilder::PartOf(const Material& material,
                                        const std::optional<Swing>& swing) {
  for (FurniturePart& part : furniture_.parts) {
    if (part.material == material && SwingsAlike(part.swing, swing)) return part;
  }
  furniture_.parts.push_back({{}, material, swing});
  return furniture_.parts.back();
}

void FurnitureBuilder::Add(const std::string& part, Mesh mesh, const Rigid3d& T_object_mesh,
                           const std::optional<Swing>& swing) {
  constexpr float kReachM = 10.0f;  // far enough that no two solids look alike
  const Eigen::Vector2f place_m(Random(0, kReachM), Random(0, kReachM));
  for (Eigen::Vector2f& texture_m : mesh.texture_m) texture_m += place_m;
  Append(PartOf(materials_.at(part), swing).mesh, mesh, T_object_mesh);
}

void FurnitureBuilder::Box(const std::string& part, const Eigen::Vector3f& low_m,
                           const Eigen::Vector3f& high_m) {
  Add(part, BoxMesh(0.5f * (low_m + high_m), high_m - low_m));
}

void FurnitureBuilder::AddPicture(const std::string& picture, const Mesh& mesh,
                                  const Eigen::Vector2f& size_m, const Rigid3d& T_object_mesh) {
  Material material = materials_.at(picture);
  material.picture_size_m = size_m;
  material.seed = HashOf({material.seed, seed_, pictures_++});
  Append(PartOf(material, std::nullopt).mesh, mesh, T_object_mesh);
}

void FurnitureBuilder::BoxWithPicture(const std::string& part, const std::string& picture,
                                      const Eigen::Vector3f& low_m, const Eigen::Vector3f& high_m,
                                      const Rigid3d& T_object_box) {
  const OpenBox box = SplitBox(low_m, high_m, Eigen::Vector3f::UnitX());
  Add(part, box.sides, T_object_box);
  AddPicture(picture, box.missing, box.missing.texture_m[2], T_object_box);
}

void FurnitureBuilder::BoxWithPictureOnTop(const std::string& part, const std::string& picture,
                                           const Eigen::Vector3f& low_m,
                                           const Eigen::Vector3f& high_m,
                                           const Rigid3d& T_object_box) {
  const OpenBox box = SplitBox(low_m, high_m, Eigen::Vector3f::UnitZ());
  Add(part, box.sides, T_object_box);
  const Eigen::Vector3f size_m = high_m - low_m;
  const Mesh top =
      QuadMesh({low_m.x(), low_m.y(), high_m.z()}, {0, size_m.y(), 0}, {size_m.x(), 0, 0});
  AddPicture(picture, top, top.texture_m[2], T_object_box);
}

void FurnitureBuilder::FitToSize() {
  Eigen::AlignedBox3f built;
  for (const FurniturePart& part : furniture_.parts) {
    for (const Eigen::Vector3f& p : part.mesh.positions_m) built.extend(p);
  }
  const Eigen::Vector3f scale = size_m_.cwiseQuotient(built.sizes());
  Eigen::Vector3f low_m(-0.5f * depth(), -0.5f * width(), 0);
  if (kind_.mount == Mount::kWall) low_m.x() = 0;
  for (FurniturePart& part : furniture_.parts) {
    for (Eigen::Vector3f& p : part.mesh.positions_m) {
      p = low_m + (p - built.min()).cwiseProduct(scale);
    }
    for (Eigen::Vector3f& n : part.mesh.normals) n = n.cwiseQuotient(scale).normalized();
    if (!part.swing) continue;
    const Eigen::Vector3f pivot_m = part.swing->pivot_m.cast<float>() - built.min();
    part.swing->pivot_m = (low_m + pivot_m.cwiseProduct(scale)).cast<double>();
  }
}

}  // namespace semantic_slam
