#include "semantic_slam/network_evaluation/report_text.h"

#include <limits>
#include <sstream>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(ReportTextTest, WritesNumbersAndShares) {
  EXPECT_EQ(PercentText(0.7812), "78.1 %");
  EXPECT_EQ(PercentText(0.0), "0.0 %");
  EXPECT_EQ(PercentText(kNone), "-");
  EXPECT_EQ(NumberText(12.345, 1), "12.3");
  EXPECT_EQ(NumberText(kNone, 1), "-");
}

TEST(ReportTextTest, AlignsCells) {
  std::ostringstream out;
  PrintTableRow("name", {"1", "22"}, out);
  PrintTableRow("a name that is far too long", {"1", "22"}, out);
  EXPECT_EQ(out.str(),
            "name                               1          22\n"
            "a name that is far too long           1          22\n");
}

}  // namespace
}  // namespace semantic_slam
