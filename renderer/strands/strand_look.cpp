#include "renderer/strands/strand_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/colour_space.h"
#include "renderer/image/float_image.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/tufts.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

constexpr float two_pi = 2 * std::numbers::pi_v<float>;
constexpr std::size_t max_knots = 64;

/// Returns the phase of painted curls. It varies slowly over the tile, so that neighbouring strands curl together
/// (curl_angle in paint_form.glsl).
float curl_phase(glm::vec2 tile_position) {
  return 2.2f * (std::sin(two_pi * tile_position.x + 0.7f) + std::sin(two_pi * tile_position.y + 2.1f));
}

/// The helix that paint adds at a root.
struct PaintedCurl {
  float radius = 0, turns = 0, phase = 0;

  glm::vec2 at(float s) const {
    if (radius <= 0) return glm::vec2(0);
    const float angle = two_pi * turns * s + phase;
    return radius * std::min(1.0f, 4 * s) * glm::vec2(std::cos(angle), std::sin(angle));
  }
};

PaintedCurl painted_curl(const Coat& coat, const Strand& strand, float curl) {
  if (curl <= 0) return {};
  const double added = std::max(std::min(coat.curl + curl, max_curl) - coat.curl, 0.0);
  return {static_cast<float>(added * nominal_length), static_cast<float>(coat.curl_turns),
          curl_phase(glm::vec2(strand.root / coat.tile))};
}

}  // namespace

/// The vector from a root to the middle of its clump or tuft, and the fraction of it that a strand has moved at the
/// height 1.
struct StrandForm::Pull {
  glm::vec3 to_middle{0};
  float part = 0;

  float weight(float rise) const { return part * rise / (1 - part * rise); }
};

StrandForm::StrandForm(const Coat& coat, const TileStrands& tile)
    : coat_(coat), tile_(tile), clumps_(coat.tile, coat.clump_size, coat.seed, 1) {}

StrandForm::Pull StrandForm::clump_pull(const Strand& strand, const RootFields& root) const {
  const auto own = static_cast<float>(coat_.wetness);  // its effect on clumps is already in the tile
  const float water = std::min(own + root.wetness, 1.0f) - own;
  const auto gathers = static_cast<float>(water_gathers);
  const float gather = static_cast<float>(max_clump_gather) * std::min(root.clump + gathers * water, 1.0f);
  if (gather <= 0) return {};
  const StrandClump clump = clumps_.nearest(strand.root);
  return {glm::vec3(clump.centre - strand.root, 0), gather * glm::mix(0.5f, 1.0f, static_cast<float>(clump.pull))};
}

StrandForm::Pull StrandForm::tuft_pull(const RootFields& root) const {
  if (coat_.tufts.gather <= 0) return {};
  const TuftPull tuft = tuft_at(coat_.tufts, root.rest);
  const float radius = glm::length(tuft.to_middle) / std::max(1 - tuft.inside, 0.05f);
  return {tuft.to_middle, gathered(coat_.tufts, 1) * std::min(1.0f, root.length / std::max(radius, 1e-4f))};
}

void StrandForm::sideways(std::uint32_t index, const RootFields& root, std::span<glm::vec3> knots) const {
  const Strand& strand = tile_[index];
  const std::span<const glm::vec2> offsets = tile_.offsets(index);
  const PaintedCurl curl = painted_curl(coat_, strand, root.curl);
  const Pull clump = clump_pull(strand, root), tuft = tuft_pull(root);
  const auto reach = static_cast<float>(strand.length_share);
  std::array<glm::vec2, max_knots> on_tile;  // weighted sums
  float furthest = 1e-12f;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const float s = tile_.along(static_cast<int>(k)) * reach, weight = clump.weight(s * std::sqrt(s));
    on_tile[k] = offsets[k] + curl.at(s) + glm::vec2(clump.to_middle) * weight;
    furthest = std::max(furthest, glm::length(on_tile[k]) / (1 + weight));
  }
  const float limit = std::min(1.0f, root.length * reach / furthest);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const float s = tile_.along(static_cast<int>(k)) * reach, rise = s * std::sqrt(s), by_tuft = tuft.weight(rise);
    const glm::vec2 flat = limit * on_tile[k];
    knots[k] =
        (flat.x * root.tile_u + flat.y * root.tile_v + by_tuft * tuft.to_middle) / (1 + clump.weight(rise) + by_tuft);
  }
}

namespace {

int wrapped(int i, int size) { return (i % size + size) % size; }

/// The pattern's effect on a strand, the same for all of its knots.
struct RootPattern {
  glm::vec3 weights{0}, varied{1};
};

RootPattern pattern_at(const PatternBlock& block, const RootFields& root) {
  const glm::vec4 varied = pattern_variation(block, root.rest.position);
  return {pattern_weights(block, root.rest.position, root.rest.normal),
          varied.z * glm::vec3(1 + varied.w, 1, 1 - varied.w)};
}

/// As colour_painted in paint_light.glsl.
glm::vec3 painted(glm::vec3 colour, glm::vec4 paint, float strand, float mean) {
  const float lighter = glm::clamp(strand / std::max(mean, 1e-4f), 0.5f, 1.6f);
  return colour * (1 - paint.a) + glm::vec3(paint) * lighter;
}

}  // namespace

glm::vec3 sample_picture(const ImageView& image, glm::vec2 uv, const std::array<float, 256>& linear) {
  if (image.width <= 0 || image.height <= 0) return glm::vec3(1);
  const glm::vec2 coordinate = glm::fract(glm::vec2(uv.x, 1 - uv.y)) * glm::vec2(image.width, image.height) - 0.5f;
  if (!(coordinate.x >= -1 && coordinate.y >= -1)) return glm::vec3(1);  // not finite
  const glm::vec2 low = glm::floor(coordinate), part = coordinate - low;
  const auto texel = [&](int right, int down) {
    const int x = wrapped(static_cast<int>(low.x) + right, image.width);
    const int y = wrapped(static_cast<int>(low.y) + down, image.height);
    const std::uint8_t* at = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                              static_cast<std::size_t>(x))];
    return glm::vec3(linear[at[0]], linear[at[1]], linear[at[2]]);
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), part.x), glm::mix(texel(0, 1), texel(1, 1), part.x), part.y);
}

StrandColours::StrandColours(const FurModel& model, const GrowRecipe& recipe, const TileStrands& tile)
    : model_(model),
      tile_(tile),
      model_colours_(recipe.model_colours),
      ramp_root_(ramp_colour(recipe.coat, 0)),
      own_wetness_(static_cast<float>(recipe.coat.wetness)),
      over_largest_(1 / largest_luminance(recipe.coat)) {
  if (has_pattern(recipe.coat)) pattern_ = make_pattern_block(recipe.coat);
  for (std::size_t i = 0; i < linear_.size(); ++i)
    linear_[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
}

glm::vec3 StrandColours::model_colour(const RootFields& root) const {
  const glm::vec3 colour = glm::max(root.colour, 0.0f);
  if (root.image < 0 || static_cast<std::size_t>(root.image) >= model_.images.size()) return colour;
  return colour * sample_picture(model_.images[static_cast<std::size_t>(root.image)], root.image_uv, linear_);
}

/// Returns the exponent of colour_wetted in paint_light.glsl, for water beyond the coat's own.
float StrandColours::wet_exponent(float wetness) const {
  return (1 + 0.8f * std::min(own_wetness_ + wetness, 1.0f)) / (1 + 0.8f * own_wetness_);
}

struct StrandColours::Shared {
  glm::vec3 model{0};
  RootPattern pattern;
  bool is_painted = false;
};

StrandColours::Shared StrandColours::shared_at(const RootFields& root) const {
  return {model_colours_ ? model_colour(root) : glm::vec3(0), pattern_ ? pattern_at(*pattern_, root) : RootPattern{},
          root.root_paint.a > 0 || root.tip_paint.a > 0};
}

/// Returns the colour at the height s in the fur; `own` is the colour without model, pattern, paint and water.
glm::vec3 StrandColours::colour(const Shared& shared, const RootFields& root, glm::vec3 own, float s) const {
  glm::vec3 colour = model_colours_ ? shared.model * (0.36f + 0.84f * luminance(own) * over_largest_) : own;
  if (pattern_) colour = with_weights(*pattern_, shared.pattern.weights, colour) * shared.pattern.varied;
  if (shared.is_painted)
    colour = painted(colour, glm::mix(root.root_paint, root.tip_paint, s), luminance(own), tile_.mean_luminance(s));
  if (root.wetness > 0) colour = glm::pow(glm::max(colour, 0.0f), glm::vec3(wet_exponent(root.wetness)));
  return colour;
}

std::uint32_t StrandColours::write(std::uint32_t strand, const RootFields& root, std::span<std::uint32_t> knots) const {
  const Shared shared = shared_at(root);
  const auto reach = static_cast<float>(tile_[strand].length_share);
  const auto height = [&](int k) { return tile_.along(k) * reach; };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const int k = static_cast<int>(i);
    knots[i] = pack_colour(colour(shared, root, tile_.colour(strand, k), height(k)));
  }
  constexpr float black = 0.002f;  // avoids a division by 0
  const int seen = tile_.seen_knot();
  const glm::vec3 own = colour(shared, root, tile_.colour(strand, seen), height(seen));
  const glm::vec3 mean = colour(shared, root, tile_.mean_colour(strand), height(seen));
  return pack_colour((mean + black) / (own + black));
}

glm::vec3 StrandColours::under(const RootFields& root) const { return colour(shared_at(root), root, ramp_root_, 0); }

}  // namespace pelage
