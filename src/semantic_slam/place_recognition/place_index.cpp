#include "semantic_slam/place_recognition/place_index.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace semantic_slam {
namespace {

constexpr std::size_t kSmallBucket = 64;  // such a bucket is always worth looking through

// The first bits of a shuffle that is the same everywhere: std::shuffle is not.
template <std::size_t kCount>
std::array<std::uint8_t, kCount> ShuffledBits() {
  std::array<std::uint8_t, kMaxDescriptorDistance> bits;
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = static_cast<std::uint8_t>(i);
  std::mt19937 random(1);
  for (std::size_t i = bits.size() - 1; i > 0; --i) std::swap(bits[i], bits[random() % (i + 1)]);
  std::array<std::uint8_t, kCount> first;
  std::copy_n(bits.begin(), kCount, first.begin());
  return first;
}

}  // namespace

PlaceIndex::PlaceIndex(const PlaceIndexOptions& options)
    : options_(Validated(options)), buckets_(std::size_t{kTables} << kKeyBits) {
  const auto bits = ShuffledBits<kTables * kKeyBits>();
  for (int t = 0; t < kTables; ++t) {
    std::copy_n(bits.begin() + t * kKeyBits, kKeyBits, key_bits_[t].begin());
  }
}

void PlaceIndex::Add(KeyframeId keyframe, std::shared_ptr<const FrameFeatures> features) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (place_of_.count(keyframe) > 0) return;
  const std::uint32_t place = FreePlace();
  for (std::size_t i = 0; i < features->size(); ++i) {
    const Keys keys = KeysOf(features->descriptor(i));
    for (int t = 0; t < kTables; ++t) {
      Bucket(t, keys[t]).push_back({place, static_cast<std::uint32_t>(i)});
    }
  }
  features_ += features->size();
  places_[place] = {keyframe, std::move(features)};
  place_of_[keyframe] = place;
}

void PlaceIndex::Remove(KeyframeId keyframe) {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto found = place_of_.find(keyframe);
  if (found == place_of_.end()) return;
  const std::uint32_t place = found->second;
  const FrameFeatures& features = *places_[place].features;
  for (const Descriptor& descriptor : features.descriptors()) {
    const Keys keys = KeysOf(descriptor);
    for (int t = 0; t < kTables; ++t) {
      auto& bucket = Bucket(t, keys[t]);
      bucket.erase(std::remove_if(bucket.begin(), bucket.end(),
                                  [place](const Entry& e) { return e.place == place; }),
                   bucket.end());
    }
  }
  features_ -= features.size();
  places_[place] = {kNoKeyframe, nullptr};
  place_of_.erase(found);
}

void PlaceIndex::Clear() {
  std::lock_guard<std::mutex> lock(mutex_);
  for (auto& bucket : buckets_) bucket = {};
  places_.clear();
  place_of_.clear();
  features_ = 0;
}

std::set<KeyframeId> PlaceIndex::Keyframes() const {
  std::lock_guard<std::mutex> lock(mutex_);
  std::set<KeyframeId> keyframes;
  for (const auto& entry : place_of_) keyframes.insert(entry.first);
  return keyframes;
}

std::vector<PlaceScore> PlaceIndex::Query(const FrameFeatures& image) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto max_bucket = std::max(
      kSmallBucket, static_cast<std::size_t>(options_.max_bucket_share *
                                             static_cast<double>(features_)));
  const double all = static_cast<double>(place_of_.size()) + 1.0;
  std::vector<double> scores(places_.size(), 0.0);
  std::vector<std::uint32_t> places;
  for (const Descriptor& descriptor : image.descriptors()) {
    FindPlaces(descriptor, max_bucket, places);
    const double weight = std::log(all / static_cast<double>(std::max<std::size_t>(1, places.size())));
    for (const std::uint32_t place : places) scores[place] += weight;
  }
  std::vector<PlaceScore> ranked;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (scores[i] > 0.0) ranked.push_back({places_[i].keyframe, scores[i]});
  }
  std::sort(ranked.begin(), ranked.end(), [](const PlaceScore& a, const PlaceScore& b) {
    return a.score != b.score ? a.score > b.score : a.keyframe < b.keyframe;
  });
  return ranked;
}

// The places that have a feature like this one, each once.
void PlaceIndex::FindPlaces(const Descriptor& descriptor, std::size_t max_bucket,
                            std::vector<std::uint32_t>& places) const {
  places.clear();
  const Keys keys = KeysOf(descriptor);
  for (int t = 0; t < kTables; ++t) {
    const auto& bucket = Bucket(t, keys[t]);
    if (bucket.size() > max_bucket) continue;
    for (const Entry& entry : bucket) {
      const Descriptor& other = places_[entry.place].features->descriptor(entry.feature);
      if (HammingDistance(descriptor, other) <= options_.max_distance) places.push_back(entry.place);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

PlaceIndex::Keys PlaceIndex::KeysOf(const Descriptor& descriptor) const {
  Keys keys{};
  for (int t = 0; t < kTables; ++t) {
    unsigned key = 0;
    for (const std::uint8_t bit : key_bits_[t]) {
      key = key << 1 | static_cast<unsigned>(descriptor[bit / 64] >> (bit % 64) & 1);
    }
    keys[t] = static_cast<Key>(key);
  }
  return keys;
}

std::uint32_t PlaceIndex::FreePlace() {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].features == nullptr) return static_cast<std::uint32_t>(i);
  }
  places_.push_back({kNoKeyframe, nullptr});
  return static_cast<std::uint32_t>(places_.size() - 1);
}

}  // namespace semantic_slam
