#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace semantic_slam {

// A file for what does not fit into memory. Nobody else sees it, and it is gone with the process,
// however that ends. Reading is safe from any thread, also while another one appends.
class ScratchFile {
 public:
  // In `folder`; empty: where the system keeps temporary files. Throws InputError naming it if no
  // file can be made there.
  explicit ScratchFile(const std::string& folder);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  // Returns where it lies. Throws InputError if the disk is full; what was there stays. For one
  // thread.
  std::uint64_t Append(const void* bytes, std::size_t size);

  // Throws InputError if it cannot be read.
  void Read(std::uint64_t offset, void* bytes, std::size_t size) const;

  std::uint64_t size() const { return size_; }

 private:
  const std::string folder_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace semantic_slam
