#include "semantic_slam/evaluation/trajectory_plot.h"

#include <cmath>
#include <filesystem>
#include <iterator>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

const cv::Scalar kEstimateColour(178, 114, 0);
const cv::Scalar kReferenceColour(150, 150, 150);

// Where the two views and the curve below them lie on the page, in parts of its size.
const cv::Rect2d kTopView(0.1, 0.2, 0.37, 0.3);
const cv::Rect2d kTopViewMiddle(0.25, 0.2, 0.06, 0.3);
const cv::Rect2d kSideView(0.6, 0.2, 0.37, 0.3);

int CountPixels(const cv::Mat& plot, const cv::Scalar& colour, const cv::Rect2d& part) {
  const cv::Rect box(cvRound(part.x * plot.cols), cvRound(part.y * plot.rows),
                     cvRound(part.width * plot.cols), cvRound(part.height * plot.rows));
  cv::Mat is_near;
  cv::inRange(plot(box), colour - cv::Scalar::all(2), colour + cv::Scalar::all(2), is_near);
  return cv::countNonZero(is_near);
}

// A level circle of a metre's radius.
Trajectory Circle() {
  Trajectory trajectory;
  for (int i = 0; i <= 60; ++i) {
    const double angle_rad = 2.0 * M_PI * i / 60.0;
    trajectory.push_back({Stamp::FromSeconds(0.1 * i), Rigid3d::Identity()});
    trajectory.back().pose.translation() << std::cos(angle_rad), std::sin(angle_rad), 0.0;
  }
  return trajectory;
}

// Along x at 1 m/s, silent in the middle for as long as given.
Trajectory WithSilence(double silence_s) {
  Trajectory trajectory;
  for (int i = 0; i <= 40; ++i) {
    const double stamp_s = 0.1 * i + (i > 20 ? silence_s : 0.0);
    trajectory.push_back({Stamp::FromSeconds(stamp_s), Rigid3d::Identity()});
    trajectory.back().pose.translation().x() = 0.1 * i + (i > 20 ? 4.0 : 0.0);
  }
  return trajectory;
}

TEST(TrajectoryPlotTest, ShowsBothPathsInBothViews) {
  // Seen from elsewhere; drawn unaligned it would lie outside of the reference.
  Trajectory estimate = Circle();
  for (StampedPose& stamped : estimate) {
    stamped.pose.translation() = 0.9 * stamped.pose.translation() + Eigen::Vector3d(50, 60, 70);
  }
  const cv::Mat plot =
      PlotComparison(Circle(), estimate, CompareTrajectories(Circle(), estimate, {}, {}));
  EXPECT_EQ(plot.type(), CV_8UC3);
  EXPECT_EQ(plot.cols, 1600);
  for (const cv::Rect2d& view : {kTopView, kSideView}) {
    EXPECT_GT(CountPixels(plot, kEstimateColour, view), 300);
    EXPECT_GT(CountPixels(plot, kReferenceColour, view), 100);  // it goes on where the other ends
  }
}

TEST(TrajectoryPlotTest, ShowsAPathWithoutReference) {
  const cv::Mat plot = PlotTrajectory(Circle());
  EXPECT_GT(CountPixels(plot, kEstimateColour, kTopView), 300);
  EXPECT_EQ(CountPixels(plot, kReferenceColour, kTopView), 0);
}

TEST(TrajectoryPlotTest, BreaksTheLineWherePosesAreMissing) {
  EXPECT_GT(CountPixels(PlotTrajectory(WithSilence(0.5)), kEstimateColour, kTopViewMiddle), 50);
  EXPECT_EQ(CountPixels(PlotTrajectory(WithSilence(4.0)), kEstimateColour, kTopViewMiddle), 0);
}

TEST(TrajectoryPlotTest, DrawsASensorThatStoodStill) {
  Trajectory still = Circle();
  for (StampedPose& stamped : still) stamped.pose.translation().setConstant(1e9);
  EXPECT_EQ(PlotTrajectory(still).cols, 1600);
  EXPECT_EQ(PlotTrajectory({still.front()}).cols, 1600);
  EXPECT_EQ(PlotComparison(still, still, CompareTrajectories(still, still, {}, {})).cols, 1600);
}

TEST(TrajectoryPlotTest, DrawsPathsOfAnySize) {
  for (const double scale : {1e-6, 1e3, 1e9}) {
    Trajectory path = Circle();
    for (StampedPose& stamped : path) stamped.pose.translation() *= scale;
    EXPECT_EQ(PlotTrajectory(path).cols, 1600) << scale;
  }
}

TEST(TrajectoryPlotTest, WritesAPng) {
  const TemporaryFolder folder;
  const cv::Mat plot = PlotTrajectory(Circle());
  const std::string path = folder / "new/plot.png";
  WritePlot(plot, path);
  const cv::Mat read = cv::imread(path, cv::IMREAD_COLOR);
  ASSERT_EQ(read.size(), plot.size());
  EXPECT_EQ(cv::norm(read, plot, cv::NORM_INF), 0.0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "new"), {}), 1);
}

TEST(TrajectoryPlotTest, RefusesAnotherExtension) {
  EXPECT_EQ(MessageOf<ConfigError>([] { CheckPlotPath("a.jpg"); }),
            "plot = a.jpg, but must end in .png");
  EXPECT_EQ(MessageOf<ConfigError>([] { WritePlot(cv::Mat(2, 2, CV_8UC3), "plot"); }),
            "plot = plot, but must end in .png");
  EXPECT_EQ(MessageOf<ConfigError>([] { CheckPlotPath("a.b/plot.png"); }), "");
}

TEST(TrajectoryPlotTest, NamesAPathThatCannotBeWritten) {
  const TemporaryFolder folder;
  folder.Write("file", "not a folder");
  const std::string path = folder / "file/plot.png";
  const cv::Mat plot(2, 2, CV_8UC3, cv::Scalar::all(0));
  ExpectOneLineWith(MessageOf<InputError>([&] { WritePlot(plot, path); }),
                    {"cannot write", path.c_str()});
}

}  // namespace
}  // namespace semantic_slam
