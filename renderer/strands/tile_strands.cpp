#include "renderer/strands/tile_strands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/base/colour_space.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr int min_segments = 6, max_segments = 48;
constexpr double min_of_turn = 4, max_of_turn = 8;  // segments
constexpr std::size_t looked_at = 2048;             // strands for a mean: the first ones of a tile lie evenly

double thickness(const Coat& coat, double q) { return glm::mix(coat.width_root, coat.width_tip, q); }

/// As many for a turn of that radius (sizes) that a chord stays within half of the strand's own radius of its arc, but
/// near the tip.
double segments_of_turn(const Coat& coat, double radius) {
  const double sag = std::clamp(0.25 * thickness(coat, 0.75) / std::max(radius, 1e-12), 1e-3, 1.0);
  return std::clamp(std::numbers::pi / std::acos(1 - sag), min_of_turn, max_of_turn);
}

}  // namespace

int strand_segments(const Coat& coat, bool curled) {
  double segments = min_segments;
  if (curled) segments = std::max(segments, max_of_turn * coat.curl_turns);
  if (coat.curl > 0)
    segments = std::max(segments, coat.curl_turns * segments_of_turn(coat, coat.curl * nominal_length));
  if (coat.wave > 0)
    segments = std::max(segments, coat.wave_turns * segments_of_turn(coat, coat.wave * nominal_length));
  return std::min(static_cast<int>(std::ceil(segments)), max_segments);
}

TileStrands::TileStrands(const Coat& coat, int segments) : segments_(segments), strands_(make_strands(coat)) {
  offsets_.reserve(strands_.size() * (static_cast<std::size_t>(segments) + 1));
  for (const Strand& strand : strands_) {
    own_colours_.push_back(wet_colour(coat, strand.own_colour));
    for (int k = 0; k <= segments; ++k)
      offsets_.emplace_back(strand_offset(coat, strand, static_cast<double>(k) / segments));
  }
  for (int k = 0; k <= segments; ++k) {
    const double q = static_cast<double>(k) / segments;
    ramp_.push_back(ramp_colour(coat, q));
    radii_.push_back(static_cast<float>(0.5 * thickness(coat, q)));
  }
  find_means(coat);
}

glm::vec3 TileStrands::colour(std::uint32_t i, int k) const {
  const Strand& strand = strands_[i];
  return glm::mix(ramp_[static_cast<std::size_t>(k)], own_colours_[i], strand.own_share) * strand_tint(strand);
}

float TileStrands::radius(std::uint32_t i, int k) const {
  return static_cast<float>(strands_[i].width) * radii_[static_cast<std::size_t>(k)];
}

void TileStrands::find_means(const Coat& coat) {
  const std::size_t count = std::min(strands_.size(), looked_at);
  for (int slice = 0; slice <= slice_count; ++slice) {
    const double s = static_cast<double>(slice) / slice_count;
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Strand& strand = strands_[i];
      if (strand.length_share < s) continue;
      const double q = s / strand.length_share, width = strand.width * thickness(coat, q);
      sum += width * width * luminance(strand_colour(coat, strand, q)), weight += width * width;
    }
    const float below = means_.empty() ? 1 : means_.back();  // where no strand reaches
    means_.push_back(weight > 0 ? static_cast<float>(sum / weight) : below);
  }
}

float TileStrands::mean_luminance(float s) const {
  const float at = std::clamp(s, 0.0f, 1.0f) * slice_count;
  const auto low = std::min(static_cast<std::size_t>(at), means_.size() - 2);
  return glm::mix(means_[low], means_[low + 1], at - static_cast<float>(low));
}

std::uint64_t TileStrands::hash() const {
  static_assert(sizeof(Strand) == 21 * sizeof(double), "hashed as it is in memory");
  Hash hash;
  hash.add_values(std::span<const Strand>(strands_));
  hash.add_values(std::span<const glm::vec3>(own_colours_));
  hash.add_values(std::span<const glm::vec2>(offsets_));
  hash.add_values(std::span<const glm::vec3>(ramp_));
  hash.add_values(std::span<const float>(radii_));
  hash.add_values(std::span<const float>(means_));
  return hash.value();
}

}  // namespace pelage
