// AOVs of rasterized frames: which output is rasterized for each, and how the AOV is made from it.
#pragma once

#include <span>

#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/raster/raster_scene.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Returns the output from which an AOV is made.
RasterOutput output_of(Aov aov);

/// Returns the AOV at the frame's size. `drawn` is output_of(aov) at the size of the frame's light, and `parts` has the
/// strands from which it was drawn.
FloatImage aov_picture(const FurFrame& frame, Aov aov, const FloatImage& drawn, std::span<const GrownPart> parts,
                       int threads);

}  // namespace pelage
