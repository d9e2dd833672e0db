#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace semantic_slam {

// One step of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA
// 2014): every bit of the result depends on every bit of `value`.
inline std::uint64_t Mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

// A hash of numbers that say what a random number is for, such as a seed, a thing and a moment.
inline std::uint64_t HashOf(std::initializer_list<std::uint64_t> numbers) {
  std::uint64_t hash = 0;
  for (const std::uint64_t number : numbers) hash = Mixed(hash ^ number);
  return hash;
}

// 53 bits of a hash as a fraction, 0 <= f < 1.
inline double FractionOf(std::uint64_t hash) {
  return static_cast<double>(hash >> 11) * 0x1.0p-53;
}

// Random numbers that are the same on every machine for the same seed. Not thread-safe; cheap to
// make, so whatever is worked on in parallel gets one for itself, seeded with HashOf().
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Bits() {
    const std::uint64_t bits = Mixed(state_);
    state_ += 0x9e3779b97f4a7c15u;
    return bits;
  }

  // 0 <= u < 1.
  double Uniform() { return FractionOf(Bits()); }

  // Mean 0, standard deviation 1 (Box and Muller 1958).
  double Gaussian() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * M_PI * Uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace semantic_slam
