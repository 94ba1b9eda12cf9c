// What one frame of rasterized strands is drawn from: plain arrays that threads read.
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

/// From a place to the picture: pixels right and down of its corner, and one over the distance along the view.
struct PictureCamera {
  glm::vec3 position{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  float scale = 1;      // pixels of a size at distance 1
  glm::vec2 middle{0};  // of the picture, pixels
};

/// What a picture shows of strands, skin and eyes: means over each pixel, premultiplied.
enum class RasterOutput {
  light,
  albedo,
  normal,    // of the skin below
  tangent,   // of strands, towards the tip
  direct,    // what lights add
  piece,     // red: number of the model's piece that is seen, of skin alone
  field,     // RasterScene::field at the root or on the skin
  shadow,    // red: the luminance of that, green: what it would be without shadows
  distance,  // red: along the view
  depth,     // red: one over the distance of the first that leaves less than half of a pixel open; not premultiplied
  count,     // red: segments of strands that were blended; not premultiplied
  strand,    // that covers most of a pixel: red: its number from 1 on, green: where on it, blue: its coat_number
  objects    // red, green, blue: the shares of three objects, from RasterScene::first_object on
};
/// Returns whether it goes as the colour of strands does.
constexpr bool is_coloured(RasterOutput shown) {
  return shown == RasterOutput::light || shown == RasterOutput::direct || shown == RasterOutput::albedo;
}
/// Returns whether strands send something of their own, from knot to knot.
constexpr bool sends(RasterOutput shown) {
  return shown != RasterOutput::piece && shown != RasterOutput::distance && shown != RasterOutput::depth &&
         shown != RasterOutput::count && shown != RasterOutput::strand;
}

/// As pictures name the coat of a part: its number plus 1; limits::coats + 1 for curves.
inline float coat_number(const GrownPart& part) {
  return static_cast<float>(part.role == StrandRole::curve ? limits::coats + 1 : part.coat + std::size_t{1});
}

/// The object (fur_scene.h) that the strands of a part are.
inline std::size_t object_of(std::span<const NamedCoat> coats, const GrownPart& part) {
  if (part.role == StrandRole::curve) return curves_object;
  const auto is_it = [&](const NamedCoat& one) { return one.id == part.coat; };
  return first_coat_object + static_cast<std::size_t>(std::ranges::find_if(coats, is_it) - coats.begin());
}

/// How wide a light is from a place: a far one the same from all.
struct LightSize {
  float radius = 0;  // sizes; of a far light the tangent of its half angle
  bool far = true;
};

/// Distances along the view in steps of about their share, for the whole of a frame: the order of two segments does not
/// depend on what else is drawn.
struct DistanceKeys {
  static constexpr std::uint32_t end = 1 << 16;
  std::uint32_t furthest = 0;  // bits of one over it
  int shift = 0;

  DistanceKeys() = default;
  /// One over the distances, above 0, between which all lies.
  DistanceKeys(float far, float near) : furthest(std::bit_cast<std::uint32_t>(far)) {
    while ((std::bit_cast<std::uint32_t>(near) - furthest) >> shift >= end) ++shift;
  }
  /// Below `end`, nearest first.
  std::uint32_t of(float inverse) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(inverse);
    return end - 1 - std::min((bits - std::min(furthest, bits)) >> shift, end - 1);
  }
};

struct RasterScene {
  FrameOptics optics;
  int width = 0, height = 0;  // of the picture, pixels
  float oversampling = 1;     // of its pixels along a side of one that is seen: the skin's relief is as fine as those
  PictureCamera camera;
  RasterQuality quality;
  RasterOutput shown = RasterOutput::light;
  const FurModel* model = nullptr;  // never null
  std::span<const GrownPart> parts;
  FurBend bend;                                   // that their strands are still to be bent by
  const TileMask* drawn = nullptr;                // tiles that are; null for all
  DistanceKeys keys;                              // of what the parts lie between
  std::span<const std::array<SkinLook, 3>> skin;  // of each piece of the model
  std::span<const glm::vec3> field;               // of each vertex, where it is shown
  std::size_t first_object = 0;                   // of those that are shown
  std::span<const NamedCoat> coats;               // of the parts, as FurFrame::coats
  std::optional<GridPlace> cells;                 // of what stands in the way of light; none where nothing does
  std::span<const FurLight> lights;               // that things stand in the way of
  // What stands there, for the CPU: of the fur and the body, and of single strands of parts that are near.
  const DensityGrid* grid = nullptr;
  const NearCells* near = nullptr;
  std::vector<EyeCamera> eyes;  // of optics.eyes
  std::optional<FurGround> ground;
  const SkyOverGround* sky = nullptr;  // over the ground, for the CPU
  std::array<LightSize, 8> light_sizes{};
};

/// A knot of a strand on the picture.
struct PlacedKnot {
  float x = 0, y = 0;                    // pixels
  float inverse = 0;                     // one over the distance along the view; 0 for what is too near to be drawn
  float half_width = 0;                  // pixels
  std::array<std::uint16_t, 4> light{};  // red, green, blue in half floats
};
static_assert(sizeof(PlacedKnot) == 24);

/// Strands of some parts as they lie on the picture.
struct PlacedStrands {
  std::vector<PlacedKnot> knots;
  std::vector<float> along;          // of each knot: where on its strand, 0 at the root, 1 at the tip
  std::vector<std::uint32_t> first;  // knot of each strand; one more at the end

  std::size_t bytes() const {
    return knots.capacity() * sizeof(PlacedKnot) + along.capacity() * sizeof(float) +
           first.capacity() * sizeof(std::uint32_t);
  }
  void clear() { knots.clear(), along.clear(), first.clear(); }
};

}  // namespace pelage
