// The scene of one frame of rasterized strands, as plain arrays that threads read; and strands placed on its picture.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/limits.h"
#include "renderer/input/picture.h"
#include "renderer/input/raster_quality.h"
#include "renderer/optics/eye_cache.h"
#include "renderer/optics/frame_optics.h"
#include "renderer/raster/density_grid.h"
#include "renderer/raster/near_cells.h"
#include "renderer/raster/sky_over_ground.h"
#include "renderer/raster/tiles.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Projects a position to the picture: to pixels right and down from its upper left corner, and to 1 / distance along
/// the view.
struct PictureCamera {
  glm::vec3 position{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  float scale = 1;      // pixels that a length of 1 size covers at distance 1
  glm::vec2 middle{0};  // centre of the picture, pixels
};

/// What a picture shows of strands, skin and eyes: means over each pixel, premultiplied unless stated otherwise.
enum class RasterOutput {
  light,
  albedo,
  normal,    // normal of the skin; for a strand, at its root
  tangent,   // tangent of strands, towards the tip
  direct,    // light from lights alone, without the environment
  triangle,  // red: index of the visible triangle of the model; skin alone
  field,     // RasterScene::field at a strand's root or on the skin
  shadow,    // red: luminance of direct light, green: the same without shadows
  distance,  // red: distance along the view
  depth,     // red: 1 / distance of what takes the transmittance below one half; not premultiplied
  count,     // red: number of segments that were blended; not premultiplied
  strand,    // the strand that covers most of a pixel; red: number from 1, green: [0, 1] along it, blue: coat_number
  objects    // red, green, blue: coverage of three objects, RasterScene::first_object and the next two
};
/// Returns whether an output is proportional to the colour of strands.
constexpr bool is_coloured(RasterOutput output) {
  return output == RasterOutput::light || output == RasterOutput::direct || output == RasterOutput::albedo;
}
/// Returns whether strands have a value of the output at each knot (PlacedKnot::light), such as light or a normal.
constexpr bool has_knot_values(RasterOutput output) {
  return output != RasterOutput::triangle && output != RasterOutput::distance && output != RasterOutput::depth &&
         output != RasterOutput::count && output != RasterOutput::strand;
}

/// Returns the number of a part's coat in pictures: its CoatId plus 1; limits::coats + 1 for curves.
inline float coat_number(const GrownPart& part) {
  return static_cast<float>(part.role == StrandRole::curve ? limits::coats + 1 : part.coat + std::size_t{1});
}

/// Returns the object (fur_scene.h) to which the strands of a part belong.
inline std::size_t object_of(std::span<const NamedCoat> coats, const GrownPart& part) {
  if (part.role == StrandRole::curve) return curves_object;
  const auto is_it = [&](const NamedCoat& one) { return one.id == part.coat; };
  return first_coat_object + static_cast<std::size_t>(std::ranges::find_if(coats, is_it) - coats.begin());
}

/// How wide a light appears; a directional light looks the same from everywhere.
struct LightSize {
  float radius = 0;  // sizes; for a directional light, the tangent of its half angle
  bool far = true;   // the light is directional
};

/// Quantizes 1 / distance along the view to 16-bit sort keys, in roughly relative steps. The range holds for the whole
/// frame, so that the order of two segments does not depend on which part of it is drawn.
struct DistanceKeys {
  static constexpr std::uint32_t end = 1 << 16;
  std::uint32_t furthest = 0;  // bits of 1 / the furthest distance, as a float
  int shift = 0;

  DistanceKeys() = default;
  /// `far` and `near` are 1 over the largest and the smallest distance, both above 0.
  DistanceKeys(float far, float near) : furthest(std::bit_cast<std::uint32_t>(far)) {
    while ((std::bit_cast<std::uint32_t>(near) - furthest) >> shift >= end) ++shift;
  }
  /// Returns the key of 1 / distance, below `end`; nearer is smaller.
  std::uint32_t of(float inverse) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(inverse);
    return end - 1 - std::min((bits - std::min(furthest, bits)) >> shift, end - 1);
  }
};

struct RasterScene {
  FrameOptics optics;
  int width = 0, height = 0;  // of the picture, pixels
  float oversampling = 1;     // pixels of the picture along a side of a shown pixel, at least 1: sets the skin's detail
  PictureCamera camera;
  RasterQuality quality;
  RasterOutput output = RasterOutput::light;
  const FurModel* model = nullptr;  // never null
  std::span<const GrownPart> parts;
  FurBend bend;                                   // bend that the strands of the parts still need; for the GPU
  const TileMask* drawn = nullptr;                // tiles to draw; null for all
  DistanceKeys keys;                              // for the range of distances of the parts
  std::span<const std::array<SkinLook, 3>> skin;  // corners of each triangle of the model
  std::span<const glm::vec3> field;               // for each vertex; RasterOutput::field alone
  std::size_t first_object = 0;                   // first of the three that RasterOutput::objects shows
  std::span<const NamedCoat> coats;               // FurFrame::coats, to which the parts belong
  std::optional<GridLayout> cells;                // grid of the shadows; none if nothing casts any
  std::span<const FurLight> lights;               // lights with shadows
  // Shadows on the CPU: of fur and body, and of single strands of parts that are near.
  const DensityGrid* grid = nullptr;
  const NearCells* near = nullptr;
  std::vector<EyeCamera> eyes;  // the camera in the frame of each of optics.eyes
  std::optional<FurGround> ground;
  const SkyOverGround* sky = nullptr;  // not null on the CPU if there is a ground
  std::array<LightSize, 8> light_sizes{};
};

/// A knot of a strand, projected to the picture.
struct PlacedKnot {
  float x = 0, y = 0;                    // pixels
  float inverse = 0;                     // 1 / distance along the view; 0 if too near to be drawn
  float half_width = 0;                  // pixels
  std::array<std::uint16_t, 4> light{};  // red, green, blue in half floats
};
static_assert(sizeof(PlacedKnot) == 24);

/// Strands of some parts, projected to the picture.
struct PlacedStrands {
  std::vector<PlacedKnot> knots;
  std::vector<float> along;          // position of each knot along its strand: 0 at the root, 1 at the tip
  std::vector<std::uint32_t> first;  // index of each strand's first knot; one more at the end

  std::size_t bytes() const {
    return knots.capacity() * sizeof(PlacedKnot) + along.capacity() * sizeof(float) +
           first.capacity() * sizeof(std::uint32_t);
  }
  void clear() { knots.clear(), along.clear(), first.clear(); }
};

}  // namespace pelage
