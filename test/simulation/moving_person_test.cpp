// Localization in a room through which somebody walks, against the same flight through an empty
// one.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/evaluation/alignment.h"
#include "semantic_slam/evaluation/association.h"
#include "semantic_slam/evaluation/trajectory_error.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam/simulation/camera_path.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "testing/world_text.h"

namespace semantic_slam {
namespace {

constexpr LabelId kPerson = 31;
constexpr Stamp kStart{100'000'000'000};
constexpr std::size_t kImages = 166;

constexpr char kRoom[] =
    "rooms:\n"
    "  - {name: room, from: [0, 0], to: [5, 4], floor: {pattern: parquet}, walls: {pattern: "
    "brick}}\n"
    "furniture:\n"
    "  - {kind: table, name: table, at: [2.2, 1.0], yaw_deg: 90}\n"
    "  - {kind: book_stack, on: table, at: [0.1, 0.2]}\n"
    "  - {kind: table, name: table2, at: [4.2, 2.4], yaw_deg: 90}\n"
    "  - {kind: chair, name: chair, at: [2.0, 2.9], yaw_deg: -90}\n"
    "  - {kind: bookshelf, wall: room/north, along_m: 2.0}\n"
    "  - {kind: bookshelf, wall: room/east, along_m: 0.8}\n"
    "  - {kind: poster, wall: room/east, along_m: 2.0, z_m: 1.0, size_m: [0.004, 0.7, 1.0]}\n"
    "  - {kind: poster, wall: room/south, along_m: 3.0, z_m: 1.0, size_m: [0.004, 0.7, 1.0]}\n"
    "  - {kind: plant, at: [2.6, 0.5]}\n"
    "  - {kind: ceiling_lamp, at: [2, 1.5]}\n";
constexpr char kWalker[] =
    "  - {kind: person, walk: {corners: [[2.9, 3.4], [2.9, 0.8]], speed_mps: 0.8}}\n";

Tour ShortTour() {
  Tour tour;
  for (const Eigen::Vector4d& at :
       {Eigen::Vector4d(0.7, 1.3, 1.2, 0), Eigen::Vector4d(0.8, 2.0, 1.3, 10),
        Eigen::Vector4d(0.6, 2.5, 1.1, -10), Eigen::Vector4d(0.8, 1.5, 1.2, 5)}) {
    Waypoint waypoint;
    waypoint.position_m = at.head<3>();
    waypoint.yaw_rad = at.w() * M_PI / 180.0;
    tour.waypoints.push_back(waypoint);
  }
  return tour;
}

enum class Labels { kNone, kOfTheImage, kOfAnEarlierImage };

// Localization on the tour, with what it is told of the images.
class Run {
 public:
  Run(const SimulatedCamera& camera, Labels labels, const LocalizationOptions& options)
      : localization_(options, std::make_shared<const CameraModel>(camera.model().intrinsics()),
                      MappingMode::kInline),
        labels_(labels) {}

  void Track(const SimulatedImage& image) {
    const LabelImage shown{image.measured.stamp, image.truth.labels, {kPerson}};
    if (labels_ == Labels::kOfTheImage) localization_.AddLabels(shown);
    if (labels_ == Labels::kOfAnEarlierImage && images_ % 3 == 0) {
      if (earlier_) {
        EXPECT_EQ(localization_.AddLabels(*earlier_), LabelImageFate::kUsed);
      }
      earlier_ = shown;
    }
    recorder_.Add(localization_.Track(image.measured));
    ++images_;
  }

  // Root mean square of the trajectory's error [m].
  double Ate(const Trajectory& truth) const {
    EXPECT_EQ(recorder_.tracked(), truth.size());
    const auto matches =
        AssociateTrajectories(truth, recorder_.Corrected(localization_.keyframe_graph()), {});
    return Summarise(ComputeAbsoluteErrors(matches, AlignTrajectories(matches)).position_m).rmse;
  }

 private:
  VisualLocalization localization_;
  const Labels labels_;
  TrajectoryRecorder recorder_;
  std::optional<LabelImage> earlier_;  // a network's answer, 0.1 s later
  std::size_t images_ = 0;
};

struct RunSettings {
  Labels labels = Labels::kNone;
  LocalizationOptions options = {};
};

// The errors [m] of runs on one flight through a world: it is rendered once for all of them.
std::vector<double> AtesIn(const std::string& world, const std::vector<RunSettings>& settings) {
  const auto renderer =
      std::make_shared<const SceneRenderer>(std::make_shared<const World>(WorldText().Load(world)));
  const SimulatedCamera camera(renderer, {320, 240, 240.0, 240.0, 159.5, 119.5, {}});
  Trajectory truth = FlyTour(ShortTour(), {}, kStart).T_world_camera;
  truth.resize(std::min(truth.size(), kImages));
  std::vector<std::unique_ptr<Run>> runs;
  for (const RunSettings& run : settings) {
    runs.push_back(std::make_unique<Run>(camera, run.labels, run.options));
  }
  for (const StampedPose& at : truth) {
    const SimulatedImage image =
        camera.Capture(at.pose, at.stamp, SecondsBetween(kStart, at.stamp));
    for (const auto& run : runs) run->Track(image);
  }
  std::vector<double> ates_m;
  for (const auto& run : runs) ates_m.push_back(run->Ate(truth));
  return ates_m;
}

// What a person in view may cost: half as much again as without.
constexpr double kMaxRatio = 1.5;

TEST(MovingPersonTest, NeitherWithNorWithoutSemanticsThePersonCostsMuch) {
  const double empty_m = AtesIn(kRoom, {RunSettings()}).front();
  RunSettings careless;
  careless.options.moving.moving_parts.enabled = false;
  const std::vector<double> ates_m =
      AtesIn(std::string(kRoom) + kWalker,
             {careless, RunSettings(), {Labels::kOfTheImage}, {Labels::kOfAnEarlierImage}});
  const double careless_m = ates_m[0], geometry_m = ates_m[1];
  const double semantics_m = ates_m[2], late_m = ates_m[3];
  RecordProperty("ate_empty_m", std::to_string(empty_m));
  RecordProperty("ate_careless_m", std::to_string(careless_m));
  RecordProperty("ate_geometry_m", std::to_string(geometry_m));
  RecordProperty("ate_semantics_m", std::to_string(semantics_m));
  RecordProperty("ate_late_semantics_m", std::to_string(late_m));
  EXPECT_GT(careless_m, 3.0 * empty_m) << "this person is in nobody's way";
  EXPECT_LT(geometry_m, kMaxRatio * empty_m);
  EXPECT_LT(semantics_m, kMaxRatio * empty_m);
  EXPECT_LT(late_m, kMaxRatio * empty_m);
}

}  // namespace
}  // namespace semantic_slam
