// AOVs of rasterized frames: what is drawn for each, and what it is made of the drawing.
#pragma once

#include <span>

#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/raster/raster_scene.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

RasterOutput output_of(Aov aov);

/// The AOV at the frame's size; `drawn` has output_of(aov) at the size of the frame's light, and `parts` the strands
/// that it was drawn from.
FloatImage aov_picture(const FurFrame& frame, Aov aov, const FloatImage& drawn, std::span<const GrownPart> parts,
                       int threads);

}  // namespace pelage
