#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "renderer/picture_files/library/members.h"
#include "renderer/picture_files/library/open_picture.h"

namespace pelage {

namespace {

std::size_t pixels_of(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Opens a part. It has to lie inside the whole and to have the format of `first`, unless that has no channels.
Result<OpenPicture> open_part(const PicturePart& part, int width, int height, const OIIO::ImageSpec& first) {
  constexpr std::array wanted{PictureFormat::png, PictureFormat::exr};
  Result<OpenPicture> file = open_picture(std::as_bytes(std::span(part.bytes)), wanted, pixels_of(width, height));
  if (!file) return file;
  const OIIO::ImageSpec& spec = file->spec;
  const bool inside =
      part.left >= 0 && part.top >= 0 && part.left + spec.width <= width && part.top + spec.height <= height;
  if (!inside) return failure(Code::invalid, "A part lies outside the picture.");
  const bool exr = file->format == PictureFormat::exr;
  const bool alike =
      first.nchannels == 0 ||
      (spec.format == first.format &&
       (!exr || (spec.channelnames == first.channelnames && spec.channelformats == first.channelformats)));
  if (!alike) return failure(Code::invalid, "The parts are of different kinds.");
  return file;
}

/// Reads all channels of all pixels, interleaved.
template <class Number>
Result<std::vector<Number>> read_numbers(OpenPicture& file, const OIIO::TypeDesc& type) {
  const auto channels = static_cast<std::size_t>(file.spec.nchannels);
  std::vector<Number> numbers(file.spec.image_pixels() * channels);
  if (!file.input->read_image(0, 0, 0, file.spec.nchannels, type, numbers.data()) || file.input->has_error())
    return unreadable_pixels(*file.input);
  return numbers;
}

/// Copies the rows of a part into the whole.
template <class Number>
void paste(const std::vector<Number>& part, const OIIO::ImageSpec& spec, const PicturePart& position, int width,
           std::vector<Number>& whole) {
  const std::size_t row = part.size() / static_cast<std::size_t>(spec.height);
  const std::size_t channels = row / static_cast<std::size_t>(spec.width);
  for (int y = 0; y < spec.height; ++y) {
    const std::size_t to = pixels_of(width, position.top + y) + static_cast<std::size_t>(position.left);
    std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row), row,
                whole.begin() + static_cast<std::ptrdiff_t>(to * channels));
  }
}

/// Returns RGBA; a PNG has no alpha if that is 1 everywhere.
template <class Number>
std::vector<Number> with_alpha(std::vector<Number> numbers, int channels) {
  if (channels == 4) return numbers;
  std::vector<Number> rgba;
  rgba.reserve(numbers.size() / 3 * 4);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    rgba.insert(rgba.end(), {numbers[i], numbers[i + 1], numbers[i + 2], std::numeric_limits<Number>::max()});
  return rgba;
}

template <class Picture>
Result<std::string> merge_png(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                              std::span<const ImageText> texts) {
  using Number = typename decltype(Picture::rgba)::value_type;
  const OIIO::TypeDesc type = sizeof(Number) == 1 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16;
  Picture whole;
  whole.width = width, whole.height = height;
  whole.rgba.resize(4 * pixels_of(width, height));
  OIIO::ImageSpec first;
  first.nchannels = 0;
  for (const PicturePart& part : parts) {
    Result<OpenPicture> file = open_part(part, width, height, first);
    if (!file) return file.status();
    if (file->spec.nchannels < 3) return failure(Code::invalid, "A part is without colour.");
    first = file->spec;
    Result<std::vector<Number>> numbers = read_numbers<Number>(*file, type);
    if (!numbers) return numbers.status();
    paste(with_alpha(std::move(*numbers), first.nchannels), first, part, width, whole.rgba);
  }
  return encode_png(whole, keep_alpha, texts);
}

/// Returns the channels of interleaved numbers as planes.
std::vector<ExrPlane> planes_of(const OIIO::ImageSpec& spec, std::span<const float> numbers) {
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < channels; ++k) {
    const bool half = spec.channelformat(static_cast<int>(k)) == OIIO::TypeDesc::HALF;
    planes.push_back({spec.channelnames[k], numbers, k, channels, half ? ExrSample::half : ExrSample::single});
  }
  return planes;
}

std::optional<ExrCamera> camera_of(const OIIO::ImageSpec& spec) {
  ExrCamera camera;
  const auto matrix = [&](const char* name, std::array<float, 16>& numbers) {
    return spec.getattribute(name, OIIO::TypeMatrix44, numbers.data());
  };
  const bool is_there = matrix("worldToCamera", camera.world_to_camera) && matrix("worldToNDC", camera.world_to_ndc);
  return is_there ? std::optional(camera) : std::nullopt;
}

/// Returns the texts that say how an EXR's channels are to be read; all parts have the same.
std::vector<ImageText> texts_of_channels(const OIIO::ImageSpec& spec) {
  std::vector<ImageText> texts;
  for (const OIIO::ParamValue& one : spec.extra_attribs) {
    const std::string key = one.name().string();
    if (key.starts_with(matte_text) || key == colour_space_text) texts.push_back({key, one.get_string()});
  }
  return texts;
}

Result<std::string> merge_exr(std::span<const PicturePart> parts, int width, int height,
                              std::span<const ImageText> texts) {
  std::vector<float> whole;
  OIIO::ImageSpec first;
  first.nchannels = 0;
  for (const PicturePart& part : parts) {
    Result<OpenPicture> file = open_part(part, width, height, first);
    if (!file) return file.status();
    first = file->spec;
    whole.resize(pixels_of(width, height) * static_cast<std::size_t>(first.nchannels));
    const Result<std::vector<float>> numbers = read_numbers<float>(*file, OIIO::TypeDesc::FLOAT);
    if (!numbers) return numbers.status();
    paste(*numbers, first, part, width, whole);
  }
  std::vector<ImageText> all = texts_of_channels(first);
  all.insert(all.end(), texts.begin(), texts.end());
  return encode_exr({.width = width, .height = height, .camera = camera_of(first)}, planes_of(first, whole), all);
}

}  // namespace

Result<std::string> merge_pictures(std::span<const PicturePart> parts, int width, int height, bool keep_alpha,
                                   std::span<const ImageText> texts) {
  assert(!parts.empty() && width > 0 && height > 0);
  OIIO::ImageSpec any;
  any.nchannels = 0;
  const Result<OpenPicture> first = open_part(parts.front(), width, height, any);
  if (!first) return first.status();
  if (first->format == PictureFormat::exr) return merge_exr(parts, width, height, texts);
  return first->spec.format == OIIO::TypeDesc::UINT16 ? merge_png<Image16>(parts, width, height, keep_alpha, texts)
                                                      : merge_png<Image>(parts, width, height, keep_alpha, texts);
}

}  // namespace pelage
