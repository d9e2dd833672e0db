#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "semantic_slam/common/error.h"

// Numbers as bytes, the least significant first whatever the machine.

namespace semantic_slam {

namespace internal {

// The unsigned integer that has as many bytes.
template <std::size_t kBytes>
struct UnsignedOf;
template <>
struct UnsignedOf<1> {
  using Type = std::uint8_t;
};
template <>
struct UnsignedOf<4> {
  using Type = std::uint32_t;
};
template <>
struct UnsignedOf<8> {
  using Type = std::uint64_t;
};

}  // namespace internal

// Appends integers and floating-point numbers of 1, 4 or 8 bytes.
class ByteWriter {
 public:
  template <typename T>
  void Put(T value) {
    static_assert(std::is_arithmetic<T>::value, "numbers only");
    typename internal::UnsignedOf<sizeof(T)>::Type bits;
    std::memcpy(&bits, &value, sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bytes_.push_back(static_cast<char>(static_cast<std::uint64_t>(bits) >> (8 * i) & 0xff));
    }
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Takes out what ByteWriter has put in.
class ByteReader {
 public:
  // `bytes` must outlive it.
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  // Throws InputError at the end of the bytes.
  template <typename T>
  T Get() {
    static_assert(std::is_arithmetic<T>::value, "numbers only");
    if (bytes_.size() < sizeof(T)) throw InputError("it ends too soon");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bits |= std::uint64_t{static_cast<std::uint8_t>(bytes_[i])} << (8 * i);
    }
    bytes_.remove_prefix(sizeof(T));
    const auto narrow = static_cast<typename internal::UnsignedOf<sizeof(T)>::Type>(bits);
    T value;
    std::memcpy(&value, &narrow, sizeof(T));
    return value;
  }

  // The number of things that follow, each of at least `min_bytes`. Throws InputError if so many do
  // not fit into what is left: a list may be made for them then.
  std::size_t GetCount(std::size_t min_bytes) {
    const auto count = Get<std::uint64_t>();
    if (count > bytes_.size() / min_bytes) throw InputError("it ends too soon");
    return static_cast<std::size_t>(count);
  }

  std::size_t remaining() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

}  // namespace semantic_slam
