// AOVs of marched frames at the picture's size, and the picture that traced strands stand on.
#pragma once

#include <span>

#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/march_scene.h"
#include "renderer/strands/tracer.h"

namespace pelage {

/// Light as it was drawn, and what AOVs keep of its pixels.
struct MarchedAovs {
  FloatImage light;
  std::vector<AovPixel> pixels;
};

/// One AOV as Renderer::draw_aovs gives it: colours, alpha and count as means over a pixel of the picture; position,
/// normal, tangent and shadow as Aov says, with the coverage in the fourth number; depth as it is in the middle of the
/// pixel.
FloatImage aov_picture(const MarchedAovs& drawn, Aov aov, int width, int height, int threads);

/// The frame as its bare skin and eyes are drawn under traced strands: what knobs, the ground and curves would add is
/// left out. Twice the size where that is at most 2048 a side.
FurFrame backplate_frame(const FurFrame& frame);
Backplate backplate_of(MarchedAovs drawn, int threads);

}  // namespace pelage
