#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// One line of a text file of the MOTChallenge: a box in one image of a sequence.
struct BoxInFrame {
  int frame = 1;            // from 1
  int id = -1;              // of the object; -1 where nobody knows, as in a detector's output
  cv::Rect2d box;           // [px]
  double confidence = 1.0;  // of a detection; in ground truth 0 marks boxes that do not count
};

// Reads lines "frame,id,left,top,width,height,confidence,...", whatever follows, sorted by frame
// and else in the order of the file. Throws InputError naming file and line if one is anything
// else.
std::vector<BoxInFrame> ReadBoxTracks(const std::string& path);

// Writes such a file, the last three columns -1. Throws InputError if it cannot be written.
void WriteBoxTracks(const std::string& path, const std::vector<BoxInFrame>& boxes);

}  // namespace semantic_slam
