#include "server/import_worker/read_picture.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "base/limits.h"
#include "renderer/light/environment.h"
#include "renderer/picture_files/picture_files.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

constexpr std::size_t max_pixels = std::size_t{limits::picture_pixels} * limits::picture_pixels;

Status check_sides(int width, int height) {
  if (std::max(width, height) <= limits::picture_pixels) return {};
  return broken("it has " + std::to_string(width) + " x " + std::to_string(height) + " pixels, over " +
                std::to_string(limits::picture_pixels) + " on a side.");
}

/// Reduces a status to its reason, because the server itself says what cannot be read.
Status reason_of(Status status) {
  if (status.message.starts_with(unreadable_picture)) status.message.erase(0, unreadable_picture.size());
  return status;
}

/// Parses the scale that the file gives; none unless it is a number in [1e-27, 1e27].
std::optional<double> scale_of(const std::string& text) {
  double scale = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), scale);
  const bool good = error == std::errc() && end == text.data() + text.size() && scale >= 1e-27 && scale <= 1e27;
  return good ? std::optional(scale) : std::nullopt;
}

}  // namespace

Result<SphericalHarmonics> read_environment(const std::string& bytes) {
  picture_files().read_exr_without_threads();
  const Result<FloatImage> image = picture_files().decode_float_image(std::as_bytes(std::span(bytes)), max_pixels);
  if (!image.ok()) return reason_of(image.status());
  if (image->display_referred)
    return broken("it is neither EXR nor HDR: a tone-mapped picture is no measure of light.");
  if (Status status = check_sides(image->width, image->height); !status.ok()) return status;
  return project_equirectangular(image->width, image->height, image->rgba);
}

int add_picture(RawModel& model, std::string_view bytes, const std::string& name) {
  constexpr std::size_t max_texture_pixels = std::size_t{8192} * 8192;
  Result<Image> image = picture_files().decode_image(std::as_bytes(std::span(bytes)), max_texture_pixels);
  if (!image.ok()) return model.add_loss("broken_pictures", name), -1;
  model.images.push_back({image->width, image->height, std::move(image->rgba)});
  return static_cast<int>(model.images.size()) - 1;
}

Result<RawImage> read_skin_texture(const std::string& bytes) {
  Result<Image> image = picture_files().decode_image(std::as_bytes(std::span(bytes)), max_pixels);
  if (!image.ok()) return reason_of(image.status());
  if (Status status = check_sides(image->width, image->height); !status.ok()) return status;
  return RawImage{image->width, image->height, std::move(image->rgba)};
}

Result<MapPicture> read_map_picture(const std::string& bytes) {
  picture_files().read_exr_without_threads();
  Result<DataImage> image =
      picture_files().decode_data_image(std::as_bytes(std::span(bytes)), max_pixels, map_scale_text);
  if (!image.ok()) return reason_of(image.status());
  const bool list = image->width == 1;  // one number for each vertex; there may be more than picture_pixels
  if (Status status = list ? Status{} : check_sides(image->width, image->height); !status.ok()) return status;
  const auto broken_numbers =
      std::count_if(image->rgba.begin(), image->rgba.end(), [](float value) { return !std::isfinite(value); });
  if (broken_numbers > 0) return broken(std::to_string(broken_numbers) + " of its numbers are NaN or infinite.");
  return MapPicture{image->width, image->height, image->bits, scale_of(image->text), std::move(image->rgba)};
}

}  // namespace pelage
