// Draws and encodes a frame for each file format.
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

/// The renderer's output for a format: 8 bits, 16 bits, or the requested AOVs.
using DrawnPicture = std::variant<Image, Image16, std::vector<FloatImage>>;

/// Refuses (invalid) a request that no file can be made of: one with an unknown colour space.
Status can_encode(const FrameRequest& request);

/// Draws a frame for the request's format. Called on the render thread.
Result<DrawnPicture> draw_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                     DrawTimes& times, const Pause& pause = {});

/// Finishes traced radiance as draw_for_format finishes a drawn picture, for all formats but linear ones. Fails
/// (conflict) if an overlay needs a model that the renderer no longer has.
Result<DrawnPicture> finish_for_format(Renderer& renderer, const FurFrame& frame, const FrameRequest& request,
                                       const FloatImage& beauty);

/// Returns the AOVs of a whole frame, cropped if the request has a crop.
DrawnPicture crop_of(const std::vector<FloatImage>& aovs, const FrameRequest& request);

/// Encodes the picture as a file of the requested format; the same picture gives the same bytes. The channels of an EXR
/// are R, G, B and A of beauty, A of alpha, Z of depth, AOV.X, .Y, .Z of position, normal and tangent, AOV.R, .G, .B of
/// albedo and direct, AOV.Y of shadow and sample_count, and those of Cryptomatte. The request must pass can_encode.
/// `png` caches 8-bit pictures. PNG and EXR contain the texts, an EXR the frame's camera too. `knobs` are those that
/// the picture was drawn with; they determine the quality of a lossy format unless the request states one.
std::string encode_frame(DrawnPicture picture, const FrameRequest& request, const Knobs& knobs, const FurFrame& frame,
                         const ModelPlacement& placement, PngEncoder& png, std::span<const ImageText> texts = {});

const char* content_type_of(FrameFormat format);

}  // namespace pelage
