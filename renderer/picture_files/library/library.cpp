// The entry point of pelage-pictures.so and its implementation of PictureFiles.
#include "renderer/picture_files/library/members.h"
#include "renderer/picture_files/library/open_picture.h"

namespace pelage {

namespace {

class OpenImageIoFiles final : public PictureFiles {
 public:
  Result<Image> decode_image(std::span<const std::byte> bytes, std::size_t max_pixels) const override {
    return pelage::decode_image(bytes, max_pixels);
  }
  Result<FloatImage> decode_float_image(std::span<const std::byte> bytes, std::size_t max_pixels) const override {
    return pelage::decode_float_image(bytes, max_pixels);
  }
  Result<DataImage> decode_data_image(std::span<const std::byte> bytes, std::size_t max_pixels,
                                      const std::string& key) const override {
    return pelage::decode_data_image(bytes, max_pixels, key);
  }
  std::string text_in_picture(std::span<const std::byte> bytes, const std::string& key) const override {
    return pelage::text_in_picture(bytes, key);
  }
  std::string encode_jpeg(const Image& image, int quality) const override {
    return pelage::encode_jpeg(image, quality);
  }
  std::string encode_webp(const Image& image, int quality) const override {
    return pelage::encode_webp(image, quality);
  }
  std::string encode_exr(const ExrWindow& window, std::span<const ExrPlane> planes,
                         std::span<const ImageText> texts) const override {
    return pelage::encode_exr(window, planes, texts);
  }
  Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                     std::span<const ImageText> texts) const override {
    return pelage::merge_pictures(parts, width, height, keep_alpha, texts);
  }
  Status to_colour_space(const std::string& space, std::span<float> rgba) const override {
    return pelage::to_colour_space(space, rgba);
  }
  Result<glm::mat3> linear_from_space(const std::string& space) const override {
    return pelage::linear_from_space(space);
  }
  void read_exr_without_threads() const override { OIIO::attribute("exr_threads", -1); }
};

}  // namespace

}  // namespace pelage

extern "C" const pelage::PictureFiles* pelage_picture_files() {
  static const pelage::OpenImageIoFiles files;
  return &files;
}
