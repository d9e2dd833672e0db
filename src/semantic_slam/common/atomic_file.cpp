#include "semantic_slam/common/atomic_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

namespace fs = std::filesystem;

void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write) {
  WriteFileAtomicallyVia(path, [&](const std::string& temporary_path) {
    std::ofstream file(temporary_path, std::ios::binary);
    if (!file) return false;
    write(file);
    file.close();
    return !file.fail();
  });
}

void WriteFileAtomicallyVia(const std::string& path,
                            const std::function<bool(const std::string&)>& write) {
  const fs::path target(path);
  const fs::path temporary = target.parent_path() / ("." + target.stem().string() + "." +
                                                     std::to_string(::getpid()) +
                                                     target.extension().string());
  std::error_code error;
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  bool written = false;
  try {
    written = write(temporary.string());
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  if (written) {
    fs::rename(temporary, target, error);
    if (!error) return;
  }
  fs::remove(temporary, error);
  throw InputError("cannot write " + path + "; does the folder exist and is there room?");
}

}  // namespace semantic_slam
