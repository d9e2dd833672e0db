#include "semantic_slam/common/scratch_file.h"

#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

TEST(ScratchFileTest, GivesBackWhatWasAppended) {
  ScratchFile file("");
  const std::string first = "first", second(100000, 'x');
  EXPECT_EQ(file.Append(first.data(), first.size()), 0u);
  EXPECT_EQ(file.Append(second.data(), second.size()), first.size());
  EXPECT_EQ(file.size(), first.size() + second.size());
  std::string read(second.size(), ' ');
  file.Read(first.size(), read.data(), read.size());
  EXPECT_EQ(read, second);
}

TEST(ScratchFileTest, LeavesNothingInItsFolder) {
  const std::string folder = testing::TempDir() + "/scratch_file_test";
  std::filesystem::create_directory(folder);
  ScratchFile file(folder);
  file.Append("x", 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(ScratchFileTest, NamesAFolderThatIsNotThere) {
  ExpectOneLineWith(MessageOf<InputError>([] { ScratchFile("/no/such/folder"); }),
                    {"/no/such/folder", "No such file"});
}

TEST(ScratchFileTest, RefusesToReadWhatIsNotThere) {
  ScratchFile file("");
  file.Append("abc", 3);
  char bytes[8];
  EXPECT_NE(MessageOf<InputError>([&] { file.Read(1, bytes, 8); }), "");
}

}  // namespace
}  // namespace semantic_slam
