#pragma once

#include <string>
#include <vector>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// One line of a TUM text file: a stamp and what follows it, split at blanks.
struct TextRow {
  Stamp stamp;
  std::vector<std::string> fields;
  int line;  // from 1
};

// Reads all rows of a file whose lines are a stamp and `fields` more; '#' starts a comment line.
// In the order of the file. `expected` describes a line to people, as "stamp filename". Throws
// InputError naming the file if it cannot be read, and the line too if that is anything else.
std::vector<TextRow> ReadTextTable(const std::string& path, std::size_t fields,
                                   const std::string& expected);

// The exception for a line that has the fields but not what they should hold.
[[noreturn]] void ThrowBadRow(const std::string& path, const TextRow& row,
                              const std::string& expected);

}  // namespace semantic_slam
