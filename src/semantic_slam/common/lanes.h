#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

// Four numbers that are worked on at once, in one register of every processor that we meet: vectors
// of GCC's and Clang's. They add, multiply and compare lane by lane; a comparison that holds is -1.

namespace semantic_slam {

typedef float Floats4 __attribute__((vector_size(16)));
typedef std::int32_t Ints4 __attribute__((vector_size(16)));
typedef double Doubles2 __attribute__((vector_size(16)));
typedef std::int64_t Longs2 __attribute__((vector_size(16)));

inline Floats4 ToFloats(Ints4 ints) {
  return __builtin_convertvector(ints, Floats4);
}

// Rounds towards zero.
inline Ints4 ToInts(Floats4 floats) {
  return __builtin_convertvector(floats, Ints4);
}

// The largest whole number that is not above, of numbers that an int holds.
inline Ints4 Floor(Floats4 floats) {
  const Ints4 truncated = ToInts(floats);
  return truncated + (ToFloats(truncated) > floats);
}

// Whether a comparison holds in all lanes.
inline bool All(Ints4 comparison) {
#ifdef __SSE2__
  return _mm_movemask_ps(reinterpret_cast<__m128>(comparison)) == 0xf;
#else
  const auto halves = reinterpret_cast<Longs2>(comparison);
  return (halves[0] & halves[1]) == -1;
#endif
}

// Bytes as numbers.
using Bytes4 = std::array<std::uint8_t, 4>;
inline Ints4 ToInts(const Bytes4& bytes) {
  typedef std::uint8_t Lanes __attribute__((vector_size(4)));
  Lanes lanes;
  std::memcpy(&lanes, bytes.data(), sizeof(lanes));
  return __builtin_convertvector(lanes, Ints4);
}

}  // namespace semantic_slam
