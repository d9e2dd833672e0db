#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "semantic_slam/common/check.h"
#include "testing/room_sequence.h"
#include "tools/command_line.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Renders a small textured room as a hand-held RGB-D camera sees it and writes a folder in the\n"
    "format of the TUM RGB-D benchmark. Input for trying things where no recording is at hand.";

int RenderTexturedRoom(CommandLine& command_line) {
  std::string folder;
  double seconds = 6.0;
  std::uint64_t seed = 1;
  command_line.Argument("OUT_DIR", &folder, "folder to write; made if it is not there");
  command_line.Option("seconds", "S", &seconds, "length at 30 images/s");
  command_line.Option("seed", "N", &seed, "of the pictures on the walls, and of the noise");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--seconds", seconds, 0.1, 3600.0);
  TexturedRoomOptions options;
  options.seed = seed;
  std::optional<ProgressBar> progress;
  const auto show_progress = [&](std::size_t done, std::size_t all) {
    if (!progress) progress.emplace("rendering", all);
    progress->Update(done);
  };
  WriteRoomSequence(folder, seconds, options, show_progress);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::RenderTexturedRoom);
}
