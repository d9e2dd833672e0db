#include "semantic_slam/common/stamp.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace semantic_slam {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::size_t kMaxSecondDigits = 10;
constexpr std::size_t kMaxDecimals = 9;

std::optional<std::int64_t> ParseDigits(std::string_view digits) {
  std::int64_t value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return value;
}

}  // namespace

Stamp Stamp::FromSeconds(double seconds) { return {std::llround(seconds * 1e9)}; }

std::optional<Stamp> Stamp::Parse(std::string_view text) {
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  std::string decimals;
  if (point != std::string_view::npos) decimals = std::string(text.substr(point + 1));
  if (whole.empty() || whole.size() > kMaxSecondDigits || decimals.size() > kMaxDecimals) {
    return std::nullopt;
  }
  decimals.resize(kMaxDecimals, '0');
  const auto seconds = ParseDigits(whole);
  const auto nanoseconds = ParseDigits(decimals);
  if (!seconds || !nanoseconds) return std::nullopt;
  constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
  if (*seconds > (kLargest - *nanoseconds) / kNsPerSecond) return std::nullopt;
  return Stamp{*seconds * kNsPerSecond + *nanoseconds};
}

std::string ToString(Stamp stamp) {
  const std::int64_t magnitude = std::abs(stamp.ns);
  const auto seconds = static_cast<long long>(magnitude / kNsPerSecond);
  const auto fraction = static_cast<long long>(magnitude % kNsPerSecond);
  const char* sign = stamp.ns < 0 ? "-" : "";
  char text[40];
  if (fraction % 1000 == 0) {
    std::snprintf(text, sizeof(text), "%s%lld.%06lld", sign, seconds, fraction / 1000);
  } else {
    std::snprintf(text, sizeof(text), "%s%lld.%09lld", sign, seconds, fraction);
  }
  return text;
}

}  // namespace semantic_slam
