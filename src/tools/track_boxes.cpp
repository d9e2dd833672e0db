// Gives detected boxes of a recorded sequence ids that hold over time: thesis section 3.4.1.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "semantic_slam/evaluation/box_tracks.h"
#include "semantic_slam/object_tracking/object_tracker.h"
#include "tools/command_line.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Gives the boxes of DET.txt ids that hold from frame to frame (BoT-SORT, without appearance "
    "and\n"
    "without images), and writes the boxes of confirmed tracks. Both files are in the "
    "MOTChallenge's\n"
    "format, \"frame,id,left,top,width,height,confidence,...\" per line; ids of DET.txt are not "
    "read.";

constexpr std::int64_t kFrameNs = 33'333'333;  // 30 frames a second: the files do not tell

constexpr LabelId kObject = 1;  // these files know one class only

struct Arguments {
  std::string detections;
  std::string out;
  ObjectTrackingOptions tracking;

  // Those of BoT-SORT's paper: its files are what this program is for.
  Arguments() {
    tracking.tracker.high_confidence = 0.6;
    tracking.tracker.new_confidence = 0.7;
    tracking.tracker.max_lost_s = 3600.0;  // frames count, not time
    tracking.tracker.compensate_camera = false;
  }
};

bool ParseArguments(CommandLine& command_line, Arguments& arguments) {
  ObjectTrackerOptions& tracker = arguments.tracking.tracker;
  command_line.Argument("DET.txt", &arguments.detections, "detected boxes with confidences");
  command_line.RequiredOption("out", "OUT.txt", &arguments.out, "tracked boxes with ids");
  command_line.Option("high", "C", &tracker.high_confidence, "boxes above are associated first");
  command_line.Option("low", "C", &tracker.low_confidence, "boxes above may keep a track alive");
  command_line.Option("new", "C", &tracker.new_confidence, "a box needs this to begin a track");
  command_line.Option("match", "COST", &tracker.first_max_cost,
                      "greatest cost 1 - IoU * confidence of a pair");
  command_line.Option("buffer", "N", &tracker.max_lost_images,
                      "after so many frames without a box a track ends");
  return command_line.Parse();
}

std::shared_ptr<const LabelVocabulary> OneClass() {
  LabelClass unknown, object;
  unknown.name = "unknown";
  object.id = kObject;
  object.name = "object";
  return std::make_shared<const LabelVocabulary>(std::vector<LabelClass>{unknown, object});
}

// The smallest image that holds all boxes: the files do not tell its size.
cv::Size ImageSize(const std::vector<BoxInFrame>& boxes) {
  cv::Size2d size(1.0, 1.0);
  for (const BoxInFrame& box : boxes) {
    size.width = std::max(size.width, box.box.x + box.box.width);
    size.height = std::max(size.height, box.box.y + box.box.height);
  }
  constexpr double kMostPx = 100000.0;
  return {static_cast<int>(std::ceil(std::min(size.width, kMostPx))),
          static_cast<int>(std::ceil(std::min(size.height, kMostPx)))};
}

// The boxes of one frame by descending confidence; scores of detectors that are no probabilities
// are taken as 0 or 1.
std::vector<DetectedBox> BoxesOf(const BoxInFrame* begin, const BoxInFrame* end) {
  std::vector<DetectedBox> boxes;
  for (const BoxInFrame* box = begin; box != end; ++box) {
    if (box->box.empty()) continue;
    const auto confidence = static_cast<float>(std::clamp(box->confidence, 0.0, 1.0));
    boxes.push_back({kObject, confidence, cv::Rect2f(box->box)});
  }
  std::stable_sort(boxes.begin(), boxes.end(), [](const DetectedBox& a, const DetectedBox& b) {
    return a.confidence > b.confidence;
  });
  return boxes;
}

void AddConfirmed(const ObjectTracks& tracks, int frame, std::vector<BoxInFrame>& tracked) {
  for (const ObjectTrack& track : tracks.tracks) {
    if (track.state != TrackState::kConfirmed) continue;
    tracked.push_back({frame, static_cast<int>(track.id), cv::Rect2d(track.detection.box),
                       track.detection.confidence});
  }
}

std::vector<BoxInFrame> Track(const std::vector<BoxInFrame>& found,
                              const ObjectTrackingOptions& options) {
  const auto vocabulary = OneClass();
  ObjectTracker tracker(options, vocabulary);
  Detections detections{{}, vocabulary->hash(), ImageSize(found), {}};
  std::vector<BoxInFrame> tracked;
  std::size_t next = 0;
  const int last = found.empty() ? 0 : found.back().frame;
  for (int frame = found.empty() ? 1 : found.front().frame; frame <= last; ++frame) {
    const std::size_t begin = next;
    while (next < found.size() && found[next].frame == frame) ++next;
    detections.stamp = Stamp{frame * kFrameNs};
    detections.boxes = BoxesOf(found.data() + begin, found.data() + next);
    AddConfirmed(tracker.Update(detections, cv::Mat()), frame, tracked);
  }
  return tracked;
}

int TrackBoxes(CommandLine& command_line) {
  Arguments arguments;
  if (!ParseArguments(command_line, arguments)) return EXIT_SUCCESS;
  const std::vector<BoxInFrame> found = ReadBoxTracks(arguments.detections);
  const std::vector<BoxInFrame> tracked = Track(found, arguments.tracking);
  WriteBoxTracks(arguments.out, tracked);
  std::cout << found.size() << " boxes read, " << tracked.size() << " of tracks written to "
            << arguments.out << '\n';
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::TrackBoxes);
}
