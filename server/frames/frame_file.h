// The file of a frame: what is drawn for each format, and how it is encoded.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/image/png.h"
#include "server/frames/frame_parts.h"

namespace pelage {

/// What the renderer gave for a format: 8 bit, 16 bit, or the AOVs that were asked for.
using DrawnPicture = std::variant<Image, Image16, std::vector<FloatImage>>;

/// On the render thread.
Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times, const Pause& pause = {});

/// The same of light that was traced, for all formats but EXR. Conflict where an overlay needs a model that the
/// renderer no longer has.
Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty);

/// AOVs of a whole frame, as they were traced, for a request that may have a crop.
DrawnPicture crop_of(const std::vector<FloatImage>& aovs, const FrameRequest& request);

/// The picture as a file of the asked format; the same picture gives the same bytes. EXR: the channels are R, G, B and
/// A of beauty, A of alpha, Z of depth, and AOV.X, .Y, .Z (position, normal, tangent), AOV.R, .G, .B (albedo, direct)
/// or AOV.Y (shadow, sample_count) of the others. `png` remembers pictures of 8 bits. PNG and EXR carry the texts.
/// `knobs` are those that it was drawn with: what is lossy keeps as much as they do.
std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const Knobs& knobs,
                         const ModelPlacement& placement, PngEncoder& png, std::span<const ImageText> texts = {});

const char* content_type_of(FrameFormat format);

}  // namespace pelage
