// The parameters of every node: config/ repeats their defaults, docs/ros_api.md lists them all, and
// a wrong one stops the node with a line that names it.
//
// To add a node X_node: give its parameters a VisitGroups() (param_reader.h), add a struct like
// those below to `Nodes`, and a <rosparam> line to node_parameters.test.

#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "semantic_slam_ros/detection_node.h"
#include "semantic_slam_ros/grid_slam_node.h"
#include "semantic_slam_ros/object_mapping_node.h"
#include "semantic_slam_ros/object_tracking_node.h"
#include "semantic_slam_ros/octomap_node.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/segmentation_node.h"
#include "semantic_slam_ros/semantic_cloud_node.h"
#include "semantic_slam_ros/semantic_grid_node.h"
#include "semantic_slam_ros/simulator_parameters.h"
#include "semantic_slam_ros/tracking_node.h"
#include "semantic_slam_ros/waypoint_controller_node.h"

namespace semantic_slam_ros {
namespace {

// kName_node is the program, config/kName.yaml its file, "## kName_node" its section in the docs.
struct Tracking {
  static constexpr char kName[] = "tracking";
  using Parameters = TrackingNodeParameters;
};

struct Segmentation {
  static constexpr char kName[] = "segmentation";
  using Parameters = SegmentationNodeParameters;
};

struct Detection {
  static constexpr char kName[] = "detection";
  using Parameters = DetectionNodeParameters;
};

struct SemanticCloud {
  static constexpr char kName[] = "semantic_cloud";
  using Parameters = SemanticCloudNodeParameters;
};

struct Octomap {
  static constexpr char kName[] = "octomap";
  using Parameters = OctomapNodeParameters;
};

struct GridSlam {
  static constexpr char kName[] = "grid_slam";
  using Parameters = GridSlamNodeParameters;
};

struct ObjectTracking {
  static constexpr char kName[] = "object_tracking";
  using Parameters = ObjectTrackingNodeParameters;
};

struct ObjectMapping {
  static constexpr char kName[] = "object_mapping";
  using Parameters = ObjectMappingNodeParameters;
};

struct SemanticGrid {
  static constexpr char kName[] = "semantic_grid";
  using Parameters = SemanticGridNodeParameters;
};

struct WaypointController {
  static constexpr char kName[] = "waypoint_controller";
  using Parameters = WaypointControllerNodeParameters;
};

struct Simulator {
  static constexpr char kName[] = "simulator";
  using Parameters = SimulatorNodeParameters;
};

using Nodes = testing::Types<
#if __has_include(<embree3/rtcore.h>)  // without it there is no simulator
    Simulator,
#endif
    Tracking, Segmentation, Detection, SemanticCloud, Octomap, GridSlam, ObjectTracking,
                             ObjectMapping, SemanticGrid, WaypointController>;

struct Outcome {
  int status;
  std::string output;
};

Outcome RunProgram(const std::string& node, const std::string& arguments) {
  // A node that has nothing to complain about would run for ever.
  const std::string command = "timeout 30 " SEMANTIC_SLAM_PROGRAM_DIR "/" + node + "_node " +
                              "__name:=" + node + "_under_test " + arguments + " 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 256> buffer;
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) outcome.output += buffer.data();
  outcome.status = WEXITSTATUS(::pclose(pipe));
  ros::param::del("/" + node + "_under_test");
  return outcome;
}

void ExpectFatal(const std::string& node, const std::string& arguments, const std::string& why) {
  const Outcome outcome = RunProgram(node, arguments);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("FATAL"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find(why), std::string::npos) << outcome.output;
}

TEST(TrackingParametersTest, RefusesAnUnknownOneInAGroup) {
  ExpectFatal("tracking", "_tracking/max_featurs:=10",
              "unknown parameter /tracking_under_test/tracking/max_featurs");
}

TEST(TrackingParametersTest, RefusesOneOutOfRange) {
  ExpectFatal("tracking", "_features/pyramid_levels:=0",
              "/tracking_under_test/features/pyramid_levels = 0, but must be in [1, 12]");
}

TEST(TrackingParametersTest, RefusesAPeriodOfDiagnosticsOutOfRange) {
  ExpectFatal("tracking", "_diagnostic_period:=0.0",
              "/tracking_under_test/diagnostic_period = 0, but must be in [0.1, 60]");
}

TEST(TrackingParametersTest, RefusesAnotherType) {
  ExpectFatal("tracking", "_queue_size:=many",
              "/tracking_under_test/queue_size = many, but must be");
}

TEST(TrackingParametersTest, NamesAMissingCalibrationFile) {
  ExpectFatal("tracking", "_camera_config:=/nowhere/camera.yaml", "/nowhere/camera.yaml");
}

TEST(TrackingParametersTest, NamesAMapThatIsNone) {
  ExpectFatal("tracking", "_map_file:=/nowhere/room.map",
              "map_file: cannot open /nowhere/room.map");
  ExpectFatal("tracking", "_map_file:=" SEMANTIC_SLAM_SOURCE_DIR "/config/tracking.yaml",
              "config/tracking.yaml: it is no localization map");
}

TEST(TrackingParametersTest, NamesAClassToLeaveOutThatDoesNotExist) {
  ExpectFatal("tracking",
              "_labels:=" SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml _left_out_classes:=persn",
              "left_out_classes: 'persn' is not in the vocabulary");
}

TEST(GridSlamParametersTest, RefusesAnotherSourceOfTheMap) {
  ExpectFatal("grid_slam", "_map_source:=grid",
              "/grid_slam_under_test/map_source = grid is not available in this version, only "
              "visual is");
  ExpectFatal("grid_slam", "_map_source:=laser",
              "/grid_slam_under_test/map_source = laser, but must be visual");
}

TEST(GridSlamParametersTest, RefusesAnEmptyBand) {
  ExpectFatal("grid_slam", "_scan/band_lower_m:=0.5", "band_lower_m = 0.5, but must be below");
}

#if __has_include(<embree3/rtcore.h>)
TEST(SimulatorParametersTest, RefusesSomebodyElseAtTheControls) {
  ExpectFatal("simulator", "_follow:=nobody",
              "/simulator_under_test/follow = nobody, but must be control, or tour");
  ExpectFatal("simulator", "_follow:=tour", "with a file in ~tour");
}
#endif

// Calls visit(full name, value, range...) for every option of a node.
template <typename Parameters, typename Visitor>
void VisitOptions(const Parameters& parameters, Visitor&& visit) {
  Parameters::VisitGroups(parameters, [&](const std::string& group, const auto& options) {
    using Options = std::decay_t<decltype(options)>;
    const std::string prefix = group.empty() ? "" : group + "/";
    Options::Visit(options, [&](const char* name, const auto& value, const auto&... range) {
      visit(prefix + name, value, range...);
    });
  });
}

template <typename Parameters>
std::vector<std::string> Listed(const Parameters& parameters) {
  std::vector<std::string> lines;
  VisitOptions(parameters, [&](const std::string& name, const auto& value, const auto&...) {
    std::ostringstream line;
    line << name << " = " << value;
    lines.push_back(line.str());
  });
  return lines;
}

// A row of a table of parameters in docs/ros_api.md.
struct Row {
  std::string type;
  std::string default_value;
  std::string range;
};

std::string Trimmed(const std::string& text) {
  const std::size_t start = text.find_first_not_of(' ');
  return start == std::string::npos ? ""
                                    : text.substr(start, text.find_last_not_of(' ') - start + 1);
}

// The parameters in the section of a node, by name without "~".
std::map<std::string, Row> DocumentedParameters(const std::string& node) {
  std::ifstream file(SEMANTIC_SLAM_SOURCE_DIR "/docs/ros_api.md");
  std::map<std::string, Row> rows;
  bool in_section = false, in_parameters = false;
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, 3, "## ") == 0) in_section = line == "## " + node + "_node";
    if (line.compare(0, 2, "##") == 0) in_parameters = in_section && line == "### Parameters";
    if (!in_parameters || line.compare(0, 4, "| `~") != 0) continue;
    std::istringstream cells(line);
    std::string cell, name;
    Row row;
    std::getline(cells, cell, '|');
    std::getline(cells, name, '|');
    for (std::string* into : {&row.type, &row.default_value, &row.range}) {
      std::getline(cells, cell, '|');
      *into = Trimmed(cell);
    }
    name = Trimmed(name);
    rows[name.substr(2, name.size() - 3)] = row;
  }
  return rows;
}

const char* TypeName(bool) {
  return "bool";
}
const char* TypeName(int) {
  return "int";
}
const char* TypeName(double) {
  return "double";
}
const char* TypeName(const std::string&) {
  return "string";
}

void ExpectText(const std::string& text, bool value) {
  EXPECT_EQ(text, value ? "true" : "false");
}
void ExpectText(const std::string& text, const std::string& value) {
  EXPECT_EQ(text, value.empty() ? "(empty)" : value);
}
template <typename Number>
void ExpectText(const std::string& text, Number value) {
  std::istringstream stream(text);
  double number = 0.0;
  EXPECT_TRUE(stream >> number) << "'" << text << "' is no number";
  EXPECT_EQ(number, static_cast<double>(value));
}

void ExpectRange(const std::string& text) {
  EXPECT_EQ(text, "");
}
// The name of another option will do for a limit.
template <typename Number>
void ExpectRange(const std::string& text, Number low, Number high) {
  const std::size_t to = text.find(" to ");
  ASSERT_NE(to, std::string::npos) << "range is '" << text << "'";
  const std::string low_text = text.substr(0, to), high_text = text.substr(to + 4);
  if (std::isalpha(low_text[0]) == 0) ExpectText(low_text, low);
  if (std::isalpha(high_text[0]) == 0) ExpectText(high_text, high);
}

template <typename Node>
class NodeParametersTest : public testing::Test {};
TYPED_TEST_SUITE(NodeParametersTest, Nodes);

TYPED_TEST(NodeParametersTest, AnUnknownOneStopsTheNode) {
  const std::string node = TypeParam::kName;
  ExpectFatal(node, "_no_such_parameter:=1",
              "unknown parameter /" + node + "_under_test/no_such_parameter");
}

TYPED_TEST(NodeParametersTest, LabelsMustBeGiven) {
  bool has_labels = false;
  VisitOptions(typename TypeParam::Parameters(),
               [&](const std::string& name, const auto&...) { has_labels |= name == "labels"; });
  if (!has_labels) GTEST_SKIP() << "it needs none";
  if (std::is_same_v<TypeParam, Tracking>) GTEST_SKIP() << "it does without semantics then";
  const std::string node = TypeParam::kName;
  ExpectFatal(node, "", "/" + node + "_under_test/labels is empty, but must name");
}

TYPED_TEST(NodeParametersTest, FileRepeatsTheDefaults) {
  using Parameters = typename TypeParam::Parameters;
  const ros::NodeHandle file("~documented/" + std::string(TypeParam::kName));
  ASSERT_TRUE(ros::param::has(file.getNamespace()))
      << "node_parameters.test does not load the file";
  EXPECT_EQ(Listed(ReadParameters<Parameters>(file)), Listed(Parameters()));
}

TYPED_TEST(NodeParametersTest, DocumentationListsEachWithTypeDefaultAndRange) {
  std::map<std::string, Row> rows = DocumentedParameters(TypeParam::kName);
  VisitOptions(typename TypeParam::Parameters(),
               [&](const std::string& name, const auto& value, const auto&... range) {
                 SCOPED_TRACE("~" + name);
                 ASSERT_EQ(rows.count(name), 1u) << "not in docs/ros_api.md";
                 EXPECT_EQ(rows[name].type, TypeName(value));
                 ExpectText(rows[name].default_value, value);
                 ExpectRange(rows[name].range, range...);
                 rows.erase(name);
               });
  EXPECT_EQ(rows.count("diagnostic_period"), 1u);
  rows.erase("diagnostic_period");
  for (const auto& [name, row] : rows) ADD_FAILURE() << "docs/ros_api.md lists ~" << name;
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_parameters_test");
  const ros::NodeHandle nh;
  return RUN_ALL_TESTS();
}
