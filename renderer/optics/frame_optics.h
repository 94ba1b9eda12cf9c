// What a frame's light and colours are made of, as plain numbers: what uniform blocks and textures hold for the GPU.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "renderer/optics/azimuthal_fit.h"
#include "renderer/optics/base_images.h"
#include "renderer/optics/eye_optics.h"
#include "renderer/optics/shadow_optics.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/shading/scattering_table.h"
#include "renderer/upload/blocks.h"

namespace pelage {

/// Markings over the body (renderer/shaders/pattern.glsl).
struct PatternOptics {
  glm::vec3 colour{0}, inner_colour{0}, belly_colour{0};
  float over_lightness = 1;  // 1 / the largest luminance of the ramp
  glm::vec3 origin{0}, scale{1};
  const SurfaceVolume* volume = nullptr;  // null without a pattern
};

/// Tufts on the surface (renderer/shaders/tufts.glsl).
struct TuftOptics {
  float gather = 0, longest = 0;  // at the tip; the longest pull, sizes
  glm::vec3 origin{0}, scale{1};
  const SurfaceVolume* volume = nullptr;  // null without tufts
};

/// The coat's own numbers that paint adds to (renderer/shaders/paint.glsl), and its clumps (ClumpMap).
struct PaintOptics {
  float wetness = 0, curl = 0, curl_turns = 0, clump_reach = 0;
  int clump_side = 1;
  std::span<const std::int32_t> clumps;  // four bytes each
  bool form = false, colour = false;     // what is painted at all
};

/// Views that outlive the frame's drawing.
struct FrameOptics {
  FrameBlock frame;
  ScatteringBlock scattering;
  SkinBlock skin;                           // regions of bare skin
  const AzimuthalFit* azimuthal = nullptr;  // never null; empty for models that need none
  int model = 0;                            // ShadingModel
  int lights = 0;
  bool environment = false;            // whether light from all around is other than white
  bool far_lights = true;              // none stands at a place
  bool model_colours = false;          // whether fur takes the model's colours
  const BaseImages* images = nullptr;  // the model's, where fur or skin takes them; null for none
  PatternOptics pattern;
  TuftOptics tufts;
  PaintOptics paint;
  std::span<const ShadowCaster> casters;  // of each light; empty where none casts a shadow
  EyeOptics eyes;
};

}  // namespace pelage
