#include "semantic_slam/evaluation/box_tracks.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(BoxTracksTest, ReadsWhatTheMotChallengeWrites) {
  const TemporaryFolder folder;
  const auto boxes = ReadBoxTracks(folder.Write(
      "gt.txt", "2,7,10.5,20,30,40,1,-1,-1,-1\n\n1,-1,1,2,3,4,0.25,-3.1,16.3,0.4\r\n"));
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].frame, 1);
  EXPECT_EQ(boxes[0].id, -1);
  EXPECT_DOUBLE_EQ(boxes[0].confidence, 0.25);
  EXPECT_EQ(boxes[1].id, 7);
  EXPECT_EQ(boxes[1].box, cv::Rect2d(10.5, 20, 30, 40));
}

TEST(BoxTracksTest, ReadsWhatItWrites) {
  const TemporaryFolder folder;
  WriteBoxTracks(folder / "out.txt", {{1, 3, {1.25, 2.5, 3.75, 4}, 0.5}, {2, 3, {-1, 0, 5, 6}, 1}});
  const auto boxes = ReadBoxTracks(folder / "out.txt");
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].box, cv::Rect2d(1.25, 2.5, 3.75, 4));
  EXPECT_DOUBLE_EQ(boxes[0].confidence, 0.5);
  EXPECT_EQ(boxes[1].frame, 2);
}

TEST(BoxTracksTest, AnythingElseIsRefusedWithFileAndLine) {
  const TemporaryFolder folder;
  for (const char* bad :
       {"1,2,3", "1 1 1 2 3 4 1", "1,1,x,2,3,4,1", "0,1,1,2,3,4,1", "2000000000,1,1,2,3,4,1",
        "1,1,1,2,-3,4,1", "1,1,nan,2,3,4,1", "1,1,1e400,2,3,4,1"}) {
    const std::string path = folder.Write("bad.txt", std::string("1,1,1,2,3,4,1\n") + bad + "\n");
    ExpectOneLineWith(MessageOf<InputError>([&] { ReadBoxTracks(path); }),
                      {"bad.txt:2", "frame,id"});
  }
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadBoxTracks(folder / "none.txt"); }),
                    {"none.txt"});
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadBoxTracks(folder.path()); }), {"cannot"});
  EXPECT_TRUE(ReadBoxTracks(folder.Write("empty.txt", "")).empty());
}

}  // namespace
}  // namespace semantic_slam
