#include "semantic_slam_ros/shared_pixels.h"

#include <memory>
#include <utility>

namespace semantic_slam_ros {
namespace {

using Owner = boost::shared_ptr<const void>;

// Lets a cv::Mat own a message: when the last Mat that looks at the pixels goes, so does its share
// of the message.
class MessageOwner : public cv::MatAllocator {
 public:
  static cv::UMatData* Hold(Owner owner, const cv::Mat& image) {
    static const MessageOwner allocator;
    auto holder = std::make_unique<cv::UMatData>(&allocator);
    holder->data = holder->origdata = image.data;
    holder->size = static_cast<std::size_t>(image.dataend - image.datastart);
    holder->refcount = 1;
    holder->userdata = std::make_unique<Owner>(std::move(owner)).release();
    return holder.release();
  }

  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
  }
  bool allocate(cv::UMatData* data, cv::AccessFlag access,
                cv::UMatUsageFlags usage) const override {
    return cv::Mat::getStdAllocator()->allocate(data, access, usage);
  }
  void deallocate(cv::UMatData* data) const override {
    const std::unique_ptr<cv::UMatData> holder(data);
    const std::unique_ptr<Owner> owner(static_cast<Owner*>(holder->userdata));
  }
};

}  // namespace

cv::Mat SharePixels(Owner owner, const std::uint8_t* pixels, int rows, int cols, int cv_type,
                    std::size_t step) {
  // cv::Mat has no pointer to const; the contract is that nobody writes.
  cv::Mat image(rows, cols, cv_type, const_cast<std::uint8_t*>(pixels), step);
  image.u = MessageOwner::Hold(std::move(owner), image);
  return image;
}

}  // namespace semantic_slam_ros
