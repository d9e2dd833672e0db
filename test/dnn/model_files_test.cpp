#include "semantic_slam/dnn/model_files.h"

#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

// Sets an environment variable and puts it back.
class ScopedVariable {
 public:
  ScopedVariable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
  }
  ~ScopedVariable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

constexpr char kShared[] = "SEMANTIC_SLAM_SHARED";

TEST(ModelFoldersTest, GoesFromTheExplicitToTheDistant) {
  const ScopedVariable shared(kShared, "/data");
  EXPECT_EQ(ModelFolders("/a/b/c/config/cards/x.yaml", "/mine"),
            (std::vector<std::string>{"/mine", "/a/b/c/config/cards", "/a/b/c/models",
                                      "/data/models", "/a/b/shared/models"}));
}

TEST(ModelFoldersTest, LeavesOutWhatIsNotGiven) {
  const ScopedVariable shared(kShared, nullptr);
  EXPECT_EQ(ModelFolders("/a/b/c/d/x.yaml", ""),
            (std::vector<std::string>{"/a/b/c/d", "/a/b/models", "/a/shared/models"}));
}

TEST(FindModelFileTest, TakesTheFirst) {
  const TemporaryFolder folder;
  folder.Write("second/net.onnx", "");
  const std::string third = folder.Write("third/net.onnx", "");
  const std::vector<std::string> folders{folder / "first", folder / "second", folder / "third"};
  EXPECT_EQ(FindModelFile("net.onnx", folders), folder / "second/net.onnx");
  EXPECT_EQ(FindModelFile(third, folders), third) << "an absolute name is taken as it is";
}

TEST(FindModelFileTest, NamesTheFileAndEveryFolder) {
  const TemporaryFolder folder;
  folder.Write("net.onnx/inside", "a folder of the file's name is not the file");
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              FindModelFile("net.onnx", {folder.path(), "/b"});
            }),
            "model file net.onnx is in none of: " + folder.path() + ", /b");
}

TEST(Sha256OfFileTest, KnownDigests) {
  const TemporaryFolder folder;
  // FIPS 180-2, appendix B.1; and the digest of nothing.
  EXPECT_EQ(Sha256OfFile(folder.Write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(Sha256OfFile(folder.Write("empty", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  // Appendix B.3: longer than one read.
  EXPECT_EQ(Sha256OfFile(folder.Write("long", std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(MessageOf<ConfigError>([] { Sha256OfFile("/nowhere/net.onnx"); }),
            "cannot read model file /nowhere/net.onnx");
}

TEST(ReadClassNamesTest, ReadsALineEach) {
  const TemporaryFolder folder;
  const std::vector<std::string> expected{"dining table", "tv"};
  EXPECT_EQ(ReadClassNames(folder.Write("unix", "dining table\ntv\n")), expected);
  EXPECT_EQ(ReadClassNames(folder.Write("dos", "dining table\r\ntv\r\n\r\n")), expected);
  EXPECT_EQ(ReadClassNames(folder.Write("unended", "dining table\ntv")), expected);
}

TEST(ReadClassNamesTest, RefusesGapsAndNothing) {
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ReadClassNames(folder.Write("gap", "a\n\nb\n")); }),
            folder / "gap:2: no class name");
  EXPECT_EQ(MessageOf<ConfigError>([&] { ReadClassNames(folder.Write("none", "\n\n")); }),
            folder / "none: has no class names");
}

}  // namespace
}  // namespace semantic_slam
