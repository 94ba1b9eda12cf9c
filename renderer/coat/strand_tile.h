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

/// What the strands of one clump share.
struct StrandClump {
  glm::dvec2 centre{0};              // sizes
  glm::dvec2 bow{0};                 // within the unit disc
  double length = 1, lightness = 1;  // [-1, 1]
  double pull = 1;                   // [.25, 1]: clumps are not all alike
};

/// The nearest clump, and the distances to it and to the next.
struct NearestClumps {
  StrandClump first;
  double to_first = 0, to_second = 0;  // sizes
};

class ClumpGrid {
 public:
  /// Clumps about `size` apart on a tile of side `tile`, both in sizes. Deterministic in all four.
  ClumpGrid(double tile, double size, std::uint64_t seed, std::uint64_t stream);

  /// The nearest clump on the periodic tile, its centre moved by whole tiles to lie next to `place`.
  StrandClump nearest(glm::dvec2 place) const { return nearest_two(place).first; }
  NearestClumps nearest_two(glm::dvec2 place) const;

 private:
  int wrap(int i) const { return (i % side_ + side_) % side_; }

  double tile_;
  int side_;  // cells
  std::vector<StrandClump> clumps_;
};

// The clumps of a coat's tile as a texture: where the strands of each place gather.

/// `side * side` texels of 4 bytes, x fastest, over the periodic tile: the vector to the middle of the position's clump
/// over +-reach (x, y), how far inside of the clump it lies (0 on the border to the next, 1 in the middle), and the
/// clump's pull (StrandClump).
struct ClumpMap {
  static constexpr int side = 256;
  std::vector<std::uint8_t> texels;
  double reach = 0;  // tiles
};

/// Bakes the map of the clumps that `clump` and `clump_size` of the coat make. Deterministic in the coat alone.
ClumpMap bake_clump_map(const Coat& coat);

// The fur texture generator: the strands of one periodic sample tile (fur modelling 4). Slices and, later, traced
// strands are both made from them.

/// One strand. Places are in sizes on the tile, before the lean; they may leave [0, tile) and are taken modulo the
/// tile.
struct Strand {
  glm::dvec2 root{0};
  glm::dvec2 clump{0};       // from the root to the middle of its clump
  glm::dvec2 fine_clump{0};  // from the root to the middle of its lock inside the clump
  glm::dvec2 bow{0};         // offset of the tip by bending
  glm::dvec2 heading{0};     // offset of the tip by its direction at the root: mess and lodging
  glm::dvec2 wave{0};        // amplitude and direction of the sine
  double wave_phase = 0;     // radians
  double curl_phase = 0;     // radians
  double length_share = 1;   // of the field's length, (0, 1]
  double width = 1;          // factor on the coat's
  double lightness = 1;      // factor on the ramp's colour
  double warmth = 1;         // red over blue, before its lightness is put right
  glm::vec3 own_colour{0};   // linear; of odd hairs and of the undercoat
  float own_share = 0;       // how far it replaces the ramp's, [0, 1]
  double number = 0;         // uniform in [0, 1): the strand grows while it is below the density
};

/// Deterministic in the coat alone. A setting at its neutral value leaves the other settings' strands as they were.
std::vector<Strand> make_strands(const Coat& coat);

/// Offset from the root at `q` in [0, 1] along the strand, sizes, less what draws it to its clump and lock.
glm::dvec2 free_offset(const Coat& coat, const Strand& strand, double q);

/// Offset from the root at `q` in [0, 1] along the strand, sizes.
glm::dvec2 strand_offset(const Coat& coat, const Strand& strand, double q);

/// What a strand's colour is multiplied by: its lightness, and its warmth at the same lightness of grey.
glm::vec3 strand_tint(const Strand& strand);

/// The coat's ramp at `q` in [0, 1], linear colour; wet coats are darker.
glm::vec3 ramp_colour(const Coat& coat, double q);

/// The strand's colour at `q` in [0, 1], linear: from the ramp or its own; may be over 1.
glm::vec3 strand_colour(const Coat& coat, const Strand& strand, double q);

/// Returns whether both coats give the same strands: patterns, variation and the lean do not count.
bool same_strands(const Coat& a, const Coat& b);

/// Returns the length along a strand over its straight length, as curls and waves wind it, 1 or more; painted curls do
/// not count.
double winding(const Coat& coat);

// What water does to a coat beside gathering its clumps. Each factor is 1 for a dry coat.

/// Factor on a fibre's absorption, 1 to 1.8: light that water keeps inside crosses more pigment. A colour c is then
/// c^factor, which darkens it and makes it more saturated.
inline double wet_absorption(double wetness) { return 1 + water_darkens * wetness; }

/// Factor on the weight of the highlight, 1 to 2: a film of water is smoother than the scales under it.
inline double wet_shine(double wetness) { return 1 + water_shines * wetness; }

/// Factor on the exponent of the highlight (one over the square of its width), 1 to 3.
inline double wet_sharpness(double wetness) { return 1 + water_sharpens * wetness; }

/// Factor on a fibre's roughness along it, .5 to 1: water fills the steps between its scales.
inline double wet_roughness(double wetness) { return 1 - 0.5 * wetness; }

/// A look as a coat's wetness leaves it: shinier, with sharper highlights.
inline Look wet_look(double wetness, Look look) {
  look.specular *= wet_shine(wetness);
  look.specular_exponent *= wet_sharpness(wetness);
  look.fibre.longitudinal_roughness *= wet_roughness(wetness);
  return look;
}

/// A linear colour as the coat's wetness leaves it.
inline glm::vec3 wet_colour(const Coat& coat, glm::vec3 colour) {
  return coat.wetness > 0 ? glm::pow(colour, glm::vec3(static_cast<float>(wet_absorption(coat.wetness)))) : colour;
}

/// Returns the largest luminance of the ramp's colours; at least 1e-4.
float largest_luminance(const Coat& coat);

}  // namespace pelage
