#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/features/frame_features.h"

namespace semantic_slam {

struct PlaceIndexOptions {
  int max_distance = 45;         // of 256 bits, between two descriptors of one thing
  double max_bucket_share = 5e-4;  // buckets with more than this share of all features say too little

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_distance", self.max_distance, 1, 255);
    visit("max_bucket_share", self.max_bucket_share, 1e-6, 1.0);
  }
};

// How much a keyframe looks like an image.
struct PlaceScore {
  KeyframeId keyframe = kNoKeyframe;
  double score = 0.0;  // shared features, each the heavier the fewer keyframes share it
};

// Which keyframes look like this image: an index of binary descriptors that grows with the map and
// needs no vocabulary. Each descriptor stands in a few hash tables, under 16 of its bits in each
// (locality-sensitive hashing, Indyk and Motwani 1998); what an image's descriptors meet there is
// compared in full. Weights are inverse document frequencies (Sivic and Zisserman, ICCV 2003).
// Thread-safe.
class PlaceIndex {
 public:
  // Throws ConfigError if an option is out of range.
  explicit PlaceIndex(const PlaceIndexOptions& options);

  // Does nothing if the keyframe is known.
  void Add(KeyframeId keyframe, std::shared_ptr<const FrameFeatures> features);

  // Does nothing if the keyframe is not known.
  void Remove(KeyframeId keyframe);

  void Clear();

  std::set<KeyframeId> Keyframes() const;

  // All keyframes that share a feature with the image, by descending score.
  std::vector<PlaceScore> Query(const FrameFeatures& image) const;

 private:
  static constexpr int kTables = 4;
  static constexpr int kKeyBits = 16;
  struct Entry {
    std::uint32_t place;    // index into places_
    std::uint32_t feature;  // index into its features
  };
  struct Place {
    KeyframeId keyframe;
    std::shared_ptr<const FrameFeatures> features;  // null: free for the next one
  };
  using Key = std::uint16_t;
  using Keys = std::array<Key, kTables>;

  Keys KeysOf(const Descriptor& descriptor) const;
  std::vector<Entry>& Bucket(int table, Key key) { return buckets_[table << kKeyBits | key]; }
  const std::vector<Entry>& Bucket(int table, Key key) const {
    return buckets_[table << kKeyBits | key];
  }
  std::uint32_t FreePlace();
  void FindPlaces(const Descriptor& descriptor, std::size_t max_bucket,
                  std::vector<std::uint32_t>& places) const;

  const PlaceIndexOptions options_;
  std::array<std::array<std::uint8_t, kKeyBits>, kTables> key_bits_;
  mutable std::mutex mutex_;
  std::vector<std::vector<Entry>> buckets_;         // guarded by mutex_
  std::vector<Place> places_;                       // guarded by mutex_
  std::map<KeyframeId, std::uint32_t> place_of_;    // guarded by mutex_
  std::size_t features_ = 0;                        // guarded by mutex_
};

}  // namespace semantic_slam
