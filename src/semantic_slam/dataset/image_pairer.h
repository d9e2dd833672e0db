#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/dataset/shortest_gap.h"

// The one rule by which colour and depth images become pairs: nearest stamps first, one to one,
// within max_gap_s. PairStamps() applies it to whole lists, ImagePairer to images as they arrive.

namespace semantic_slam {

struct ImagePairerOptions {
  double max_gap_s = 0.02;  // colour and depth farther apart are not of one moment
  // The next image of a stream is taken to come no sooner than this share of the shortest of its
  // last hundred gaps, so the pairer need not wait for it to rule out that it fits better. 0 always
  // waits.
  double min_period_share = 0.75;
  int capacity = 10;  // images of one stream that may wait for a partner

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_gap_s", self.max_gap_s, 0.0, 1.0);
    visit("min_period_share", self.min_period_share, 0.0, 1.0);
    visit("capacity", self.capacity, 1, 1000);
  }
};

// Indices into a list of colour images and one of depth images.
struct PairIndices {
  std::size_t colour;
  std::size_t depth;
};

// Pairs two lists of ascending stamps: of all candidates within `max_gap_s` the one with the
// smallest gap first (of equal gaps the earlier colour, then the earlier depth), then the next
// whose images are both still free, as TUM's associate.py does. Returns the pairs by ascending
// colour.
std::vector<PairIndices> PairStamps(const std::vector<Stamp>& colour,
                                    const std::vector<Stamp>& depth, double max_gap_s);

namespace internal {

struct ColourFate {
  enum Kind { kOpen, kPaired, kUnpaired } kind;
  std::size_t depth;  // index of the partner, with kPaired
};

// What is certain about each colour image at hand, given that images still to come are not earlier
// than `next_colour` and `next_depth`: kPaired and kUnpaired are final, whatever comes.
std::vector<ColourFate> DecideFates(const std::vector<Stamp>& colour,
                                    const std::vector<Stamp>& depth, std::int64_t max_gap_ns,
                                    Stamp next_colour, Stamp next_depth);

// Far from the ends of the range, so that sums and differences of stamps do not overflow.
constexpr Stamp kStartOfTime{std::numeric_limits<std::int64_t>::min() / 4};
constexpr Stamp kEndOfTime{std::numeric_limits<std::int64_t>::max() / 4};

inline std::int64_t Nanoseconds(double seconds) {
  return std::llround(seconds * 1e9);
}

}  // namespace internal

// Pairs two streams of images as they arrive. `Payload` is whatever travels with a stamp: an image,
// a pointer to a message. Pairs come out in order of colour's stamp, each as soon as no image still
// to come can fit better.
//
// The pairs are those of PairStamps() as long as each stream arrives in order, no more than
// `capacity` images have to wait and no gap of a stream is shorter than min_period_share of the
// shortest one of the hundred before. After one that is, an image may get a partner within
// max_gap_s that is not its nearest, or none.
//
// Not thread-safe.
template <typename Payload>
class ImagePairer {
 public:
  struct Pair {
    Stamp stamp;  // colour's
    Stamp depth_stamp;
    Payload colour;
    Payload depth;
  };

  struct Result {
    std::vector<Pair> pairs;  // those that became certain: none or one as a rule
    // The stream's last three images, in order among themselves, are all over a second older than
    // one before them: the recording started again. What was waiting is forgotten, these three are
    // not, and whoever keeps state downstream must start again before it takes the pairs.
    bool jumped_back = false;
  };

  struct Counts {
    std::size_t unpaired_colour = 0;
    std::size_t unpaired_depth = 0;
    // Not later than the image before of the same stream, and no jump back: left out.
    std::size_t out_of_order = 0;
    std::size_t jumps_back = 0;
  };

  // Throws ConfigError if an option is out of range.
  explicit ImagePairer(const ImagePairerOptions& options = {}) : options_(options) {
    Validate(options_);
  }

  Result AddColour(Stamp stamp, Payload image) { return Add(colour_, stamp, std::move(image)); }
  Result AddDepth(Stamp stamp, Payload image) { return Add(depth_, stamp, std::move(image)); }

  // At the end of the streams: the pairs among the images that still wait for certainty.
  std::vector<Pair> Flush() {
    LeaveOut(colour_.early);
    LeaveOut(depth_.early);
    return TakeDecided(internal::kEndOfTime, internal::kEndOfTime);
  }

  const Counts& counts() const { return counts_; }

 private:
  struct Image {
    Stamp stamp;
    Payload payload;
  };
  struct Stream {
    std::deque<Image> waiting;  // by ascending stamp
    std::optional<Stamp> newest;
    ShortestGap shortest_gap;
    std::deque<Image> early;  // the last images, if far older than newest; by ascending stamp
  };

  static constexpr double kJumpBackS = 1.0;
  static constexpr std::size_t kJumpBackImages = 3;

  Result Add(Stream& stream, Stamp stamp, Payload image) {
    Result result;
    if (stream.newest && SecondsBetween(stamp, *stream.newest) > kJumpBackS) {
      result.jumped_back = IsJumpBack(stream, {stamp, std::move(image)});
      if (!result.jumped_back) return result;
    } else {
      LeaveOut(stream.early);
      if (stream.newest && stamp <= *stream.newest) {
        ++counts_.out_of_order;
        return result;
      }
      Append(stream, {stamp, std::move(image)});
    }
    result.pairs = TakeDecided(EarliestNext(colour_), EarliestNext(depth_));
    DropOverflow(colour_, counts_.unpaired_colour);
    DropOverflow(depth_, counts_.unpaired_depth);
    return result;
  }

  static void Append(Stream& stream, Image image) {
    stream.newest = image.stamp;
    stream.shortest_gap.Add(image.stamp);
    stream.waiting.push_back(std::move(image));
  }

  // Keeps an image that is far older than its stream's newest. Once enough of them say the same,
  // both streams begin again with what was kept.
  bool IsJumpBack(Stream& stream, Image image) {
    if (!stream.early.empty() && image.stamp <= stream.early.back().stamp) LeaveOut(stream.early);
    stream.early.push_back(std::move(image));
    if (stream.early.size() < kJumpBackImages) return false;
    ++counts_.jumps_back;
    BeginAgain(colour_, counts_.unpaired_colour);
    BeginAgain(depth_, counts_.unpaired_depth);
    return true;
  }

  static void BeginAgain(Stream& stream, std::size_t& unpaired) {
    unpaired += stream.waiting.size();
    std::deque<Image> beginning = std::move(stream.early);
    stream = Stream();
    for (Image& image : beginning) Append(stream, std::move(image));
  }

  void LeaveOut(std::deque<Image>& images) {
    counts_.out_of_order += images.size();
    images.clear();
  }

  std::vector<Pair> TakeDecided(Stamp next_colour, Stamp next_depth) {
    std::vector<Pair> pairs;
    std::vector<bool> taken(depth_.waiting.size());
    for (const auto& fate : internal::DecideFates(Stamps(colour_), Stamps(depth_), max_gap_ns_,
                                                  next_colour, next_depth)) {
      if (fate.kind == internal::ColourFate::kOpen) break;
      Image& colour = colour_.waiting.front();
      if (fate.kind == internal::ColourFate::kPaired) {
        Image& depth = depth_.waiting[fate.depth];
        pairs.push_back(
            {colour.stamp, depth.stamp, std::move(colour.payload), std::move(depth.payload)});
        taken[fate.depth] = true;
      } else {
        ++counts_.unpaired_colour;
      }
      colour_.waiting.pop_front();
    }
    const Stamp earliest = colour_.waiting.empty() ? next_colour : colour_.waiting.front().stamp;
    DropDepth(taken, earliest);
    return pairs;
  }

  // Drops the depth images that are taken, and those too old for a colour image at `earliest`.
  void DropDepth(const std::vector<bool>& taken, Stamp earliest) {
    std::deque<Image> left;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      if (taken[i]) continue;
      Image& image = depth_.waiting[i];
      if (earliest.ns - image.stamp.ns > max_gap_ns_) {
        ++counts_.unpaired_depth;
      } else {
        left.push_back(std::move(image));
      }
    }
    depth_.waiting = std::move(left);
  }

  void DropOverflow(Stream& stream, std::size_t& unpaired) {
    while (stream.waiting.size() > static_cast<std::size_t>(options_.capacity)) {
      stream.waiting.pop_front();
      ++unpaired;
    }
  }

  Stamp EarliestNext(const Stream& stream) const {
    if (!stream.newest) return internal::kStartOfTime;
    const double shortest_ns = static_cast<double>(stream.shortest_gap.ns().value_or(0));
    const std::int64_t period_ns = std::llround(options_.min_period_share * shortest_ns);
    return {stream.newest->ns + std::max<std::int64_t>(period_ns, 1)};
  }

  static std::vector<Stamp> Stamps(const Stream& stream) {
    std::vector<Stamp> stamps;
    for (const Image& image : stream.waiting) stamps.push_back(image.stamp);
    return stamps;
  }

  const ImagePairerOptions options_;
  const std::int64_t max_gap_ns_ = internal::Nanoseconds(options_.max_gap_s);
  Stream colour_;
  Stream depth_;
  Counts counts_;
};

}  // namespace semantic_slam
