// A coat's sample tile: its clumps (tufts, locks inside them, lodged patches) and strands, with their tint and
// colours, and the effect of water on the coat.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/coat.h"
#include "protocol/commands/look.h"
#include "renderer/shaders/constants.h"

namespace pelage {

/// A clump with the values that its strands share.
struct StrandClump {
  glm::dvec2 centre{0};              // sizes
  glm::dvec2 bow{0};                 // direction and strength of the strands' bow, in the unit disc
  double length = 1, lightness = 1;  // relative deviations, [-1, 1]
  double pull = 1;                   // how strongly it gathers strands, [.25, 1]
};

/// The nearest clump, and the distances to it and to the next.
struct NearestClumps {
  StrandClump first;
  double to_first = 0, to_second = 0;  // sizes
};

class ClumpGrid {
 public:
  /// Makes clumps about `size` apart on a tile of side `tile`, both in sizes. Deterministic in all four arguments.
  ClumpGrid(double tile, double size, std::uint64_t seed, std::uint64_t stream);

  /// Returns the nearest clump on the periodic tile, with its centre moved by whole tiles to lie next to `position`.
  StrandClump nearest(glm::dvec2 position) const { return nearest_two(position).first; }
  NearestClumps nearest_two(glm::dvec2 position) const;

 private:
  int wrap(int i) const { return (i % side_ + side_) % side_; }

  double tile_;
  int side_;  // cells along a side
  std::vector<StrandClump> clumps_;
};

// The clumps of a coat's tile as a texture.

/// `side * side` texels of 4 bytes, x fastest, over the periodic tile: the vector to the middle of the position's clump
/// over +-reach (x, y), how far inside of the clump it lies (0 on the border to the next, 1 in the middle), and the
/// clump's pull (StrandClump).
struct ClumpMap {
  static constexpr int side = 256;
  std::vector<std::uint8_t> texels;
  double reach = 0;  // tiles
};

/// Bakes the map of the coat's clumps. Depends only on the coat; deterministic.
ClumpMap bake_clump_map(const Coat& coat);

// The fur texture generator: the strands of one periodic sample tile (fur modelling 4). Slices and traced strands are
// both made from them.

/// One strand. Positions are in sizes on the tile, before the lean; they may lie outside of [0, tile) and are taken
/// modulo the tile.
struct Strand {
  glm::dvec2 root{0};
  glm::dvec2 clump{0};       // from the root to the middle of its clump
  glm::dvec2 fine_clump{0};  // from the root to the middle of its lock inside the clump
  glm::dvec2 bow{0};         // offset of the tip by bend
  glm::dvec2 heading{0};     // offset of the tip by the direction at the root: mess and lodging
  glm::dvec2 wave{0};        // amplitude and direction of the sine
  double wave_phase = 0;     // radians
  double curl_phase = 0;     // radians
  double length_share = 1;   // share of the field's length, (0, 1]
  double width = 1;          // factor on the coat's
  double lightness = 1;      // factor on the ramp's colour
  double warmth = 1;         // red over blue, before lightness is corrected
  glm::vec3 own_colour{0};   // linear; for ticking and the undercoat
  float own_share = 0;       // share by which it replaces the ramp's colour, [0, 1]
  double number = 0;         // uniform in [0, 1): the strand grows if it is below the density
};

/// Makes the strands of a coat's tile; deterministic. A setting at its neutral value does not change what the other
/// settings give.
std::vector<Strand> make_strands(const Coat& coat);

/// Returns the expected number of a coat's strands on an area of its sample tile, sizes^2, at full density.
inline double expected_strands(double area, const Coat& coat) { return area * coat.count / (coat.tile * coat.tile); }

/// Returns the offset from the root at `q` in [0, 1] along the strand, sizes, without the pull towards its clump and
/// lock.
glm::dvec2 free_offset(const Coat& coat, const Strand& strand, double q);

/// Returns the offset from the root at `q` in [0, 1] along the strand, sizes.
glm::dvec2 strand_offset(const Coat& coat, const Strand& strand, double q);

/// Returns the factor on a strand's colour: its lightness, and its warmth at unchanged luminance.
glm::vec3 strand_tint(const Strand& strand);

/// Returns the coat's ramp at `q` in [0, 1] as a linear colour; wet coats are darker.
glm::vec3 ramp_colour(const Coat& coat, double q);

/// Returns the strand's linear colour at `q` in [0, 1], from the ramp or its own; may exceed 1.
glm::vec3 strand_colour(const Coat& coat, const Strand& strand, double q);

/// Returns true if both coats give the same strands: patterns, variation and the lean do not count.
bool same_strands(const Coat& a, const Coat& b);

/// Returns the length along a strand over its straight length, at least 1, from the coat's curls and waves; painted
/// curls do not count.
double winding(const Coat& coat);

// Effects of water on a coat besides gathering its clumps. Each factor is 1 for a dry coat.

/// Returns the factor on a fibre's absorption, 1 to 1.8: light that water keeps inside crosses more pigment. A colour c
/// becomes c^factor, which is darker and more saturated.
inline double wet_absorption(double wetness) { return 1 + water_darkens * wetness; }

/// Returns the factor on the weight of the highlight, 1 to 2: a film of water is smoother than the scales under it.
inline double wet_shine(double wetness) { return 1 + water_shines * wetness; }

/// Returns the factor on the exponent of the highlight (one over the square of its width), 1 to 3.
inline double wet_sharpness(double wetness) { return 1 + water_sharpens * wetness; }

/// Returns the factor on a fibre's longitudinal roughness, .5 to 1: water fills the steps between its scales.
inline double wet_roughness(double wetness) { return 1 - 0.5 * wetness; }

/// Returns a look as changed by a coat's wetness: shinier, with sharper highlights.
inline Look wet_look(double wetness, Look look) {
  look.specular *= wet_shine(wetness);
  look.specular_exponent *= wet_sharpness(wetness);
  look.fibre.longitudinal_roughness *= wet_roughness(wetness);
  return look;
}

/// Returns a linear colour as changed by the coat's wetness.
inline glm::vec3 wet_colour(const Coat& coat, glm::vec3 colour) {
  return coat.wetness > 0 ? glm::pow(colour, glm::vec3(static_cast<float>(wet_absorption(coat.wetness)))) : colour;
}

/// Returns the largest luminance of the ramp's colours; at least 1e-4.
float largest_luminance(const Coat& coat);

}  // namespace pelage
