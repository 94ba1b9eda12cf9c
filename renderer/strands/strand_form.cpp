#include "renderer/strands/strand_form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "renderer/pattern/tufts.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

constexpr float turn = 2 * std::numbers::pi_v<float>;
constexpr std::size_t max_knots = 64;

/// Strands of one place curl together; between places the phase changes slowly (curl_angle in paint_form.glsl).
float curl_phase(glm::vec2 tile_place) {
  return 2.2f * (std::sin(turn * tile_place.x + 0.7f) + std::sin(turn * tile_place.y + 2.1f));
}

/// The helix that paint adds at a root.
struct PaintedCurl {
  float radius = 0, turns = 0, phase = 0;

  glm::vec2 at(float s) const {
    if (radius <= 0) return glm::vec2(0);
    const float angle = turn * turns * s + phase;
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

/// The way from a root to a middle, and the part of it that a strand has gone at the height 1.
struct StrandForm::Pull {
  glm::vec3 way{0};
  float part = 0;

  float weight(float rise) const { return part * rise / (1 - part * rise); }
};

StrandForm::StrandForm(const Coat& coat, const TileStrands& tile)
    : coat_(coat), tile_(tile), clumps_(coat.tile, coat.clump_size, coat.seed, 1) {}

StrandForm::Pull StrandForm::clump_pull(const Strand& strand, const RootFields& root) const {
  const auto own = static_cast<float>(coat_.wetness);  // what that draws together is in the tile
  const float water = std::min(own + root.wetness, 1.0f) - own;
  const auto gathers = static_cast<float>(water_gathers);
  const float gather = static_cast<float>(max_clump_gather) * std::min(root.clump + gathers * water, 1.0f);
  if (gather <= 0) return {};
  const StrandClump clump = clumps_.nearest(strand.root);
  return {glm::vec3(clump.centre - strand.root, 0), gather * glm::mix(0.5f, 1.0f, static_cast<float>(clump.pull))};
}

StrandForm::Pull StrandForm::tuft_pull(const RootFields& root) const {
  if (coat_.tufts.gather <= 0) return {};
  const TuftPlace tuft = tuft_at(coat_.tufts, root.place, root.normal);
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
    on_tile[k] = offsets[k] + curl.at(s) + glm::vec2(clump.way) * weight;
    furthest = std::max(furthest, glm::length(on_tile[k]) / (1 + weight));
  }
  const float limit = std::min(1.0f, root.length * reach / furthest);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const float s = tile_.along(static_cast<int>(k)) * reach, rise = s * std::sqrt(s), by_tuft = tuft.weight(rise);
    const glm::vec2 flat = limit * on_tile[k];
    knots[k] = (flat.x * root.tile_u + flat.y * root.tile_v + by_tuft * tuft.way) / (1 + clump.weight(rise) + by_tuft);
  }
}

}  // namespace pelage
