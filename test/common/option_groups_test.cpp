#include "semantic_slam/common/option_groups.h"

#include <gtest/gtest.h>

#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

struct Limits {
  int most = 3;
  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("most", self.most, 1, 10);
  }
};

struct Groups {
  Limits first, second;
  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("first", self.first);
    visit_group("second", self.second);
  }
};

TEST(OptionGroupsTest, ReturnsWhatIsValid) {
  const Groups groups;
  EXPECT_EQ(&ValidatedGroups(groups), &groups);
}

TEST(OptionGroupsTest, NamesGroupAndOption) {
  Groups groups;
  groups.second.most = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ValidatedGroups(groups); }),
            "second/most = 0, but must be in [1, 10]");
}

}  // namespace
}  // namespace semantic_slam
