#include "semantic_slam/semantic_grid/semantic_grid_file.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_grid/small_plan.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/semantic_grid/semantic_grid_builder.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

class SemanticGridFileTest : public testing::Test {
 protected:
  void Write(const OccupancyMap& map, const ObjectMap& objects) {
    const SemanticGridBuilder builder({}, {}, SmallVocabulary());
    WriteSemanticGrid(folder_.path(), builder.Build(map, objects), map, objects,
                      builder.vocabulary());
  }
  std::string Read(const char* name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }

  TemporaryFolder folder_;
};

TEST_F(SemanticGridFileTest, WritesTheCostForMapServer) {
  OccupancyMap map = FreePlan();
  map.width = 2, map.height = 2;
  map.cells = {100, 0, -1, 0};
  map.origin_m = {1.5, -2.0};
  Write(map, ObjectMap());
  EXPECT_EQ(Read("semantic_grid.pgm"), std::string("P5\n2 2\n255\n\xff\x00\x64\x00", 15))
      << "the row of largest y first";
  EXPECT_EQ(Read("semantic_grid.yaml"),
            "image: semantic_grid.pgm\nresolution: 0.100000\norigin: [1.500000, -2.000000, "
            "0.000000]\nmode: raw\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST_F(SemanticGridFileTest, WritesThePicture) {
  Write(FreePlan(), ObjectMapOf({SmallTable()}));
  const cv::Mat picture = cv::imread(folder_ / "semantic_grid.png");
  EXPECT_FALSE(picture.empty());
}

TEST_F(SemanticGridFileTest, RefusesAnEmptyGrid) {
  EXPECT_EQ(MessageOf<InputError>([&] { Write(OccupancyMap(), ObjectMap()); }),
            "the grid is still empty, so there is nothing to write");
}

}  // namespace
}  // namespace semantic_slam
