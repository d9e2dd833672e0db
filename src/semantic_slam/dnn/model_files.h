#pragma once

#include <string>
#include <vector>

namespace semantic_slam {

// Where the files that a card names are looked for, in this order: `models_folder` if it is not
// empty, the card's own folder, models/ two folders above it, $SEMANTIC_SLAM_SHARED/models if that
// is set, and shared/models three folders above it.
std::vector<std::string> ModelFolders(const std::string& card_path,
                                      const std::string& models_folder);

// The first of folder/name that is a file. An absolute name is taken as it is. Throws ConfigError
// naming the file and every folder.
std::string FindModelFile(const std::string& name, const std::vector<std::string>& folders);

// Of the file's content, 64 lower-case hexadecimal digits. Throws ConfigError if it cannot be read.
std::string Sha256OfFile(const std::string& path);

// The lines of a list of class names, without line ends. Throws ConfigError naming file and line if
// one is empty or there is none.
std::vector<std::string> ReadClassNames(const std::string& path);

}  // namespace semantic_slam
