#include "renderer/coat/strand_tile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/colour_space.h"
#include "base/random.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

/// Makes the clump of a cell. `cell` is in cells, `cell_side` and the clump's centre are in sizes.
StrandClump make_clump(glm::dvec2 cell, double cell_side, Random& random) {
  const glm::dvec2 jitter(random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2));
  const double angle = random.uniform(0, 2 * std::numbers::pi), reach = random.uniform();
  return {(cell + jitter) * cell_side, glm::dvec2(std::cos(angle), std::sin(angle)) * reach, random.uniform(-1, 1),
          random.uniform(-1, 1), random.uniform(0.25, 1)};
}

}  // namespace

ClumpGrid::ClumpGrid(double tile, double size, std::uint64_t seed, std::uint64_t stream)
    : tile_(tile), side_(std::max(1, static_cast<int>(std::lround(tile / size)))) {
  Random random(seed, stream);
  for (int i = 0; i < side_ * side_; ++i) {
    clumps_.push_back(make_clump(glm::dvec2(i % side_, i / side_), tile_ / side_, random));
  }
}

NearestClumps ClumpGrid::nearest_two(glm::dvec2 position) const {
  const glm::ivec2 cell(glm::floor(position / tile_ * double(side_)));
  NearestClumps near{{}, 1e300, 1e300};
  for (int y = cell.y - 2; y <= cell.y + 2; ++y) {
    for (int x = cell.x - 2; x <= cell.x + 2; ++x) {
      StrandClump clump = clumps_[static_cast<std::size_t>(wrap(y) * side_ + wrap(x))];
      clump.centre += glm::dvec2(x - wrap(x), y - wrap(y)) * (tile_ / side_);
      const double distance = glm::distance(clump.centre, position);
      near.to_second = std::min(near.to_second, std::max(distance, near.to_first));
      if (distance < near.to_first) near.first = clump, near.to_first = distance;
    }
  }
  return near;
}

namespace {

std::uint8_t unorm8(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

}  // namespace

ClumpMap bake_clump_map(const Coat& coat) {
  const ClumpGrid clumps(coat.tile, coat.clump_size, coat.seed, 1);
  ClumpMap map;
  map.reach = std::clamp(2 * coat.clump_size / coat.tile, 1e-3, 1.0);
  map.texels.reserve(4 * ClumpMap::side * ClumpMap::side);
  for (int y = 0; y < ClumpMap::side; ++y) {
    for (int x = 0; x < ClumpMap::side; ++x) {
      const glm::dvec2 position = (glm::dvec2(x, y) + 0.5) * (coat.tile / ClumpMap::side);
      const NearestClumps near = clumps.nearest_two(position);
      const glm::dvec2 to_centre = (near.first.centre - position) / (coat.tile * map.reach);
      const double inside = (near.to_second - near.to_first) / std::max(near.to_second + near.to_first, 1e-12);
      for (const double value : {0.5 + 0.5 * to_centre.x, 0.5 + 0.5 * to_centre.y, inside, near.first.pull})
        map.texels.push_back(unorm8(value));
    }
  }
  return map;
}

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

glm::dvec2 unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Returns a root's position. Roots are evenly but not regularly spread for any count: the R2 low-discrepancy sequence
/// (Roberts 2018), which is periodic as the tile is, with jitter.
glm::dvec2 root_position(const Coat& coat, int index, Random& random) {
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  const glm::dvec2 jitter(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
  return glm::fract(step * (index + 1.0) + jitter / std::sqrt(static_cast<double>(coat.count))) * coat.tile;
}

/// The clump grids of a coat; unused ones are not made. Water gathers strands.
struct Clumps {
  explicit Clumps(const Coat& coat)
      : gather(glm::mix(coat.clump, 1.0, water_gathers * coat.wetness)),
        coarse(coat.tile, coat.clump_size, coat.seed, 1) {
    if (coat.fine_clump > 0) fine.emplace(coat.tile, coat.fine_clump_size, coat.seed, 2);
    if (coat.lodge > 0) lodged.emplace(coat.tile, coat.lodge_size, coat.seed, 3);
  }

  double gather;  // [0, 1]
  ClumpGrid coarse;
  std::optional<ClumpGrid> fine, lodged;
};

/// Returns the tangent of the angle from the normal by which the lodged patch around `position` presses its strands:
/// full in the patch's middle, 0 at its edge. A third of the patches stand upright.
glm::dvec2 lodging(const Coat& coat, const ClumpGrid& patches, glm::dvec2 position) {
  const StrandClump patch = patches.nearest(position);
  const double from_middle = glm::distance(patch.centre, position) / coat.lodge_size;
  const double weight = (1 - glm::smoothstep(0.35, 0.75, from_middle)) * glm::smoothstep(-0.5, 0.0, patch.length);
  return glm::normalize(patch.bow + glm::dvec2(1e-9, 0)) * (1.8 * coat.lodge * weight);
}

/// Adds heading, wave and extra bow to a strand. They have their own random numbers, so that strands without them do
/// not change.
void add_forms(const Coat& coat, const Clumps& clumps, const StrandClump& clump, Random& random, Strand& strand) {
  const double straggle = random.uniform(0, two_pi), bow = random.uniform(0, two_pi), amount = random.uniform(0.2, 1);
  glm::dvec2 tangent = unit(straggle) * (coat.mess * amount);
  if (clumps.lodged) tangent += lodging(coat, *clumps.lodged, strand.root);
  const double upright = 1 / std::sqrt(1 + glm::dot(tangent, tangent));  // cosine; leaning strands reach less high
  strand.heading = tangent * (nominal_length * upright);
  strand.bow += unit(bow) * (coat.mess * amount * nominal_length);
  strand.length_share = std::max(0.02, strand.length_share * upright);
  // The strands of a clump wave nearly in phase, or waves would not be visible.
  const double swing = std::atan2(clump.bow.y, clump.bow.x) + random.uniform(-0.35, 0.35);
  strand.wave = unit(swing) * (coat.wave * nominal_length * random.uniform(0.8, 1.2));
  strand.wave_phase = two_pi * clump.lightness + random.uniform(-0.5, 0.5);
}

/// Makes a strand part of the undercoat or of the ticking, by chance.
void add_kind(const Coat& coat, Random& random, Strand& strand) {
  const bool under = random.uniform() < coat.undercoat.share, ticked = random.uniform() < coat.ticking.share;
  if (under) {
    strand.length_share = std::max(0.02, strand.length_share * coat.undercoat.length);
    strand.width = coat.undercoat.width;
    strand.lightness *= coat.undercoat.lightness;
    strand.own_colour = coat.undercoat.colour;
    strand.own_share = static_cast<float>(coat.undercoat.tint);
  } else if (ticked) {
    strand.own_colour = coat.ticking.colour;
    strand.own_share = 1;
  }
}

}  // namespace

std::vector<Strand> make_strands(const Coat& coat) {
  assert(coat.count >= 1 && coat.tile > 0 && coat.clump_size > 0);
  const Clumps clumps(coat);
  Random random(coat.seed), forms(coat.seed, 4), kinds(coat.seed, 5), hues(coat.seed, 6);
  std::vector<Strand> strands;
  strands.reserve(static_cast<std::size_t>(coat.count));
  for (int i = 0; i < coat.count; ++i) {
    Strand strand;
    strand.root = root_position(coat, i, random);
    const StrandClump lock = clumps.fine ? clumps.fine->nearest(strand.root) : StrandClump{.centre = strand.root};
    const StrandClump clump = clumps.coarse.nearest(lock.centre);  // a whole lock belongs to one clump
    const double angle = random.uniform(0, two_pi), own = random.uniform(), of_clump = clumps.gather;
    strand.fine_clump = lock.centre - strand.root;
    strand.clump = (clump.centre - strand.root) * glm::mix(clump.pull, 1.0, coat.wetness);
    const double same_bow = of_clump * glm::mix(0.8, 1.0, coat.wetness);
    strand.bow = coat.bend * nominal_length * glm::mix(unit(angle) * random.uniform(), clump.bow, same_bow);
    strand.curl_phase = glm::mix(random.uniform(0, two_pi), two_pi * (clump.lightness + 1), coat.curl_together);
    const double shorter = glm::mix(own, 0.5 - 0.5 * clump.length, of_clump * 0.4);
    strand.length_share = std::max(0.02, 1 - coat.length_spread * shorter);
    // Under one film of water the strands of a clump look alike.
    const double same_lightness = glm::mix(of_clump * 0.35, 0.9, coat.wetness);
    const double lighter = glm::mix(random.uniform(-1, 1), clump.lightness, same_lightness);
    strand.lightness = std::exp2(2 * coat.colour_spread * lighter);
    strand.number = random.uniform();
    strand.warmth = std::exp2(coat.warmth_spread * hues.uniform(-1, 1));
    add_forms(coat, clumps, clump, forms, strand);
    add_kind(coat, kinds, strand);
    strands.push_back(strand);
  }
  return strands;
}

glm::dvec2 free_offset(const Coat& coat, const Strand& strand, double q) {
  const double settled = std::min(1.0, 4 * q);  // curls and waves grow out of the root
  glm::dvec2 offset = strand.bow * (q * q) + strand.heading * q;
  if (coat.curl > 0) {
    offset += unit(strand.curl_phase + two_pi * coat.curl_turns * q) * (coat.curl * nominal_length * settled);
  }
  if (coat.wave > 0) offset += strand.wave * (std::sin(strand.wave_phase + two_pi * coat.wave_turns * q) * settled);
  return offset;
}

double winding(const Coat& coat) {
  const double around = two_pi * coat.curl * coat.curl_turns, aside = 4 * coat.wave * coat.wave_turns;
  return std::hypot(1.0, around, aside);
}

glm::dvec2 strand_offset(const Coat& coat, const Strand& strand, double q) {
  const double rise = q * std::sqrt(q);
  // Wet strands join close to the root and then run together.
  const double early = glm::mix(rise, q * (2 - q), 0.35 * coat.wetness);
  const double gather = glm::mix(coat.clump, 1.0, water_gathers * coat.wetness) * early;
  const glm::dvec2 to_lock = strand.fine_clump * (coat.fine_clump * rise);
  return to_lock + (strand.clump - to_lock) * gather + free_offset(coat, strand, q);
}

glm::vec3 ramp_colour(const Coat& coat, double q) {
  const std::vector<RampStop>& ramp = coat.ramp;
  assert(!ramp.empty());
  const auto next = std::find_if(ramp.begin(), ramp.end(), [&](const RampStop& stop) { return stop.at >= q; });
  if (next == ramp.begin()) return wet_colour(coat, ramp.front().colour);
  if (next == ramp.end()) return wet_colour(coat, ramp.back().colour);
  const RampStop& last = *(next - 1);
  const double span = next->at - last.at;
  const float share = static_cast<float>(span > 0 ? (q - last.at) / span : 1);
  return wet_colour(coat, glm::mix(last.colour, next->colour, share));
}

glm::vec3 strand_tint(const Strand& strand) {
  if (strand.warmth == 1) return glm::vec3(static_cast<float>(strand.lightness));
  const double root = std::sqrt(strand.warmth);
  const glm::vec3 tint(root, 1, 1 / root);
  return tint * static_cast<float>(strand.lightness / double{luminance(tint)});
}

glm::vec3 strand_colour(const Coat& coat, const Strand& strand, double q) {
  return glm::mix(ramp_colour(coat, q), wet_colour(coat, strand.own_colour), strand.own_share) * strand_tint(strand);
}

bool same_strands(const Coat& a, const Coat& b) {
  Coat other = b;
  other.pattern = a.pattern;
  other.tufts = a.tufts;
  other.variation = a.variation;
  other.root_share = a.root_share;
  other.lean_curve = a.lean_curve;
  return a == other;
}

float largest_luminance(const Coat& coat) {
  float largest = 1e-4f;
  for (const RampStop& stop : coat.ramp) largest = std::max(largest, luminance(stop.colour));
  return largest;
}

}  // namespace pelage
