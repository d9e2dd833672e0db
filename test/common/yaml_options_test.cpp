#include "semantic_slam/common/yaml_options.h"

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

struct DemoOptions {
  double max_depth_m = 5.0;
  int stride_px = 2;
  bool enabled = true;
  std::string name = "demo";

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_depth_m", self.max_depth_m, 0.1, 100.0);
    visit("stride_px", self.stride_px, 1, 64);
    visit("enabled", self.enabled);
    visit("name", self.name);
  }
};

struct Branch {
  DemoOptions near;
  DemoOptions far;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("near", self.near);
    visit_group("far", self.far);
  }
};

class YamlOptionsTest : public testing::Test {
 protected:
  DemoOptions Read(const std::string& yaml) {
    const std::string path = folder_.Write("demo.yaml", yaml);
    YamlReader file(LoadYamlMap(path), path);
    DemoOptions options;
    file.ReadOptions("demo", options);
    file.Finish();
    return options;
  }

  // Without the folder's name.
  std::string ErrorOf(const std::string& yaml) {
    std::string message = MessageOf<ConfigError>([&] { Read(yaml); });
    const std::size_t at = message.find(folder_.path());
    return at == std::string::npos ? message : message.erase(at, folder_.path().size() + 1);
  }

  TemporaryFolder folder_;
};

TEST_F(YamlOptionsTest, DefaultsStayWhereTheFileSaysNothing) {
  const DemoOptions options = Read("demo:\n  stride_px: 4\n");
  EXPECT_EQ(options.stride_px, 4);
  EXPECT_EQ(options.max_depth_m, 5.0);
  EXPECT_EQ(Read("demo:\n").stride_px, 2);
  EXPECT_EQ(Read("{}").stride_px, 2);
}

TEST_F(YamlOptionsTest, ReadsEveryType) {
  const DemoOptions options =
      Read("demo: {max_depth_m: 4, stride_px: 1, enabled: false, name: a b}\n");
  EXPECT_EQ(options.max_depth_m, 4.0);
  EXPECT_FALSE(options.enabled);
  EXPECT_EQ(options.name, "a b");
}

TEST_F(YamlOptionsTest, NamesFileLineAndKeyOfAnUnknownKey) {
  EXPECT_EQ(ErrorOf("demo:\n  stride_px: 1\n  max_dept_m: 4\n"),
            "demo.yaml:3: unknown key demo/max_dept_m, expected one of: "
            "enabled, max_depth_m, name, stride_px");
  EXPECT_EQ(ErrorOf("demo: {}\nother: 1\n"),
            "demo.yaml:2: unknown key other, expected one of: demo");
}

TEST_F(YamlOptionsTest, RefusesAnotherType) {
  EXPECT_EQ(ErrorOf("demo:\n  stride_px: many\n"),
            "demo.yaml:2: demo/stride_px = many has the wrong type");
  EXPECT_EQ(ErrorOf("demo:\n  stride_px: 1.5\n"),
            "demo.yaml:2: demo/stride_px = 1.5 has the wrong type");
  EXPECT_EQ(ErrorOf("demo: 3\n"), "demo.yaml:1: demo must be a mapping");
}

TEST_F(YamlOptionsTest, NamesTheOptionThatIsOutOfRange) {
  EXPECT_EQ(ErrorOf("demo:\n  stride_px: 0\n"),
            "demo.yaml: demo/stride_px = 0, but must be in [1, 64]");
  EXPECT_EQ(ErrorOf("demo:\n  max_depth_m: .nan\n"),
            "demo.yaml: demo/max_depth_m = nan, but must be in [0.1, 100]");
}

TEST_F(YamlOptionsTest, RefusesAKeyGivenTwice) {
  ExpectOneLineWith(ErrorOf("demo:\n  stride_px: 1\n  stride_px: 2\n"),
                    {"demo.yaml:3: key demo/stride_px appears twice"});
}

TEST_F(YamlOptionsTest, RefusesWhatIsNotYamlOrNotAMapping) {
  ExpectOneLineWith(ErrorOf("demo: [1, 2\n"), {"demo.yaml:", "not valid YAML"});
  ExpectOneLineWith(ErrorOf("- 1\n"), {"demo.yaml", "expected a mapping"});
  ExpectOneLineWith(ErrorOf(""), {"demo.yaml", "expected a mapping"});
}

TEST_F(YamlOptionsTest, NamesAMissingFile) {
  EXPECT_EQ(MessageOf<ConfigError>([] { LoadYamlMap("/nowhere/a.yaml"); }),
            "cannot open configuration file /nowhere/a.yaml");
  ExpectOneLineWith(MessageOf<ConfigError>([&] { LoadYamlMap(folder_.path()); }),
                    {folder_.path().c_str()});
}

TEST_F(YamlOptionsTest, RefusesAValueWhereItStands) {
  const YamlReader reader(YAML::Load("width: 2\nanchors:\n- [1, 2]\n- [3]\n"), "demo.yaml", "head");
  EXPECT_EQ(MessageOf<ConfigError>([&] { reader.Refuse("width", "even and large"); }),
            "demo.yaml:1: head/width = 2, but must be even and large");
  ExpectOneLineWith(MessageOf<ConfigError>([&] { reader.Refuse("anchors", "pairs"); }),
                    {"demo.yaml:3: head/anchors = ", ", but must be pairs"});
}

TEST_F(YamlOptionsTest, NamesAMissingKey) {
  YamlReader reader(YAML::Load("{}"), "demo.yaml", "camera");
  EXPECT_EQ(MessageOf<ConfigError>([&] { reader.Require<int>("width_px"); }),
            "demo.yaml: missing key camera/width_px");
}

TEST(ReadOptionGroupsTest, FillsEveryGroupAndRefusesOthers) {
  Branch branch;
  YamlReader file(YAML::Load("branch: {near: {stride_px: 3}}\n"), "demo.yaml");
  ReadOptionGroups(file, "branch", branch);
  EXPECT_EQ(branch.near.stride_px, 3);
  EXPECT_EQ(branch.far.stride_px, DemoOptions().stride_px);  // the file says nothing of it

  YamlReader wrong(YAML::Load("branch: {middle: {stride_px: 3}}\n"), "demo.yaml");
  ExpectOneLineWith(MessageOf<ConfigError>([&] { ReadOptionGroups(wrong, "branch", branch); }),
                    {"demo.yaml:1: unknown key branch/middle", "far, near"});
}

TEST_F(YamlOptionsTest, ReadsAListOfMappings) {
  const std::string path = folder_.Write("list.yaml", "rooms:\n  - a: 1\n  - a: 2\nother: [1]\n");
  YamlReader file(LoadYamlMap(path), path);
  std::vector<YamlReader> rooms = file.Entries("rooms");
  ASSERT_EQ(rooms.size(), 2u);
  EXPECT_EQ(rooms[1].Require<int>("a"), 2);
  EXPECT_TRUE(file.Entries("none").empty());
  EXPECT_EQ(MessageOf<ConfigError>([&] { file.Entries("other"); }),
            path + ":4: other/0 must be a mapping");
  EXPECT_EQ(MessageOf<ConfigError>([&] { rooms[1].Require<int>("b"); }),
            path + ": missing key rooms/1/b");
  EXPECT_EQ(MessageOf<ConfigError>([&] { rooms[1].Complain("too small"); }),
            path + ":3: rooms/1: too small");
}

}  // namespace
}  // namespace semantic_slam
