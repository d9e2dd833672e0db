#include "semantic_slam/submaps/occupancy_map_file.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

OccupancyMap SmallMap() {
  OccupancyMap map;
  map.resolution_m = 0.1;
  map.origin_m << -1.5, 2.25;
  map.width = 3;
  map.height = 2;
  map.cells = {OccupancyMap::kUnknown, 0, 24, 25, 64, 100};
  return map;
}

// What map_server makes of the files, by its documentation (mode trinary): the first row of the
// picture is the top, p = (255 - grey) / 255; above occupied_thresh 100, below free_thresh 0, else
// -1.
std::vector<int> ReadAsMapServer(const std::string& folder) {
  const YAML::Node yaml = YAML::LoadFile(folder + "/grid.yaml");
  const cv::Mat image =
      cv::imread(folder + "/" + yaml["image"].as<std::string>(), cv::IMREAD_GRAYSCALE);
  std::vector<int> cells;
  for (int v = image.rows - 1; v >= 0; --v) {
    for (int u = 0; u < image.cols; ++u) {
      const double p = (255 - image.at<std::uint8_t>(v, u)) / 255.0;
      cells.push_back(p > yaml["occupied_thresh"].as<double>() ? 100
                      : p < yaml["free_thresh"].as<double>()   ? 0
                                                               : -1);
    }
  }
  return cells;
}

TEST(OccupancyMapFileTest, ComesBackThroughMapServersRules) {
  const TemporaryFolder folder;
  WriteOccupancyMap(folder.path(), SmallMap());
  EXPECT_EQ(ReadAsMapServer(folder.path()), (std::vector<int>{-1, 0, 0, -1, -1, 100}));
  const YAML::Node yaml = YAML::LoadFile(folder.path() + "/grid.yaml");
  EXPECT_EQ(yaml["image"].as<std::string>(), "grid.pgm");
  EXPECT_EQ(yaml["resolution"].as<double>(), 0.1);
  EXPECT_EQ(yaml["origin"].as<std::vector<double>>(), (std::vector<double>{-1.5, 2.25, 0.0}));
  EXPECT_EQ(yaml["negate"].as<int>(), 0);
}

TEST(OccupancyMapFileTest, MakesTheFolderAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string nested = folder.path() + "/a/b";
  WriteOccupancyMap(nested, SmallMap());
  WriteOccupancyMap(nested, SmallMap());
  const auto files = std::distance(std::filesystem::directory_iterator(nested), {});
  EXPECT_EQ(files, 2);
}

TEST(OccupancyMapFileTest, RefusesAnEmptyMap) {
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf<InputError>([&] { WriteOccupancyMap(folder.path(), OccupancyMap()); }),
            "the map is still empty, so there is nothing to write");
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/grid.yaml"));
}

TEST(OccupancyMapFileTest, NamesAFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/file") << "not a folder";
  const std::string below = folder.path() + "/file/map";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteOccupancyMap(below, SmallMap()); }),
                    {"/file/map/grid.pgm"});
}

TEST(OccupancyMapFileTest, ReadsWhatItWrites) {
  const TemporaryFolder folder;
  WriteOccupancyMap(folder.path(), SmallMap(), "floor_plan");
  const OccupancyMap map = ReadOccupancyMap(folder / "floor_plan.yaml");
  EXPECT_EQ(map.resolution_m, 0.1);
  EXPECT_EQ(map.origin_m, SmallMap().origin_m);
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{-1, 0, 0, -1, -1, 100}));
}

TEST(OccupancyMapFileTest, ReadsCostsInModeRaw) {
  const TemporaryFolder folder;
  folder.Write("cost.pgm", std::string("P5\n2 2\n255\n") + '\x00' + '\x37' + '\x64' + '\xff');
  const std::string yaml = folder.Write(
      "cost.yaml", "image: cost.pgm\nresolution: 0.05\norigin: [1, 2, 0]\nmode: raw\n");
  EXPECT_EQ(ReadOccupancyMap(yaml).cells, (std::vector<std::int8_t>{100, -1, 0, 55}));
}

TEST(OccupancyMapFileTest, NamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& yaml) {
    const std::string path = folder.Write("map.yaml", yaml);
    return MessageOf<InputError>([&] { ReadOccupancyMap(path); });
  };
  ExpectOneLineWith(MessageOf<InputError>([&] { ReadOccupancyMap(folder / "none.yaml"); }),
                    {"none.yaml"});
  ExpectOneLineWith(message("image: gone.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"),
                    {"gone.pgm"});
  ExpectOneLineWith(message("image: a.pgm\norigin: [0, 0, 0]\n"), {"map.yaml", "resolution"});
  ExpectOneLineWith(message("image: a.pgm\nresolution: 0\norigin: [0, 0]\n"),
                    {"map.yaml", "resolution"});
  ExpectOneLineWith(message("image: a.pgm\nresolution: 1\norigin: [0]\n"), {"map.yaml", "origin"});
  ExpectOneLineWith(message("image: a.pgm\nresolution: 1\norigin: [0, 0]\nmode: scale\n"),
                    {"map.yaml", "mode", "trinary"});
}

}  // namespace
}  // namespace semantic_slam
