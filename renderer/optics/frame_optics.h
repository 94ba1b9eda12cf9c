// The light and colours of a frame on the CPU: the data that uniform blocks and textures hold on the GPU.
#pragma once

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/optics/base_images.h"
#include "renderer/optics/eye_cache.h"
#include "renderer/shading/scattering_table.h"
#include "renderer/upload/blocks.h"

namespace pelage {

/// The views must outlive the drawing of the frame.
struct FrameOptics {
  FrameBlock frame;
  ScatteringBlock scattering;
  SkinBlock skin;                           // regions of bare skin
  const AzimuthalFit* azimuthal = nullptr;  // never null; empty for models that need none
  int model = 0;                            // ShadingModel
  int lights = 0;
  bool directional_lights = true;      // no light has a position
  bool model_colours = false;          // fur takes the model's colours
  const BaseImages* images = nullptr;  // the model's images if fur or skin takes them; null for none
  float wetness = 0;                   // of the coat, [0, 1]
  EyeOptics eyes;
};

}  // namespace pelage
