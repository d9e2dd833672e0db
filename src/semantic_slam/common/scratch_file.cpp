#include "semantic_slam/common/scratch_file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

std::string FolderOr(const std::string& folder) {
  if (!folder.empty()) return folder;
  std::error_code error;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  return error ? "/tmp" : temporary.string();
}

[[noreturn]] void Fail(const std::string& folder, const char* what) {
  throw InputError(folder + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

ScratchFile::ScratchFile(const std::string& folder) : folder_(FolderOr(folder)) {
  std::string path = folder_ + "/semantic_slam_XXXXXX";
  descriptor_ = mkostemp(path.data(), O_CLOEXEC);
  if (descriptor_ < 0) Fail(folder_, "cannot make a temporary file");
  unlink(path.c_str());
}

ScratchFile::~ScratchFile() {
  close(descriptor_);
}

std::uint64_t ScratchFile::Append(const void* bytes, std::size_t size) {
  const auto* from = static_cast<const char*>(bytes);
  for (std::size_t done = 0; done < size;) {
    const ssize_t written =
        pwrite(descriptor_, from + done, size - done, static_cast<off_t>(size_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) Fail(folder_, "cannot write a temporary file");
    done += static_cast<std::size_t>(written);
  }
  const std::uint64_t offset = size_;
  size_ += size;
  return offset;
}

void ScratchFile::Read(std::uint64_t offset, void* bytes, std::size_t size) const {
  auto* to = static_cast<char*>(bytes);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got =
        pread(descriptor_, to + done, size - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) Fail(folder_, "cannot read a temporary file");
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace semantic_slam
