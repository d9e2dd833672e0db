#include "semantic_slam/dnn/model_files.h"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include <openssl/evp.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

std::string Hexadecimal(const unsigned char* bytes, unsigned int count) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 0xf];
  }
  return text;
}

std::string WithoutLineEnd(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

}  // namespace

std::vector<std::string> ModelFolders(const std::string& card_path,
                                      const std::string& models_folder) {
  const fs::path card_folder = fs::absolute(card_path).parent_path();
  std::vector<fs::path> folders;
  if (!models_folder.empty()) folders.emplace_back(models_folder);
  folders.push_back(card_folder);
  folders.push_back(card_folder / ".." / ".." / "models");
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no thread changes the environment
  if (const char* shared = std::getenv("SEMANTIC_SLAM_SHARED")) {
    folders.push_back(fs::path(shared) / "models");
  }
  folders.push_back(card_folder / ".." / ".." / ".." / "shared" / "models");
  std::vector<std::string> names;
  names.reserve(folders.size());
  for (const fs::path& folder : folders) names.push_back(folder.lexically_normal().string());
  return names;
}

std::string FindModelFile(const std::string& name, const std::vector<std::string>& folders) {
  std::string tried;
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / name;  // name alone if that is absolute
    std::error_code error;
    if (fs::is_regular_file(path, error)) return path.string();
    tried += (tried.empty() ? "" : ", ") + folder;
  }
  throw ConfigError("model file " + name + " is in none of: " + tried);
}

std::string Sha256OfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        &EVP_MD_CTX_free);
  bool good = file && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  std::vector<char> buffer(1 << 16);
  while (good && file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    good = EVP_DigestUpdate(context.get(), buffer.data(),
                            static_cast<std::size_t>(file.gcount())) == 1;
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  good = good && file.eof() && EVP_DigestFinal_ex(context.get(), digest.data(), &length) == 1;
  if (!good) throw ConfigError("cannot read model file " + path);
  return Hexadecimal(digest.data(), length);
}

std::vector<std::string> ReadClassNames(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) names.push_back(WithoutLineEnd(line));
  while (!names.empty() && names.back().empty()) names.pop_back();
  if (names.empty()) throw ConfigError(path + ": has no class names");
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) throw ConfigError(path + ":" + std::to_string(i + 1) + ": no class name");
  }
  return names;
}

}  // namespace semantic_slam
