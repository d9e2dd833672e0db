#include "semantic_slam/dnn/input_blob.h"

#include <string>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

InputBlob::InputBlob(const NetworkInput& input)
    : input_(input),
      fitted_(input.size(), CV_8UC3, cv::Scalar::all(input.pad)),
      blob_({1, 3, input.height_px, input.width_px}, CV_32F) {
  for (int channel = 0; channel < 3; ++channel) {
    for (int grey = 0; grey < 256; ++grey) {
      tables_[channel][grey] =
          static_cast<float>((grey * input.scale - input.mean[channel]) / input.std[channel]);
    }
  }
}

const cv::Mat& InputBlob::Make(const cv::Mat& image, ColourOrder order) {
  if (image.empty() || image.type() != CV_8UC3) {
    throw InputError("network input: the image is " + cv::typeToString(image.type()) + " of " +
                     std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                     " px, expected CV_8UC3 with pixels");
  }
  Fit(image);
  for (int channel = 0; channel < 3; ++channel) {
    const int source = order == input_.colour ? channel : 2 - channel;
    FillPlane(source, tables_[channel], blob_.ptr<float>(0, channel));
  }
  return blob_;
}

void InputBlob::Fit(const cv::Mat& image) {
  const ImageFit fit(image.size(), input_.size(), input_.fit);
  if (fit.content().size() != fitted_.size()) fitted_.setTo(cv::Scalar::all(input_.pad));
  cv::Mat content = fitted_(fit.content());
  cv::resize(image, content, content.size(), 0.0, 0.0, cv::INTER_LINEAR);
}

void InputBlob::FillPlane(int channel, const Table& table, float* plane) const {
  for (int v = 0; v < fitted_.rows; ++v) {
    const std::uint8_t* pixel = fitted_.ptr<std::uint8_t>(v) + channel;
    for (int u = 0; u < fitted_.cols; ++u, pixel += 3) *plane++ = table[*pixel];
  }
}

}  // namespace semantic_slam
