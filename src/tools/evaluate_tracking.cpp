// Scores tracked boxes against ground truth, as the MOTChallenge does.

#include <cstdlib>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "semantic_slam/evaluation/box_tracking_score.h"
#include "semantic_slam/evaluation/box_tracks.h"
#include "tools/command_line.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Scores tracked boxes against ground truth: MOTA, IDF1 and HOTA in percent. Both files are in "
    "the\n"
    "MOTChallenge's format, \"frame,id,left,top,width,height,confidence,...\" per line; boxes of "
    "the\n"
    "ground truth with confidence 0 do not count.";

int EvaluateTracking(CommandLine& command_line) {
  std::string reference, estimate;
  bool json = false;
  command_line.Argument("GT.txt", &reference, "ground truth");
  command_line.Argument("OUT.txt", &estimate, "what to score");
  command_line.Flag("json", &json, "print JSON instead of a table");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  const BoxTrackingScore score = ScoreBoxTracks(ReadBoxTracks(reference), ReadBoxTracks(estimate));
  if (json) {
    std::cout << ToJson(score).dump(2) << '\n';
  } else {
    PrintTable(score, std::cout);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::EvaluateTracking);
}
