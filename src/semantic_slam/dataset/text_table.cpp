#include "semantic_slam/dataset/text_table.h"

#include <fstream>
#include <sstream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr std::size_t kMaxQuoted = 60;  // enough of a bad line to recognise it

[[noreturn]] void ThrowBadLine(const std::string& path, int line, const std::string& expected,
                               const std::string& text) {
  const std::string quoted = text.size() > kMaxQuoted ? text.substr(0, kMaxQuoted) + "..." : text;
  throw InputError(path + ":" + std::to_string(line) + ": expected '" + expected + "', found '" +
                   quoted + "'");
}

std::vector<std::string> SplitAtBlanks(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

std::vector<TextRow> ReadTextTable(const std::string& path, std::size_t fields,
                                   const std::string& expected) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot open " + path);
  std::vector<TextRow> rows;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    std::vector<std::string> words = SplitAtBlanks(text);
    if (words.empty() || words[0][0] == '#') continue;
    const auto stamp = Stamp::Parse(words[0]);
    if (!stamp || words.size() != fields + 1) ThrowBadLine(path, line, expected, text);
    words.erase(words.begin());
    rows.push_back({*stamp, std::move(words), line});
  }
  if (file.bad()) throw InputError("cannot read " + path + "; is it a file?");
  return rows;
}

void ThrowBadRow(const std::string& path, const TextRow& row, const std::string& expected) {
  std::string text = ToString(row.stamp);
  for (const std::string& field : row.fields) text += " " + field;
  ThrowBadLine(path, row.line, expected, text);
}

}  // namespace semantic_slam
