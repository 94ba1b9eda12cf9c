#include "server/frames/frame_file.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "renderer/image/float_image.h"
#include "renderer/image/image.h"

namespace pelage {

namespace {

template <class Picture>
Result<DrawnPicture> drawn(Result<Picture> picture) {
  if (!picture) return picture.status();
  return DrawnPicture(std::move(picture).value());
}

void place_in_model(FloatImage& position, const ModelPlacement& placement) {
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
    depth.rgba[i] = over > 0 ? static_cast<float>(placement.size / double{over}) : std::numeric_limits<float>::infinity();
  }
}

struct Channels {
  std::string prefix, names;  // "normal.", "XYZ"
};

Channels channels_of(FrameLayer layer) {
  switch (layer) {
    case FrameLayer::beauty: return {"", "RGBA"};
    case FrameLayer::alpha: return {"", "A"};
    case FrameLayer::depth: return {"", "Z"};
    case FrameLayer::position: return {"position.", "XYZ"};
    case FrameLayer::normal: return {"normal.", "XYZ"};
    case FrameLayer::tangent: return {"tangent.", "XYZ"};
    case FrameLayer::albedo: return {"albedo.", "RGB"};
    case FrameLayer::direct: return {"direct.", "RGB"};
    case FrameLayer::shadow: return {"shadow.", "Y"};
    case FrameLayer::layer_count: return {"layer_count.", "Y"};
  }
  assert(false);
  return {};
}

/// Half would lose what lies behind: depth and position are always single.
ExrSample sample_of(FrameLayer layer, ExrType type) {
  const bool place = layer == FrameLayer::depth || layer == FrameLayer::position;
  return place || type == ExrType::single ? ExrSample::single : ExrSample::half;
}

void add_planes(const FloatImage& image, FrameLayer layer, ExrType type, std::vector<ExrPlane>& planes) {
  const Channels channels = channels_of(layer);
  for (std::size_t k = 0; k < channels.names.size(); ++k) {
    const std::size_t offset = layer == FrameLayer::alpha ? 3 : k;
    planes.push_back({channels.prefix + channels.names[k], image.rgba, offset, 4, sample_of(layer, type)});
  }
}

std::string encode_layers(std::vector<FloatImage> images, const FrameRequest& request, const ModelPlacement& placement) {
  assert(images.size() == request.layers.size() && !images.empty());
  const auto asked = [&](FrameLayer l) { return std::find(request.layers.begin(), request.layers.end(), l) != request.layers.end(); };
  std::vector<ExrPlane> planes;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const FrameLayer layer = request.layers[i];
    if (layer == FrameLayer::position) place_in_model(images[i], placement);
    if (layer == FrameLayer::depth) measure_in_model(images[i], placement);
    const bool in_beauty = layer == FrameLayer::alpha && asked(FrameLayer::beauty);
    if (!in_beauty) add_planes(images[i], layer, request.exr_type, planes);
  }
  return encode_exr(images.front().width, images.front().height, planes);
}

}  // namespace

Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times, const Pause& pause) {
  switch (request.format) {
    case FrameFormat::png:
    case FrameFormat::jpeg: return drawn(renderer.draw(frame, &times, pause));
    case FrameFormat::png16: return drawn(renderer.draw_deep(frame, &times, pause));
    case FrameFormat::exr: return drawn(renderer.draw_layers(frame, request.layers, &times, pause));
  }
  assert(false);
  return failure(Code::internal, "no such format");
}

Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty) {
  assert(request.format != FrameFormat::exr);
  if (frame.overlay != Overlay::none && !renderer.has(frame.model)) {
    return failure(Code::conflict, "the scene has another model since the frame was asked for");
  }
  if (request.format == FrameFormat::png16) return drawn(renderer.finish_deep(frame, beauty));
  return drawn(renderer.finish(frame, beauty));
}

std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const ModelPlacement& placement,
                         PngEncoder& png) {
  const bool keep_alpha = request.background == Background::transparent;
  if (auto* layers = std::get_if<std::vector<FloatImage>>(&picture)) return encode_layers(std::move(*layers), request, placement);
  if (const auto* deep = std::get_if<Image16>(&picture)) return encode_png(*deep, keep_alpha);
  Image& image = std::get<Image>(picture);
  if (request.format == FrameFormat::jpeg) return encode_jpeg(image, request.jpeg_quality);
  return png.encode(std::move(image), keep_alpha);
}

const char* content_type_of(FrameFormat format) {
  switch (format) {
    case FrameFormat::png:
    case FrameFormat::png16: return "image/png";
    case FrameFormat::jpeg: return "image/jpeg";
    case FrameFormat::exr: return "image/x-exr";
  }
  assert(false);
  return "application/octet-stream";
}

}  // namespace pelage
