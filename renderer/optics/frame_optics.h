// What a frame's light and colours are made of, as plain numbers: what uniform blocks and textures hold for the GPU.
#pragma once

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/optics/base_images.h"
#include "renderer/optics/eye_cache.h"
#include "renderer/shading/scattering_table.h"
#include "renderer/upload/blocks.h"

namespace pelage {

/// Views that outlive the frame's drawing.
struct FrameOptics {
  FrameBlock frame;
  ScatteringBlock scattering;
  SkinBlock skin;                           // regions of bare skin
  const AzimuthalFit* azimuthal = nullptr;  // never null; empty for models that need none
  int model = 0;                            // ShadingModel
  int lights = 0;
  bool far_lights = true;              // no light has a position
  bool model_colours = false;          // whether fur takes the model's colours
  const BaseImages* images = nullptr;  // the model's, where fur or skin takes them; null for none
  float wetness = 0;                   // of the coat, [0, 1]
  EyeOptics eyes;
};

}  // namespace pelage
