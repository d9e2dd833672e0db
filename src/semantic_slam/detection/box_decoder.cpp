#include "semantic_slam/detection/box_decoder.h"

#include "semantic_slam/common/error.h"
#include "semantic_slam/detection/ssd_decoder.h"
#include "semantic_slam/detection/yolo_decoder.h"

namespace semantic_slam {

std::unique_ptr<BoxDecoder> MakeBoxDecoder(const Model& model, const std::vector<Shape>& shapes) {
  if (model.card.head.type == HeadType::kYolo) {
    return std::make_unique<YoloDecoder>(model, shapes);
  }
  if (model.card.head.type == HeadType::kSsd) return std::make_unique<SsdDecoder>(model, shapes);
  throw ConfigError(model.card.path + ": head/type is neither yolo nor ssd");
}

}  // namespace semantic_slam
