#include "semantic_slam/submaps/grid_slam_options.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

GridSlamOptions Read(const std::string& yaml) {
  YamlReader file(YAML::Load(yaml), "camera.yaml");
  GridSlamOptions options;
  ReadOptionGroups(file, options);
  file.Finish();
  return options;
}

TEST(GridSlamOptionsTest, ReadsItsGroupsAndKeepsDefaults) {
  const GridSlamOptions options =
      Read("scan: {band_lower_m: -0.6}\ngrid_mapper: {match_scans: true}\n");
  EXPECT_EQ(options.scan.band_lower_m, -0.6);
  EXPECT_EQ(options.scan.band_upper_m, ScanBuilderOptions().band_upper_m);
  EXPECT_TRUE(options.grid_mapper.match_scans);
}

TEST(GridSlamOptionsTest, NamesAnUnknownOption) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { Read("submaps: {min_scan: 3}"); }),
                    {"camera.yaml", "submaps/min_scan"});
}

}  // namespace
}  // namespace semantic_slam
