#include "semantic_slam/map/map_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "map/small_maps.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class MapFileTest : public testing::Test {
 protected:
  MapFileTest() { WriteMapFile(path_, map_); }

  std::string Refusal(const std::string& content) const {
    const std::string path = folder_.Write("broken.map", content);
    return MessageOf<InputError>([&] { ReadMapFile(path); });
  }

  std::string Misfit(const CameraIntrinsics& camera, const std::vector<float>& scales) const {
    return MessageOf<InputError>([&] { CheckMapFits(path_, map_, camera, scales); });
  }

  std::size_t FilesInFolder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  const TemporaryFolder folder_;
  const StoredMap map_ = SmallMaps().Stored();
  const std::string path_ = folder_ / "room.map";
};

TEST_F(MapFileTest, TheMapComesBackWhole) {
  EXPECT_TRUE(EncodeMap(ReadMapFile(path_)) == EncodeMap(map_));
  WriteMapFile(folder_ / "again.map", map_);
  EXPECT_TRUE(Content(folder_ / "again.map") == Content(path_)) << "the same map, other bytes";
}

TEST_F(MapFileTest, TellsWhatItIsInItsFirstBytes) {
  EXPECT_EQ(Content(path_).substr(0, 12), std::string("SEMSLAM\n\1\0\0\0", 12));
}

TEST_F(MapFileTest, RefusesWhatIsNotItsOwn) {
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadMapFile(folder_ / "no.map"); }),
                    {"cannot open", "no.map"});
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadMapFile(folder_.path()); }),
                    {"cannot open", folder_.path().c_str()});
  ExpectOneLineWith(Refusal(""), {"broken.map", "no localization map"});
  ExpectOneLineWith(Refusal("# Octomap OcTree file\n"), {"broken.map", "no localization map"});
}

TEST_F(MapFileTest, RefusesAnotherVersion) {
  std::string content = Content(path_);
  content[8] = 2;
  ExpectOneLineWith(Refusal(content), {"broken.map", "version 2, expected 1"});
}

TEST_F(MapFileTest, RefusesAFileThatIsCut) {
  const std::string whole = Content(path_);
  for (const std::size_t size : {std::size_t{9}, std::size_t{23}, std::size_t{24}, std::size_t{200},
                                 whole.size() / 2, whole.size() - 1}) {
    ExpectOneLineWith(Refusal(whole.substr(0, size)), {"broken.map", "cut short"});
  }
}

TEST_F(MapFileTest, RefusesAFileThatIsDamagedAnywhere) {
  const std::string whole = Content(path_);
  for (std::size_t i = 24; i < whole.size(); i += 1009) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    ExpectOneLineWith(Refusal(damaged), {"broken.map", "damaged", "checksum"});
  }
  ExpectOneLineWith(Refusal(whole + "x"), {"damaged"});
}

TEST_F(MapFileTest, RefusesWhatCannotBeInSpiteOfARightChecksum) {
  StoredMap map = map_;
  map.contents.next_keyframe = 0;
  WriteMapFile(folder_ / "impossible.map", map);
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadMapFile(folder_ / "impossible.map"); }),
                    {"impossible.map", "damaged", "keyframe 0 is out of order"});
}

TEST_F(MapFileTest, RefusesToWriteNothing) {
  StoredMap nothing = map_;
  nothing.contents = MapContents();
  const std::string before = Content(path_);
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteMapFile(path_, nothing); }),
                    {"room.map", "there is no map yet"});
  EXPECT_TRUE(Content(path_) == before);
}

TEST_F(MapFileTest, IsWrittenWholeOrNotAtAll) {
  const std::size_t files = FilesInFolder();
  const std::string before = Content(path_);
  fs::create_directory(folder_ / "taken");
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteMapFile(folder_ / "taken", map_); }),
                    {"cannot write", "taken"});
  EXPECT_EQ(FilesInFolder(), files + 1) << "something was left behind";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteMapFile(path_ + "/map", map_); }),
                    {"cannot write", "room.map/map"});
  EXPECT_TRUE(Content(path_) == before);
  WriteMapFile(path_, map_);  // over one that is there
  EXPECT_EQ(FilesInFolder(), files + 1);
  ReadMapFile(path_);
}

TEST_F(MapFileTest, FitsTheCameraAndThePyramidThatItWasMadeWith) {
  EXPECT_EQ(Misfit(map_.camera, map_.scales), "");
  CameraIntrinsics rounded = map_.camera;
  rounded.fx_px += 0.001;
  rounded.distortion = {0.0, 0.0, 0.0, 0.0, 0.0};
  rounded.readout_s = 0.02;
  EXPECT_EQ(Misfit(rounded, map_.scales), "");
}

TEST_F(MapFileTest, RefusesAnotherCameraAndTellsBoth) {
  CameraIntrinsics other = map_.camera;
  other.fx_px = 250.0;
  ExpectOneLineWith(Misfit(other, map_.scales), {"room.map", "fx 260", "fx 250", "320 x 240 px"});
  other = map_.camera;
  other.distortion = {0.1, 0.0, 0.0, 0.0};
  ExpectOneLineWith(Misfit(other, map_.scales), {"distortion []", "distortion [0.1 0 0 0]"});
  other = map_.camera;
  other.width_px = 640;
  EXPECT_NE(Misfit(other, map_.scales), "");
}

TEST_F(MapFileTest, RefusesAnotherPyramid) {
  ExpectOneLineWith(Misfit(map_.camera, {1.0f, 1.5f}),
                    {"room.map", "8 levels", "2 levels up to scale 1.5"});
}

}  // namespace
}  // namespace semantic_slam
