#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace semantic_slam {

// Writes a file so that readers see the old content or all of the new, never half: `write` fills a
// temporary file in the same folder, which is then renamed to `path`. Missing folders are made.
// Throws InputError naming `path` if it cannot be written; nothing is left behind then.
void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write);

// The same for libraries that write to a path of their own: `write` gets a temporary path in the
// same folder, with the extension of `path`, and returns false if it failed.
void WriteFileAtomicallyVia(const std::string& path,
                            const std::function<bool(const std::string& temporary_path)>& write);

}  // namespace semantic_slam
