#include "semantic_slam/simulation/visible_boxes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "simulation/world_builder.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam {
namespace {

constexpr LabelId kWall = 1, kChair = 3, kTable = 4, kLamp = 9;

// From the origin along x, before a wall at 6 m.
class VisibleBoxesTest : public testing::Test {
 protected:
  VisibleBoxesTest() { builder_.Add(kWall, BoxMesh({6.5f, 0, 0}, {1, 40, 40})); }

  VisibleObjects Find(const VisibleBoxesOptions& options = {}) {
    const std::shared_ptr<const World> world = builder_.Build();
    view_ = SceneRenderer(world).Render(kPose, kCamera, 0.0);
    return VisibleBoxes(options, world, SmallVocabulary())
        .Find(view_, kPose, kCamera, 0.0, Stamp{7});
  }

  const Rigid3d kPose = LookAt({0, 0, 0}, {1, 0, 0});
  const CameraModel kCamera = SmallCamera(96, 72);
  WorldBuilder builder_;
  RenderedView view_;
};

TEST_F(VisibleBoxesTest, AreTheSmallestAroundEveryObject) {
  builder_.Add(kChair, BoxMesh({3, 1, 0.3f}, {0.5f, 0.5f, 0.8f}));
  builder_.Add(kTable, BoxMesh({3, -1, 0}, {0.8f, 1.2f, 0.5f}));
  const VisibleObjects found = Find();
  EXPECT_EQ(found.detections.stamp, Stamp{7});
  EXPECT_EQ(found.detections.image_size, cv::Size(96, 72));
  EXPECT_NO_THROW(CheckDetections(found.detections, SmallVocabulary()));
  ASSERT_EQ(found.instances, (std::vector<InstanceId>{2, 3})) << "the wall has no box";
  for (std::size_t i = 0; i < 2; ++i) {
    const DetectedBox& box = found.detections.boxes[i];
    EXPECT_EQ(box.confidence, 1.0f);
    const cv::Rect pixels = cv::boundingRect(view_.instances == found.instances[i]);
    EXPECT_EQ(box.box, cv::Rect2f(pixels.x - 0.5f, pixels.y - 0.5f, pixels.width, pixels.height));
    cv::Mat labels = view_.labels.clone();
    labels.setTo(box.label, view_.instances != found.instances[i]);
    EXPECT_EQ(cv::countNonZero(labels != box.label), 0) << "label and box disagree";
  }
}

TEST_F(VisibleBoxesTest, ExceptAroundStructureAndTheUnknown) {
  builder_.Add(kLamp, BoxMesh({3, 1, 0}, {0.5f, 0.5f, 0.5f})).is_structure = true;
  builder_.Add(kUnknownLabel, BoxMesh({3, -1, 0}, {0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(Find().instances.empty());
}

TEST_F(VisibleBoxesTest, ExceptAroundThingsTooSmallToSee) {
  builder_.Add(kChair, BoxMesh({3, 0, 0}, {0.1f, 0.1f, 0.1f}));  // some 2 x 2 pixels
  EXPECT_TRUE(Find().instances.empty());
  VisibleBoxesOptions options;
  options.min_pixels = 1;
  EXPECT_EQ(Find(options).instances.size(), 1u);
}

TEST_F(VisibleBoxesTest, ExceptAroundWhatIsNearlyHidden) {
  builder_.Add(kChair, BoxMesh({3, 0, 0}, {0.1f, 2, 2}));
  builder_.Add(kTable, BoxMesh({2, 0.2f, 0}, {0.1f, 1.4f, 2}));  // leaves a strip of it
  VisibleBoxesOptions options;
  options.min_visible_share = 0.5;
  EXPECT_EQ(Find(options).instances, (std::vector<InstanceId>{3}));
  options.min_visible_share = 0.1;
  EXPECT_EQ(Find(options).instances, (std::vector<InstanceId>{2, 3}));
}

TEST_F(VisibleBoxesTest, WhatTheImagesEdgeCutsIsNotHidden) {
  builder_.Add(kChair, BoxMesh({3, 3.4f, 0}, {0.1f, 2, 2}));  // most of it is out of the view
  VisibleBoxesOptions options;
  options.min_visible_share = 0.9;
  EXPECT_EQ(Find(options).instances.size(), 1u);
}

TEST_F(VisibleBoxesTest, TellWhichShareOfTheObjectIsVisible) {
  builder_.Add(kChair, BoxMesh({3, 0.9f, 0}, {0.01f, 0.8f, 0.8f}));
  builder_.Add(kChair, BoxMesh({3, -0.9f, 0}, {0.01f, 0.8f, 0.8f}));
  builder_.Add(kTable, BoxMesh({2.9f, -1.1f, 0}, {0.01f, 0.4f, 2.0f}));  // before half of that
  const VisibleObjects found = Find();
  ASSERT_EQ(found.instances, (std::vector<InstanceId>{2, 3, 4}));
  // A chair is some 20 pixels wide; which pixels lie on edges is left to rounding.
  EXPECT_NEAR(found.visible_shares[0], 1.0f, 0.05f);
  EXPECT_NEAR(found.visible_shares[1], 0.5f, 0.08f);
}

TEST_F(VisibleBoxesTest, WhatLeavesTheImageIsNotVisible) {
  const double half_width = 3.0 * 0.5 * 96 / kCamera.intrinsics().fx_px;  // of the view, at 3 m
  builder_.Add(kChair, BoxMesh({3, static_cast<float>(half_width), 0}, {0.01f, 2, 1}));
  const VisibleObjects found = Find();
  ASSERT_EQ(found.instances.size(), 1u);
  EXPECT_NEAR(found.visible_shares[0], 0.5f, 0.05f);
}

TEST_F(VisibleBoxesTest, AnEmptyViewHasNone) {
  EXPECT_TRUE(Find().detections.boxes.empty());
}

TEST_F(VisibleBoxesTest, RefusesOptionsOutOfRange) {
  VisibleBoxesOptions options;
  options.min_visible_share = 2.0;
  EXPECT_NE(MessageOf<ConfigError>([&] { Find(options); }).find("min_visible_share"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
