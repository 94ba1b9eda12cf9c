// Settings of a coat: its pattern and slow variation over the body, its strands, colours and tufts. Positions are
// internal coordinates (y up, the nose at +z, the middle of the box at 0, its diagonal 1), so no model needs UVs.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/lean_curve.h"

namespace pelage {

enum class PatternKind { none, stripes, spots, rosettes, tabby, patches, countershading };

/// A pattern of markings. Colours are linear. Markings replace the coat's own colour, and both get lighter and darker
/// along the strand as the coat's ramp does.
struct Pattern {
  PatternKind kind = PatternKind::none;
  double scale = 0.07;       // distance from one marking to the next, sizes, [0.005, 2]
  double coverage = 0.5;     // share of the surface that is marked, [0, 1]; countershading: how far up it reaches
  double contrast = 1;       // how far markings replace the coat's colour, [0, 1]
  double softness = 0.15;    // width of a marking's edge over that of the marking, [0, 1]
  double warp = 0.5;         // how far noise bends the markings, in distances from one to the next, [0, 2]
  double legs = 1;           // how far stripes turn to rings on legs and haunches, and rosettes fill there, [0, 1]
  double inner = 0;          // weight of inner_colour: in rosettes, as second patches, between stripes, [0, 1]
  double belly = 0;          // how far the underside takes belly_colour and loses its markings, [0, 1]
  glm::dvec3 axis{0, 0, 1};  // direction from one stripe to the next; length in [1e-6, 1e6]
  glm::vec3 colour{0.012f, 0.010f, 0.009f};
  glm::vec3 inner_colour{0.22f, 0.10f, 0.035f};
  glm::vec3 belly_colour{0.75f, 0.70f, 0.62f};
  std::uint32_t seed = 1;

  bool operator==(const Pattern&) const = default;
};

/// Slow changes of colour and form over the body, as amplitudes in [0, 1].
struct Variation {
  double lightness = 0;  // 1: from half to twice
  double hue = 0;        // 1: from a third towards blue to a third towards red
  double length = 0;     // 1: from none to twice
  double lean = 0;       // 1: the whole range of the inclination
  double size = 0.12;    // distance from one crest to the next, sizes, [0.005, 2]

  bool operator==(const Variation&) const = default;
};

// The coat: how the strands of the sample tile are made. Lengths are fractions of the model's size.

/// One stop of the colour ramp along the strand. Colour is linear inside and #rrggbb sRGB on the wire.
struct RampStop {
  double at = 0;  // position along the strand, [0, 1], 0 at the root; ascending
  glm::vec3 colour{1};

  bool operator==(const RampStop&) const = default;
};

/// Short, fine strands under the others, in the same tile.
struct Undercoat {
  double share = 0;        // share of the strands, [0, 1]
  double length = 0.5;     // ratio to the overcoat's length, [0.02, 1]
  double width = 0.6;      // ratio to the overcoat's width, [0.05, 4]
  double lightness = 1;    // factor on the ramp's colour, [0, 4]
  double tint = 0;         // how far `colour` replaces the ramp's, [0, 1]
  glm::vec3 colour{0.5f};  // linear

  bool operator==(const Undercoat&) const = default;
};

/// Ticking: some hairs have one colour of their own from root to tip.
struct Ticking {
  double share = 0;         // share of the strands, [0, 1]
  glm::vec3 colour{0.85f};  // linear

  bool operator==(const Ticking&) const = default;
};

/// Tufts: clumps larger than the tile, which gather strands around points of the body itself, so that the fur does not
/// repeat and has form at a distance. Each finer scale is .45 times the one before.
struct Tufts {
  double gather = 0;   // how far tips move to the middle of their tuft, [0, 1]
  double size = 0.05;  // mean distance between the largest tufts, sizes, [0.01, 1]
  int scales = 2;      // number of scales, [1, 3]
  std::uint32_t seed = 1;

  bool operator==(const Tufts&) const = default;
};

struct Coat {
  int count = 9000;                // strands in the tile, [1, 100000]
  double tile = 0.12;              // side of the tile, sizes, [0.01, 1]
  double width_root = 0.0011;      // sizes, [0, 0.05]
  double width_tip = 0.00028;      // sizes, [0, 0.05]
  double bend = 0.25;              // how far a strand bows to a side, in units of 0.03 sizes, [0, 2]
  double curl = 0;                 // radius of the helix, in units of 0.03 sizes, [0, 0.5]
  double curl_turns = 3;           // turns of the helix from root to tip, [0, 20]
  double curl_together = 0;        // how far the strands of a clump curl as one lock, [0, 1]
  double wave = 0;                 // amplitude of a sine in one plane, in units of 0.03 sizes, [0, 0.5]
  double wave_turns = 3;           // waves from root to tip, [0, 20]
  double mess = 0;                 // how far each strand leans and bows in a direction of its own, [0, 1]
  double clump = 0.4;              // how far tips gather to the middle of their clump, [0, 1]
  double clump_size = 0.010;       // mean distance between clumps, sizes, [0.001, 0.5]
  double fine_clump = 0;           // how far strands gather into small locks inside their clump, [0, 1]
  double fine_clump_size = 0.004;  // mean distance between these locks, sizes, [0.001, 0.5]
  double lodge = 0;                // how far patches of strands are pressed to one side, [0, 1]
  double lodge_size = 0.04;        // mean distance between these patches, sizes, [0.001, 0.5]
  double wetness = 0;              // [0, 1]: tighter clumps, darker and shinier (renderer/coat/strand_tile.h)
  double length_spread = 0.3;      // share of the length that is random, [0, 1]
  double colour_spread = 0.12;     // change of lightness from strand to strand, [0, 1]
  double warmth_spread = 0;        // change of hue from strand to strand, towards red or blue, [0, 1]
  double root_share = 0.3;         // angle at the root over angle at the tip: 0 plush, .6 sleek, [0, 1]
  LeanCurve lean_curve = LeanCurve::arc;
  std::vector<RampStop> ramp{{0.0, {0.100f, 0.060f, 0.035f}},
                             {0.55, {0.360f, 0.210f, 0.110f}},
                             {1.0, {0.620f, 0.440f, 0.270f}}};  // 1 to 4 stops
  Undercoat undercoat{};
  int guard_hairs = 0;  // single hairs over the model, up to 1.25 times as long as the fur, [0, 100000]
  Ticking ticking{};
  Tufts tufts{};
  Pattern pattern{};
  Variation variation{};
  std::uint32_t seed = 1;

  bool operator==(const Coat&) const = default;
};

/// The number by which fields, strands and exports name a coat, [0, limits::coats).
using CoatId = std::uint64_t;

/// A coat of a scene. Each coat has its own fields, except those that all coats share (is_shared). Its region is where
/// its density is above 0.
struct NamedCoat {
  std::string name = "fur";  // 1 to 200 bytes; names differ
  CoatId id = 0;             // constant while the coat exists; 0 for the first coat of a new model
  bool muted = false;        // not drawn, exported or changed by tools; at least one coat is not muted
  Coat coat;

  bool operator==(const NamedCoat&) const = default;
};

/// Where a new coat grows. all: wherever the coat does that it begins from. none: nowhere yet. mask: as far as the mask
/// allows.
enum class CoatRegion { all, none, mask };

/// The first fields of a new coat, which come from another coat.
struct CoatBeginning {
  std::string from = {};  // name of the other coat; "" for the first
  CoatRegion region = CoatRegion::all;
  double length = 1;  // factor on the other coat's lengths, [0.01, 100]

  bool operator==(const CoatBeginning&) const = default;
};

/// A coat in set_coats. Its id identifies it or, without one, its name; a coat that does not exist yet is new.
struct CoatEntry {
  std::string name = {};
  std::optional<CoatId> id = {};  // absent: found by name; a new coat gets the lowest free id
  bool muted = false;
  std::optional<Coat> coat = {};             // absent: unchanged, or for a new coat that of the one that it begins from
  std::optional<CoatBeginning> begins = {};  // for a new coat only

  bool operator==(const CoatEntry&) const = default;
};

}  // namespace pelage
