#pragma once

#include <cstddef>
#include <ostream>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/evaluation/box_tracks.h"

namespace semantic_slam {

// How well boxes were followed through a sequence. Shares are 0..1, MOTA may be less.
struct BoxTrackingScore {
  double mota = 0.0;  // Bernardin and Stiefelhagen, EURASIP JIVP 2008
  double idf1 = 0.0;  // Ristani et al., ECCV workshops 2016
  double hota = 0.0;  // Luiten et al., IJCV 2021: mean over IoU thresholds 0.05, 0.10, ... 0.95
  std::size_t reference_boxes = 0;
  std::size_t estimated_boxes = 0;
  std::size_t false_positives = 0;  // these three at IoU 0.5
  std::size_t false_negatives = 0;
  std::size_t id_switches = 0;
};

// Scores estimated tracks against reference ones, both sorted by frame, in the way of the
// MOTChallenge's evaluation. Reference boxes with confidence 0 do not count. Throws InputError if
// the reference has no box that counts, or an id twice in a frame.
BoxTrackingScore ScoreBoxTracks(const std::vector<BoxInFrame>& reference,
                                const std::vector<BoxInFrame>& estimate);

// Keys mota, idf1, hota (percent), id_switches, false_positives, false_negatives, ...
nlohmann::ordered_json ToJson(const BoxTrackingScore& score);

// The same as a small table for people.
void PrintTable(const BoxTrackingScore& score, std::ostream& out);

}  // namespace semantic_slam
