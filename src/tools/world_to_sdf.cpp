#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/worlds/sdf_world.h"
#include "semantic_slam/worlds/texture.h"
#include "semantic_slam/worlds/wavefront.h"
#include "semantic_slam/worlds/world_file.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Writes a simulated world (config/worlds) for Gazebo 11: OUT_DIR/world.sdf, SDF 1.6, with the\n"
    "meshes and textures that it names. Gazebo finds those if OUT_DIR is on "
    "GAZEBO_RESOURCE_PATH.";

constexpr char kDroneUri[] = "model://hummingbird_d455";  // config/gazebo

namespace fs = std::filesystem;

struct Arguments {
  std::string world;
  std::string out;
  std::string labels;
  std::string tour;
  int texture_size_px = 1024;
};

// Writes the material's picture, made smaller if need be. Returns its width and height [m].
Eigen::Vector2f WriteTexture(const Material& material, int max_size_px, const fs::path& path) {
  const Texture texture(material);
  cv::Mat image = texture.image();
  const Eigen::Vector2f size_m = texture.texel_m() * Eigen::Vector2f(image.cols, image.rows);
  const double scale = static_cast<double>(max_size_px) / std::max(image.cols, image.rows);
  if (scale < 1.0) cv::resize(image, image, {}, scale, scale, cv::INTER_AREA);
  WriteFileAtomicallyVia(path, [&](const std::string& file) { return cv::imwrite(file, image); });
  return size_m;
}

std::vector<Eigen::Vector2f> WriteTextures(const World& world,
                                           const std::vector<std::string>& names, int max_size_px,
                                           const fs::path& folder) {
  ProgressBar progress("painting", world.materials.size());
  std::vector<Eigen::Vector2f> sizes_m;
  for (const Material& material : world.materials) {
    const fs::path path = folder / (names[sizes_m.size()] + ".png");
    sizes_m.push_back(WriteTexture(material, max_size_px, path));
    progress.Update(sizes_m.size());
  }
  return sizes_m;
}

void WriteText(const fs::path& path, const std::string& text) {
  WriteFileAtomically(path, [&](std::ostream& out) { out << text; });
}

void WriteMeshes(const World& world, const std::vector<std::string>& model_names,
                 const std::vector<std::string>& texture_names,
                 const std::vector<Eigen::Vector2f>& texture_sizes_m, const fs::path& folder) {
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const WorldObject& object = world.objects[i];
    const std::string mtl_file = model_names[i] + ".mtl";
    WriteText(folder / mtl_file, MtlText(object, world, texture_names, "../textures"));
    WriteText(folder / (model_names[i] + ".obj"),
              ObjText(object, texture_names, texture_sizes_m, mtl_file));
  }
}

// Where a tour starts.
std::optional<SdfDrone> DroneAtStart(const std::string& path_or_name) {
  if (path_or_name.empty()) return std::nullopt;
  const std::string path = FindInConfig(path_or_name, "tours");
  const Tour tour = LoadTour(path);
  if (tour.waypoints.empty()) throw ConfigError(path + ": a tour without waypoints has no start");
  const Waypoint& start = tour.waypoints.front();
  SdfDrone drone{kDroneUri, Rigid3d::Identity()};
  drone.T_world_drone.translate(start.position_m)
      .rotate(Eigen::AngleAxisd(start.yaw_rad, Eigen::Vector3d::UnitZ()));
  return drone;
}

void Print(const World& world, const std::string& out) {
  const auto moving = std::count_if(world.objects.begin(), world.objects.end(),
                                    [](const WorldObject& object) { return object.IsMoving(); });
  const Eigen::Vector3d &low = world.bounds_m.min(), &high = world.bounds_m.max();
  std::printf("%s/world.sdf: %zu models, %td actors, %zu textures, %zu lamps\n", out.c_str(),
              world.objects.size() - moving, moving, world.materials.size(), world.lights.size());
  std::printf("x, y, z [m]: %.3f to %.3f, %.3f to %.3f, %.3f to %.3f\n", low.x(), high.x(), low.y(),
              high.y(), low.z(), high.z());
}

int WorldToSdf(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("WORLD", &arguments.world,
                        "world file, or the name of one in config/worlds");
  command_line.Argument("OUT_DIR", &arguments.out, "the folder to write");
  command_line.Option("labels", "LABELS.yaml", &arguments.labels,
                      "the vocabulary; default: config/labels.yaml");
  command_line.Option(
      "tour", "TOUR.yaml", &arguments.tour,
      "put the model hummingbird_d455 where this tour, a file or the name of one in "
      "config/tours, starts; default: no drone");
  command_line.Option("texture-size", "PX", &arguments.texture_size_px,
                      "longest side of a texture [px]");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--texture-size", arguments.texture_size_px, 16, 16384);
  const std::optional<SdfDrone> drone = DroneAtStart(arguments.tour);
  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(ConfigFile(arguments.labels, "labels.yaml"));
  const World world = LoadWorld(FindInConfig(arguments.world, "worlds"), vocabulary);
  const fs::path out = arguments.out;
  const std::vector<std::string> model_names = ModelNames(world);
  const std::vector<std::string> texture_names = TextureNames(world);
  const std::vector<Eigen::Vector2f> texture_sizes_m =
      WriteTextures(world, texture_names, arguments.texture_size_px, out / "textures");
  WriteMeshes(world, model_names, texture_names, texture_sizes_m, out / "meshes");
  WriteText(out / "world.sdf", SdfText(world, model_names, drone));
  Print(world, arguments.out);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::WorldToSdf);
}
