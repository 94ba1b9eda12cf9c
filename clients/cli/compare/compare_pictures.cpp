#include "clients/cli/compare/compare_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/limits.h"
#include "clients/cli/terminal/files.h"
#include "renderer/compare/compare.h"
#include "renderer/picture_files/picture_files.h"

namespace pelage {

namespace {

Result<FloatImage> read_picture(const std::string& path) {
  constexpr std::size_t max_bytes = std::size_t{2} << 30;
  constexpr std::size_t max_pixels = std::size_t{limits::frame_pixels} * limits::frame_pixels;
  const auto bytes = read_file(path, max_bytes);
  if (!bytes) return bytes.status();
  auto picture = picture_files().decode_float_image(std::as_bytes(std::span(*bytes)), max_pixels);
  if (picture) return picture;
  Status status = picture.status();
  status.message = path + ": " + status.message;
  return status;
}

bool is_opaque(const FloatImage& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] != 1) return false;
  }
  return true;
}

Result<Mask> mask_for(const Options& options, const FloatImage& reference, const FloatImage& test) {
  if (options.mask.empty()) {
    const bool same_size = reference.width == test.width && reference.height == test.height;
    // Masks of different sizes have no union; compare() refuses such pictures.
    return same_size ? union_of(alpha_mask(reference), alpha_mask(test)) : alpha_mask(reference);
  }
  const auto picture = read_picture(options.mask);
  if (!picture) return picture.status();
  return is_opaque(*picture) ? luminance_mask(*picture) : alpha_mask(*picture);
}

Result<PictureError> measure(const Options& options) {
  if (const Status bad = options.map.empty() ? Status{} : check_output(options.map); !bad.ok()) return bad;
  const auto reference = read_picture(options.reference);
  if (!reference) return reference.status();
  const auto test = read_picture(options.test);
  if (!test) return test.status();
  const auto mask = mask_for(options, *reference, *test);
  if (!mask) return mask.status();
  const ToneMap tone_map = options.tone_map == "none" ? ToneMap::none : ToneMap::filmic;
  auto error = compare(*reference, *test, *mask, {.tone_map = tone_map});
  if (error && !error->figures) {
    return failure(Code::invalid,
                   fmt::format("{} pixels are NaN or infinite; such pictures cannot be compared.", error->non_finite));
  }
  if (error && !options.map.empty()) {
    const std::string png = encode_png(error_picture(error->flip, reference->width, reference->height), false);
    if (Status status = write_file(options.map, png); !status.ok()) return status;
  }
  return error;
}

std::string json_of(const FlipFigures& flip) {
  return fmt::format(R"({{"mean":{:.7g},"percentile_95":{:.7g}}})", flip.mean, flip.percentile_95);
}

/// Prints the figures of a comparison. `error.figures` must not be null.
void print(const PictureError& error) {
  const PictureFigures& figures = *error.figures;
  fmt::print("FLIP        mean {:.4f}, 95th percentile {:.4f}\n", figures.flip.mean, figures.flip.percentile_95);
  if (figures.silhouette) {
    fmt::print("silhouette     mean {:.4f}, 95th percentile {:.4f}\n", figures.silhouette->mean,
               figures.silhouette->percentile_95);
  } else {
    fmt::print("silhouette     none in the mask\n");
  }
  fmt::print("relMSE      {:.6g}\nRMSE        {:.6g}\n", figures.rel_mse, figures.rmse);
  fmt::print("bias        {:+.6g} of a mean luminance of {:.6g}\n", figures.bias, figures.reference_luminance);
  fmt::print("coverage    {:.2f} %, {} pixels\nnot finite  {}\n", 100 * error.coverage, error.pixels, error.non_finite);
}

void print_json(const PictureError& error) {
  const PictureFigures& figures = *error.figures;
  fmt::print(
      R"({{"flip":{},"silhouette":{},"rel_mse":{:.7g},"rmse":{:.7g},"bias":{:.7g},"reference_luminance":{:.7g},)",
      json_of(figures.flip), figures.silhouette ? json_of(*figures.silhouette) : "null", figures.rel_mse, figures.rmse,
      figures.bias, figures.reference_luminance);
  fmt::print("\"coverage\":{:.7g},\"pixels\":{},\"non_finite\":{}}}\n", error.coverage, error.pixels, error.non_finite);
}

}  // namespace

ExitCode compare_pictures(const Options& options) {
  const auto error = measure(options);
  if (!error) return report(error.status());
  if (options.json)
    print_json(*error);
  else
    print(*error);
  return done;
}

}  // namespace pelage
