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

/// Refuses (invalid) what no file can be made of: a colour space that there is not.
Status can_encode(const FrameRequest& request);

/// On the render thread.
Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times, const Pause& pause = {});

/// Finishes traced light as draw_for_format finishes drawn light, for all formats but linear ones. Returns conflict if
/// an overlay needs a model that the renderer no longer has.
Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty);

/// AOVs of a whole frame, as they were traced, for a request that may have a crop.
DrawnPicture crop_of(const std::vector<FloatImage>& aovs, const FrameRequest& request);

/// Encodes the picture as a file of the requested format; the same picture gives the same bytes. The channels of an EXR
/// are R, G, B and A of beauty, A of alpha, Z of depth, AOV.X, .Y, .Z of position, normal and tangent, AOV.R, .G, .B of
/// albedo and direct, AOV.Y of shadow and sample_count, and those of Cryptomatte. The request passes can_encode. `png`
/// remembers 8-bit pictures. PNG and EXR carry the texts, an EXR the frame's camera too. `knobs` are those that the
/// picture was drawn with: they determine the quality of a lossy format, unless the request names one.
std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const Knobs& knobs, const FurFrame& frame,
                         const ModelPlacement& placement, PngEncoder& png, std::span<const ImageText> texts = {});

const char* content_type_of(FrameFormat format);

}  // namespace pelage
