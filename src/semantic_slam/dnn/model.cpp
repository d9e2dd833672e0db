#include "semantic_slam/dnn/model.h"

#include <filesystem>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dnn/model_files.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

void CheckSha256(const std::string& path, const std::string& expected) {
  if (expected.empty()) return;
  const std::string found = Sha256OfFile(path);
  if (found == expected) return;
  throw ConfigError(path + ": sha256 is " + found + ", expected " + expected);
}

}  // namespace

Model LoadModel(const std::string& card_path, const std::string& models_folder) {
  Model model{ReadModelCard(card_path), "", "", {}};
  const ModelCard& card = model.card;
  const std::vector<std::string> folders = ModelFolders(card_path, models_folder);
  try {
    model.network_path = FindModelFile(card.file, folders);
    if (fs::path(card.file).extension() == ".cfg") {
      model.weights_path =
          FindModelFile(fs::path(card.file).replace_extension(".weights").string(), folders);
    }
    CheckSha256(model.weights_path.empty() ? model.network_path : model.weights_path, card.sha256);
    if (!card.labels_file.empty()) {
      model.classes = ReadClassNames(FindModelFile(card.labels_file, folders));
    }
  } catch (const ConfigError& e) {
    throw ConfigError(card_path + ": " + e.what());
  }
  return model;
}

}  // namespace semantic_slam
