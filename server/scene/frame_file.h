// The file of a frame: what is drawn for each format, and how it is encoded.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"

namespace pelage {

/// Milliseconds of each stage, for Server-Timing. Of a traced picture `draw` is of what lies under the strands.
struct FrameTimings {
  double queue = 0, upload = 0, shadow = 0, draw = 0, read = 0, encode = 0;
};

/// What the renderer gave for a format: 8 bit, 16 bit, or the layers that were asked for.
using DrawnPicture = std::variant<Image, Image16, std::vector<FloatImage>>;

/// On the render thread.
Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times);

/// The same of light that was traced, for all formats but EXR. Conflict where an overlay needs a model that the
/// renderer no longer has.
Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty);

/// From the renderer's coordinates to the model's own: internal * size + centre.
struct ModelPlacement {
  glm::dvec3 centre{0};
  double size = 1;
};

/// The picture as a file of the asked format; the same picture gives the same octets. EXR: the channels are R, G, B and A
/// of beauty, A of alpha, Z of depth, and LAYER.X, .Y, .Z (position, normal, tangent), LAYER.R, .G, .B (albedo, direct)
/// or LAYER.Y (shadow, layer_count) of the others.
std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const ModelPlacement& placement);

const char* content_type_of(FrameFormat format);

}  // namespace pelage
