#include "semantic_slam/octree/voxel_view.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

const cv::Vec3b kWhite(255, 255, 255);

class VoxelViewTest : public testing::Test {
 protected:
  VoxelViewTest()
      : tree_(0.1), vocabulary_(SmallVocabulary()), colours_(ColourMode::kClass, *vocabulary_) {
    camera_.width_px = 100;
    camera_.height_px = 80;
    camera_.fx_px = camera_.fy_px = 100.0;
    camera_.cx_px = 49.5;
    camera_.cy_px = 39.5;
  }

  // The camera looks along z, with x to the right and y down.
  cv::Mat Render(const VoxelViewOptions& options = {}) const {
    return RenderVoxels(tree_, colours_, camera_, Rigid3d::Identity(), options);
  }

  SemanticOcTree tree_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
  VoxelColours colours_;
  CameraIntrinsics camera_;
};

TEST_F(VoxelViewTest, AVoxelIsWhereItProjectsTo) {
  AddVoxel(tree_, {0.05, 0.05, 1.05}, 5);  // seen side: x and y from 0 to 0.1 at z = 1
  const cv::Mat view = Render();
  ASSERT_EQ(view.size(), cv::Size(100, 80));
  const cv::Vec3b inside = view.at<cv::Vec3b>(39 + 5, 49 + 5);
  EXPECT_GT(inside[2], 3 * inside[1]);  // a chair's red
  EXPECT_EQ(view.at<cv::Vec3b>(39 + 5, 49 - 2), kWhite);
  EXPECT_EQ(view.at<cv::Vec3b>(39 + 5, 49 + 13), kWhite);
  EXPECT_EQ(view.at<cv::Vec3b>(39 - 2, 49 + 5), kWhite);
}

TEST_F(VoxelViewTest, TheNearerVoxelIsInFront) {
  AddVoxel(tree_, {0.05, 0.05, 1.05}, 5);
  AddVoxel(tree_, {0.05, 0.05, 3.05}, 7);
  const cv::Mat view = Render();
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.cols; ++column) {
      const cv::Vec3b pixel = view.at<cv::Vec3b>(row, column);
      EXPECT_TRUE(pixel == kWhite || pixel[2] > 3 * pixel[1]);  // nothing of the table's orange
    }
  }
}

TEST_F(VoxelViewTest, LeavesOutWhatIsBehindTooNearTooFarOrTooHigh) {
  AddVoxel(tree_, {0.05, 0.05, -1.05}, 5);
  AddVoxel(tree_, {0.05, 0.05, 0.15}, 5);
  AddVoxel(tree_, {0.05, 0.05, 5.05}, 5);
  VoxelViewOptions options;
  options.far_m = 4.0;
  EXPECT_EQ(cv::countNonZero(255 - Render(options).reshape(1)), 0);
  options.far_m = 10.0;
  EXPECT_GT(cv::countNonZero(255 - Render(options).reshape(1)), 0);
  options.max_z_m = 3.0;
  EXPECT_EQ(cv::countNonZero(255 - Render(options).reshape(1)), 0);
}

TEST_F(VoxelViewTest, AnEmptyMapIsWhite) {
  EXPECT_EQ(cv::countNonZero(255 - Render().reshape(1)), 0);
}

}  // namespace
}  // namespace semantic_slam
