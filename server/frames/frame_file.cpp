#include "server/frames/frame_file.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/cropped.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/image/npy.h"
#include "renderer/picture_files/picture_files.h"
#include "server/frames/cryptomatte.h"
#include "server/frames/linear_picture.h"

namespace pelage {

namespace {

template <class Picture>
Result<DrawnPicture> drawn(Result<Picture> picture) {
  if (!picture) return picture.status();
  return DrawnPicture(std::move(picture).value());
}

void to_model_space(FloatImage& position, const ModelPlacement& placement) {
  for (std::size_t i = 0; i < position.rgba.size(); i += 4) {
    if (!(position.rgba[i + 3] > 0)) continue;
    for (int k = 0; k < 3; ++k) {
      float& value = position.rgba[i + static_cast<std::size_t>(k)];
      value = static_cast<float>(double{value} * placement.size + placement.centre[k]);
    }
  }
}

void measure_in_model(FloatImage& depth, const ModelPlacement& placement) {
  for (std::size_t i = 0; i < depth.rgba.size(); i += 4) {
    const float over = depth.rgba[i];
    depth.rgba[i] =
        over > 0 ? static_cast<float>(placement.size / double{over}) : std::numeric_limits<float>::infinity();
  }
}

struct Channels {
  std::string prefix;
  std::vector<std::string> names;
};

Channels channels_of(Aov aov) {
  switch (aov) {
    case Aov::beauty: return {"", {"R", "G", "B", "A"}};
    case Aov::alpha: return {"", {"A"}};
    case Aov::depth: return {"", {"Z"}};
    case Aov::position: return {"position.", {"X", "Y", "Z"}};
    case Aov::normal: return {"normal.", {"X", "Y", "Z"}};
    case Aov::tangent: return {"tangent.", {"X", "Y", "Z"}};
    case Aov::albedo: return {"albedo.", {"R", "G", "B"}};
    case Aov::direct: return {"direct.", {"R", "G", "B"}};
    case Aov::shadow: return {"shadow.", {"Y"}};
    case Aov::sample_count: return {"sample_count.", {"Y"}};
    case Aov::strand: return {"strand.", {"id", "along", "coat"}};
    case Aov::root: return {"root.", {"X", "Y", "Z"}};
    case Aov::cryptomatte:
    case Aov::objects_1:
    case Aov::objects_2:
    case Aov::objects_3:
    case Aov::objects_4: break;  // Cryptomatte::planes
  }
  assert(false);
  return {};
}

/// Returns the sample type of an AOV. Half floats would lose distant positions and depths, and strand numbers.
ExrSample sample_of(Aov aov, ExrType type) {
  const bool single = aov == Aov::depth || aov == Aov::position || aov == Aov::strand || aov == Aov::root;
  return single || type == ExrType::single ? ExrSample::single : ExrSample::half;
}

void add_planes(const FloatImage& image, Aov aov, ExrType type, std::vector<ExrPlane>& planes) {
  const Channels channels = channels_of(aov);
  for (std::size_t k = 0; k < channels.names.size(); ++k) {
    const std::size_t offset = aov == Aov::alpha ? 3 : k;
    planes.push_back({channels.prefix + channels.names[k], image.rgba, offset, 4, sample_of(aov, type)});
  }
}

std::vector<std::size_t> array_shape(int width, int height, std::size_t channels) {
  return {static_cast<std::size_t>(height), static_cast<std::size_t>(width), channels};
}

std::string encode_array(const Image& image) {
  return encode_npy(array_shape(image.width, image.height, 4), std::span(image.rgba));
}

std::string encode_array(int width, int height, const std::vector<ExrPlane>& planes) {
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * planes.size());
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const ExrPlane& plane = planes[k];
    for (std::size_t i = 0; i * planes.size() < values.size(); ++i)
      values[i * planes.size() + k] = plane.values[plane.offset + i * plane.stride];
  }
  return encode_npy(array_shape(width, height, planes.size()), std::span(std::as_const(values)));
}

/// Returns the camera's matrices, for row vectors in the model's coordinates.
ExrCamera exr_camera(const FurCamera& camera, const ModelPlacement& placement, double aspect) {
  const glm::dvec3 right(camera.right), up(camera.up), forward(camera.forward);
  const double high = double{camera.tan_half_fov}, wide = aspect * high;
  const glm::dvec3 position = glm::dvec3(camera.position) * placement.size + placement.centre;
  // Homogeneous NDC: maps x / z from [-wide, wide] to [0, 1], and y / z from [high, -high] to [0, 1].
  const std::array<glm::dvec3, 4> to_camera{right, up, forward, glm::dvec3(0)};
  const std::array<glm::dvec3, 4> to_ndc{right / (2 * wide) + 0.5 * forward, 0.5 * forward - up / (2 * high), forward,
                                         forward};
  const auto rows = [&](const std::array<glm::dvec3, 4>& columns, double last) {
    std::array<float, 16> matrix{};
    for (std::size_t c = 0; c < 4; ++c) {
      for (int r = 0; r < 3; ++r) matrix[4 * static_cast<std::size_t>(r) + c] = static_cast<float>(columns[c][r]);
      matrix[12 + c] = static_cast<float>(-glm::dot(position, columns[c]));
    }
    matrix[15] += static_cast<float>(last);
    return matrix;
  };
  return {rows(to_camera, 1), rows(to_ndc, 0)};
}

bool is_coloured(Aov aov) { return aov == Aov::beauty || aov == Aov::albedo || aov == Aov::direct; }

ExrWindow window_of(const FloatImage& drawn, const FrameRequest& request, const FurCamera& camera,
                    const ModelPlacement& placement) {
  const Crop crop = request.crop.value_or(Crop());
  const double aspect = static_cast<double>(request.width) / request.height;
  return {drawn.width,
          drawn.height,
          crop.left,
          crop.top,
          request.width,
          request.height,
          exr_camera(camera, placement, aspect)};
}

std::string encode_aovs(std::vector<FloatImage> images, const FrameRequest& request, const FurFrame& frame,
                        const ModelPlacement& placement, std::vector<ImageText> texts) {
  const std::vector<Aov> aovs = linear_aovs(request);
  assert(images.size() == aovs.size() && !images.empty());
  const auto asked = [&](Aov l) { return std::ranges::find(aovs, l) != aovs.end(); };
  std::vector<ExrPlane> planes;
  std::optional<Cryptomatte> matte;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const Aov aov = aovs[i];
    if (aov == Aov::position || aov == Aov::root) to_model_space(images[i], placement);
    if (aov == Aov::depth) measure_in_model(images[i], placement);
    if (is_coloured(aov) && !request.colour_space.empty()) {
      [[maybe_unused]] const Status converted = picture_files().to_colour_space(request.colour_space, images[i].rgba);
      assert(converted.ok());
    }
    if (aov == Aov::objects_1) matte.emplace(frame, std::span(images).subspan(i, 4));
    const bool in_beauty = aov == Aov::alpha && asked(Aov::beauty);
    if (!in_beauty && aov < Aov::cryptomatte) add_planes(images[i], aov, request.exr_type, planes);
  }
  if (matte) std::ranges::move(matte->planes(), std::back_inserter(planes));
  if (matte) std::ranges::move(matte->texts(), std::back_inserter(texts));
  if (!request.colour_space.empty()) texts.push_back({colour_space_text, request.colour_space});
  const FloatImage& first = images.front();
  if (request.format != FrameFormat::exr) return encode_array(first.width, first.height, planes);
  return picture_files().encode_exr(window_of(first, request, frame.camera, placement), planes, texts);
}

}  // namespace

Status can_encode(const FrameRequest& request) {
  if (request.colour_space.empty()) return {};
  return picture_files().to_colour_space(request.colour_space, {});
}

Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times, const Pause& pause) {
  switch (request.format) {
    case FrameFormat::png:
    case FrameFormat::npy:
    case FrameFormat::jpeg:
    case FrameFormat::webp: return drawn(renderer.draw(frame, &times, pause));
    case FrameFormat::png16: return drawn(renderer.draw_deep(frame, &times, pause));
    case FrameFormat::npy_linear:
    case FrameFormat::exr: return drawn(renderer.draw_aovs(frame, linear_aovs(request), &times, pause));
  }
  assert(false);
  return failure(Code::internal, "no such format");
}

Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty) {
  assert(!is_linear(request.format));
  if (frame.overlay != Overlay::none && !renderer.has(frame.model)) {
    return failure(Code::conflict, "the scene has another model since the frame was asked for");
  }
  if (request.format == FrameFormat::png16) return drawn(renderer.finish_deep(frame, beauty));
  return drawn(renderer.finish(frame, beauty));
}

DrawnPicture crop_of(const std::vector<FloatImage>& aovs, const FrameRequest& request) {
  if (!request.crop) return aovs;
  const Crop& crop = *request.crop;
  std::vector<FloatImage> parts;
  for (const FloatImage& aov : aovs) parts.push_back(cropped(aov, crop.left, crop.top, crop.width, crop.height));
  return parts;
}

std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const Knobs& knobs, const FurFrame& frame,
                         const ModelPlacement& placement, PngEncoder& png, std::span<const ImageText> texts) {
  const bool keep_alpha = request.background == Background::transparent;
  if (auto* aovs = std::get_if<std::vector<FloatImage>>(&picture))
    return encode_aovs(std::move(*aovs), request, frame, placement, {texts.begin(), texts.end()});
  if (const auto* deep = std::get_if<Image16>(&picture)) return png.encode(*deep, keep_alpha, texts);
  Image& image = std::get<Image>(picture);
  const int quality = request.lossy_quality > 0 ? request.lossy_quality : lossy_quality(knobs);
  if (request.format == FrameFormat::jpeg) return picture_files().encode_jpeg(image, quality);
  if (request.format == FrameFormat::webp) return picture_files().encode_webp(image, quality);
  if (request.format == FrameFormat::npy) return encode_array(image);
  return png.encode(std::move(image), keep_alpha, texts);
}

const char* content_type_of(FrameFormat format) {
  switch (format) {
    case FrameFormat::png:
    case FrameFormat::png16: return "image/png";
    case FrameFormat::jpeg: return "image/jpeg";
    case FrameFormat::webp: return "image/webp";
    case FrameFormat::exr: return "image/x-exr";
    case FrameFormat::npy:
    case FrameFormat::npy_linear: return npy_type;
  }
  assert(false);
  return "application/octet-stream";
}

}  // namespace pelage
