// Writes a semantic map in the formats of other programs.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/map_export.h"
#include "semantic_slam/octree/map_picture.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "tools/command_line.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Writes a semantic map (semantic_map.ot, as octomap_node and replay leave it) in the format "
    "that\n"
    "OUT's ending names:\n"
    "  .ot   ColorOcTree, for octovis and every other program of OctoMap's\n"
    "  .bt   occupied or free, for planners\n"
    "  .ply  a point per occupied voxel, with colour, label and probability\n"
    "  .pcd  the same for PCL\n"
    "  .png  the map from above";

struct Arguments {
  std::string in;
  std::string out;
  std::string colour = "class";
};

void Convert(const Arguments& arguments, const LabelledTree& map) {
  const ColourMode mode = ColourModeFromName(arguments.colour);
  const VoxelColours colours(mode, map.vocabulary);
  const std::string format = std::filesystem::path(arguments.out).extension().string();
  if (format == ".ot") {
    WriteColourTree(arguments.out, *map.tree, colours);
  } else if (format == ".bt") {
    WriteBinaryTree(arguments.out, *map.tree);
  } else if (format == ".ply") {
    WritePointCloud(arguments.out, *map.tree, colours);
  } else if (format == ".pcd") {
    WritePcd(arguments.out, *map.tree, colours);
  } else if (format == ".png") {
    MapPictureOptions options;
    options.colour_mode = mode;
    WriteMapFromAbove(arguments.out, *map.tree, map.vocabulary, options);
  } else {
    throw ConfigError("OUT = " + arguments.out + ", but must end in .ot, .bt, .ply, .pcd or .png");
  }
}

int OctreeConvert(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("MAP.ot", &arguments.in, "a semantic map");
  command_line.Argument("OUT", &arguments.out, "what to write");
  command_line.Option("colour", "MODE", &arguments.colour, "class, rgb, or height");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  const LabelledTree map = ReadLabelledTree(arguments.in);
  std::error_code not_there_yet;
  if (std::filesystem::equivalent(arguments.in, arguments.out, not_there_yet)) {
    throw ConfigError("OUT = " + arguments.out + " is MAP.ot itself; its labels would be lost");
  }
  Convert(arguments, map);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::OctreeConvert);
}
