#include "semantic_slam/worlds/wavefront.h"

#include <cassert>
#include <iomanip>
#include <locale>
#include <set>
#include <sstream>

namespace semantic_slam {
namespace {

constexpr int kDigits = 6;  // significant ones: 0.1 mm in 100 m
constexpr float kShininess = 40.0f;

std::ostringstream PlainText() {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(kDigits);
  return text;
}

// Row by row down from a surface's upper left corner there; from the picture's lower left one here.
Eigen::Vector2f WavefrontTexture(const Eigen::Vector2f& texture_m, const Eigen::Vector2f& size_m) {
  return {texture_m.x() / size_m.x(), 1.0f - texture_m.y() / size_m.y()};
}

void WriteCorners(std::ostream& out, const Mesh& mesh, const Eigen::Vector2f& texture_size_m) {
  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    const Eigen::Vector3f& p = mesh.positions_m[i];
    const Eigen::Vector3f& n = mesh.normals[i];
    const Eigen::Vector2f t = WavefrontTexture(mesh.texture_m[i], texture_size_m);
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << "\nvt " << t.x() << ' ' << t.y()
        << "\nvn " << n.x() << ' ' << n.y() << ' ' << n.z() << '\n';
  }
}

// Position, texture and normal of a corner have one index, which counts from 1 over the whole file.
void WriteTriangles(std::ostream& out, const Mesh& mesh, int first_corner) {
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    out << 'f';
    for (const int corner : triangle) {
      const int index = first_corner + corner;
      out << ' ' << index << '/' << index << '/' << index;
    }
    out << '\n';
  }
}

}  // namespace

std::vector<std::string> TextureNames(const World& world) {
  std::vector<std::string> names;
  for (const Material& material : world.materials) {
    names.push_back(material.pattern + "_" + std::to_string(names.size()));
  }
  return names;
}

std::string ObjText(const WorldObject& object, const std::vector<std::string>& texture_names,
                    const std::vector<Eigen::Vector2f>& texture_sizes_m,
                    const std::string& mtl_file) {
  assert(texture_names.size() == texture_sizes_m.size());
  std::ostringstream text = PlainText();
  text << "mtllib " << mtl_file << "\no " << object.name << '\n';
  int first_corner = 1;
  for (const Surface& surface : object.surfaces) {
    WriteCorners(text, surface.mesh, texture_sizes_m[surface.material]);
    text << "usemtl " << texture_names[surface.material] << '\n';
    WriteTriangles(text, surface.mesh, first_corner);
    first_corner += static_cast<int>(surface.mesh.positions_m.size());
  }
  return text.str();
}

std::string MtlText(const WorldObject& object, const World& world,
                    const std::vector<std::string>& texture_names,
                    const std::string& texture_folder) {
  std::set<int> used;
  for (const Surface& surface : object.surfaces) used.insert(surface.material);
  std::ostringstream text = PlainText();
  for (const int index : used) {
    const float gloss = world.materials[index].gloss;
    const float glow = world.materials[index].brightness;
    text << "newmtl " << texture_names[index] << "\nKa 1 1 1\nKd 1 1 1\nKs " << gloss << ' '
         << gloss << ' ' << gloss << "\nKe " << glow << ' ' << glow << ' ' << glow << "\nNs "
         << kShininess << "\nd 1\nmap_Kd " << texture_folder << '/' << texture_names[index]
         << ".png\n";
  }
  return text.str();
}

}  // namespace semantic_slam
