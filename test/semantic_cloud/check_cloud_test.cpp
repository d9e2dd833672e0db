#include "semantic_slam/semantic_cloud/check_cloud.h"

#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

const LabelVocabulary kVocabulary({{0, "unknown", {}}, {3, "chair", {}}});

SemanticCloud Cloud() {
  SemanticCloud cloud;
  cloud.vocabulary_hash = kVocabulary.hash();
  cloud.points.assign(3, {Eigen::Vector3f(1, 2, 3), {1, 2, 3}, {3, 0, 0}, {0.5f, 0.3f, 0.2f}});
  return cloud;
}

std::string Refusal(const SemanticCloud& cloud) {
  return MessageOf<InputError>([&] { CheckSemanticCloud(cloud, kVocabulary); });
}

TEST(CheckCloudTest, PassesWhatIsRight) {
  EXPECT_EQ(Refusal(Cloud()), "");
  SemanticCloud empty = Cloud();
  empty.points.clear();
  EXPECT_EQ(Refusal(empty), "");
}

TEST(CheckCloudTest, TellsWhatItHasSeen) {
  SemanticCloud cloud = Cloud();
  cloud.points[1].position = {-4, 5, 1};
  const CloudContents contents = CheckSemanticCloud(cloud, kVocabulary);
  LabelMask labels;
  labels.set(0);
  labels.set(3);
  EXPECT_EQ(contents.labels, labels);
  EXPECT_EQ(contents.around_m.min(), Eigen::Vector3f(-4, 0, 0));  // with the camera
  EXPECT_EQ(contents.around_m.max(), Eigen::Vector3f(1, 5, 3));
}

TEST(CheckCloudTest, RefusesAnotherVocabulary) {
  SemanticCloud cloud = Cloud();
  cloud.vocabulary_hash ^= 1;
  ExpectOneLineWith(Refusal(cloud),
                    {"another label set", std::to_string(kVocabulary.hash()).c_str()});
}

TEST(CheckCloudTest, RefusesALabelThatIsNotThere) {
  SemanticCloud cloud = Cloud();
  cloud.points[1].labels[2] = 7;
  ExpectOneLineWith(Refusal(cloud), {"label id 7 is not in the vocabulary"});
}

TEST(CheckCloudTest, RefusesConfidencesThatAreNoProbabilities) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -0.1f,
        1.1f, 0.6f /* with 0.3 and 0.2 more than 1 */}) {
    SemanticCloud cloud = Cloud();
    cloud.points[2].confidences[0] = bad;
    ExpectOneLineWith(Refusal(cloud), {"confidence"});
  }
}

TEST(CheckCloudTest, RefusesAPositionThatIsNotFinite) {
  SemanticCloud cloud = Cloud();
  cloud.points[0].position.y() = std::numeric_limits<float>::quiet_NaN();
  ExpectOneLineWith(Refusal(cloud), {"not finite"});
}

}  // namespace
}  // namespace semantic_slam
