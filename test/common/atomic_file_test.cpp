#include "semantic_slam/common/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

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

std::size_t FilesIn(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(AtomicFileTest, WritesAndReplacesAndMakesFolders) {
  const TemporaryFolder folder;
  const std::string path = folder / "a/b/file.txt";
  WriteFileAtomically(path, [](std::ostream& out) { out << "old"; });
  WriteFileAtomically(path, [](std::ostream& out) { out << "new"; });
  EXPECT_EQ(Content(path), "new");
  EXPECT_EQ(FilesIn(folder / "a/b"), 1u);
}

TEST(AtomicFileTest, TheOldContentIsThereUntilTheNewIsComplete) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("file.txt", "old");
  WriteFileAtomically(path, [&](std::ostream& out) {
    out << "half" << std::flush;
    EXPECT_EQ(Content(path), "old");
  });
}

TEST(AtomicFileTest, LeavesNothingBehindWhenTheWriterThrows) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("file.txt", "old");
  EXPECT_THROW(WriteFileAtomically(path,
                                   [](std::ostream& out) {
                                     out << "half";
                                     throw std::runtime_error("full");
                                   }),
               std::runtime_error);
  EXPECT_EQ(Content(path), "old");
  EXPECT_EQ(FilesIn(folder.path()), 1u);
}

TEST(AtomicFileTest, LeavesNothingBehindWhenTheStreamFails) {
  const TemporaryFolder folder;
  EXPECT_THROW(WriteFileAtomically(folder / "file.txt",
                                   [](std::ostream& out) { out.setstate(std::ios::badbit); }),
               InputError);
  EXPECT_EQ(FilesIn(folder.path()), 0u);
}

TEST(AtomicFileTest, NamesAPathThatCannotBeWritten) {
  const TemporaryFolder folder;
  folder.Write("file", "not a folder");
  const std::string path = folder / "file/below.txt";
  ExpectOneLineWith(MessageOf<InputError>([&] { WriteFileAtomically(path, [](std::ostream&) {}); }),
                    {"cannot write", path.c_str()});
  const std::string taken = folder / "taken";
  fs::create_directories(taken + "/full");
  ExpectOneLineWith(
      MessageOf<InputError>([&] { WriteFileAtomically(taken, [](std::ostream&) {}); }),
      {"cannot write", taken.c_str()});
  EXPECT_EQ(FilesIn(folder.path()), 2u);
}

TEST(AtomicFileTest, ViaGivesAPathInTheSameFolderWithTheSameExtension) {
  const TemporaryFolder folder;
  const std::string path = folder / "image.png";
  WriteFileAtomicallyVia(path, [&](const std::string& temporary) {
    EXPECT_NE(temporary, path);
    EXPECT_EQ(fs::path(temporary).parent_path(), fs::path(path).parent_path());
    EXPECT_EQ(fs::path(temporary).extension(), ".png");
    std::ofstream(temporary) << "picture";
    return true;
  });
  EXPECT_EQ(Content(path), "picture");
}

TEST(AtomicFileTest, AFileNameWithoutFolderIsInTheWorkingFolder) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  WriteFileAtomically("plain.txt", [](std::ostream& out) { out << "x"; });
  fs::current_path(before);
  EXPECT_EQ(Content(folder / "plain.txt"), "x");
}

}  // namespace
}  // namespace semantic_slam
