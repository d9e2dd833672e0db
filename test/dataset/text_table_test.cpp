#include "semantic_slam/dataset/text_table.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(TextTableTest, SkipsCommentsAndBlankLinesAndTakesWindowsLineEnds) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("list.txt", "# comment\n\n1.5  a.png\r\n\t2.25\tb.png\n# end");
  const auto rows = ReadTextTable(path, 1, "stamp filename");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].stamp.ns, 1'500'000'000);
  EXPECT_EQ(rows[0].fields[0], "a.png");
  EXPECT_EQ(rows[1].fields[0], "b.png");
  EXPECT_EQ(rows[1].line, 4);
}

TEST(TextTableTest, NamesFileAndLineOfALineThatIsSomethingElse) {
  const TemporaryFolder folder;
  for (const char* bad : {"garbage", "1.5", "1.5 a.png more", "a.png 1.5", "-1 a.png"}) {
    const std::string path = folder.Write("list.txt", std::string("# first\n1.0 a.png\n") + bad);
    EXPECT_EQ(MessageOf<InputError>([&] { ReadTextTable(path, 1, "stamp filename"); }),
              path + ":3: expected 'stamp filename', found '" + bad + "'");
  }
}

TEST(TextTableTest, QuotesOnlyTheStartOfALongLine) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("list.txt", std::string(100'000, 'x'));
  EXPECT_LT(MessageOf<InputError>([&] { ReadTextTable(path, 1, "stamp filename"); }).size(), 250u);
}

TEST(TextTableTest, NamesAFileThatIsMissingOrAFolder) {
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf<InputError>([&] { ReadTextTable(folder / "no.txt", 1, ""); }),
            "cannot open " + (folder / "no.txt"));
  EXPECT_NE(MessageOf<InputError>([&] { ReadTextTable(folder.path(), 1, ""); }), "");
}

}  // namespace
}  // namespace semantic_slam
