#include "semantic_slam/network_evaluation/image_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

bool IsImageFile(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".jpg" || extension == ".jpeg" || extension == ".png";
}

// Empty if it is no image.
cv::Mat Decode(const std::string& path, int flags) {
  if (!fs::is_regular_file(path)) throw InputError("no such file: " + path);
  try {
    return cv::imread(path, flags);
  } catch (const cv::Exception&) {
    return {};  // its header asks for more pixels than OpenCV allows
  }
}

}  // namespace

std::vector<std::string> SequenceFolders(const std::string& root) {
  std::vector<std::string> folders;
  std::error_code error;
  if (fs::exists(fs::path(root) / "rgb.txt", error)) folders.push_back(root);
  const auto options = fs::directory_options::follow_directory_symlink |
                       fs::directory_options::skip_permission_denied;
  fs::recursive_directory_iterator entry(root, options, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code unreadable;
    if (entry->is_directory(unreadable) && fs::exists(entry->path() / "rgb.txt", unreadable)) {
      folders.push_back(entry->path().string());
    }
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::vector<std::string> ImagesIn(const std::string& folder) {
  std::vector<std::string> images;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (IsImageFile(entry.path())) images.push_back(entry.path().string());
  }
  std::sort(images.begin(), images.end());
  return images;
}

cv::Mat ReadColourImage(const std::string& path) {
  cv::Mat image = Decode(path, cv::IMREAD_COLOR);
  if (image.empty()) throw InputError(path + " is no readable image");
  return image;
}

cv::Mat ReadLabelImage(const std::string& path, cv::Size size) {
  const cv::Mat ids = Decode(path, cv::IMREAD_UNCHANGED);
  if (ids.empty() || (ids.type() != CV_8UC1 && ids.type() != CV_16UC1)) {
    throw InputError(path + ": expected a readable grey image of 8 or 16 bits with ids of labels");
  }
  if (ids.size() != size) {
    throw InputError(path + " is " + std::to_string(ids.cols) + " x " + std::to_string(ids.rows) +
                     " px, but its colour image " + std::to_string(size.width) + " x " +
                     std::to_string(size.height));
  }
  cv::Mat labels;
  ids.convertTo(labels, CV_8U);
  return labels;
}

}  // namespace semantic_slam
