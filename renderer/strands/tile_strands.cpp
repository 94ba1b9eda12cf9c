#include "renderer/strands/tile_strands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/clamped_index.h"
#include "base/colour_space.h"
#include "base/random.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr int min_segments = 6, max_segments = 48;
constexpr double min_of_turn = 4, max_of_turn = 8;  // segments of a turn
constexpr std::size_t length_bins = 8;              // bins of strands of similar length
constexpr std::size_t looked_at = 2048;             // strands sampled for a mean; any prefix of a tile is evenly spread

double thickness(const Coat& coat, double q) { return glm::mix(coat.width_root, coat.width_tip, q); }

/// Returns how many segments a turn of that radius (sizes) needs, so that a chord stays within half of the strand's own
/// radius of its arc, except near the tip.
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
  return clamped_index(std::ceil(segments), min_segments, max_segments);
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
  find_seen_means();
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
    const float below = means_.empty() ? 1 : means_.back();  // for heights that no strand reaches
    means_.push_back(weight > 0 ? static_cast<float>(sum / weight) : below);
  }
}

namespace {

std::size_t length_of(const Strand& strand) {
  return static_cast<std::size_t>(
      clamped_index(std::floor(strand.length_share * length_bins), 0, int{length_bins} - 1));
}

}  // namespace

void TileStrands::find_seen_means() {
  std::array<glm::dvec4, length_bins + 2> sums{};  // weighted colour, weight
  for (std::uint32_t i = 0; i < std::min(strands_.size(), looked_at); ++i) {
    const double width = radius(i, seen_knot());
    const glm::dvec4 sum = width * width * glm::dvec4(glm::dvec3(colour(i, seen_knot())), 1);
    for (std::size_t beside = 0; beside < 3; ++beside) sums[length_of(strands_[i]) + beside] += sum;
  }
  for (std::size_t length = 0; length < length_bins; ++length) {
    const glm::dvec4& sum = sums[length + 1];
    seen_means_.push_back(sum.w > 0 ? glm::vec3(glm::dvec3(sum) / sum.w) : glm::vec3(1));
  }
}

glm::vec3 TileStrands::mean_colour(std::uint32_t strand) const { return seen_means_[length_of(strands_[strand])]; }

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
  hash.add_values(std::span<const glm::vec3>(seen_means_));
  return hash.value();
}

namespace {

constexpr double strands_of_cell = 2;
constexpr double slack = 1e-6;  // in cells; larger than rounding errors at a border

bool before(glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// An edge that is always evaluated from the same one of its ends, so that the triangles on both sides of it get the
/// same result.
struct Edge {
  Edge(glm::dvec2 from, glm::dvec2 to)
      : turned(before(to, from)), low(turned ? to : from), direction((turned ? from : to) - low) {}

  /// Returns twice the area of the triangle of the edge and p; above 0 to the left of the edge.
  double side(glm::dvec2 p) const {
    const double left = direction.x * (p.y - low.y) - direction.y * (p.x - low.x);
    return turned ? -left : left;
  }

  bool turned;  // the ends were swapped; points on the edge belong to the triangle left of `direction`
  glm::dvec2 low, direction;
};

struct Span {
  double low = INFINITY, high = -INFINITY;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

/// Returns the range in x of the part of a triangle with y in [low, high].
Span row_span(const std::array<glm::dvec2, 3>& corners, double low, double high) {
  Span span;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % 3];
    if (a.y >= low && a.y <= high) span.add(a.x);
    for (const double y : {low, high}) {
      if ((a.y < y) != (b.y < y)) span.add(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  }
  return span;
}

/// Returns true if a strand is in the share of the tile that is examined.
bool stays(std::uint32_t strand, double share) {
  return share >= 1 || static_cast<double>(mix_bits(strand | std::uint64_t{3} << 32) >> 40) * 0x1p-24 < share;
}

std::int64_t cell_of(double x) { return static_cast<std::int64_t>(std::floor(x)); }

std::int64_t floored(std::int64_t x, std::int64_t by) { return x >= 0 ? x / by : -((by - 1 - x) / by); }

}  // namespace

class HalfOpenTriangle {
 public:
  explicit HalfOpenTriangle(const std::array<glm::dvec2, 3>& c)
      : edges_{Edge(c[1], c[2]), Edge(c[2], c[0]), Edge(c[0], c[1])}, area_(edges_[2].side(c[2])) {}

  bool has_area() const { return std::abs(area_) > 1e-200; }

  /// Returns true and sets `share` to the barycentric coordinates if p is inside.
  bool contains(glm::dvec2 p, glm::dvec3& share) const {
    for (int i = 0; i < 3; ++i) {
      const Edge& edge = edges_[static_cast<std::size_t>(i)];
      const bool clockwise = area_ < 0;
      const double side = edge.side(p), inward = clockwise ? -side : side;
      if (inward < 0 || (inward == 0 && edge.turned != clockwise)) return false;
      share[i] = inward;
    }
    const double sum = share.x + share.y + share.z;  // not area_: rounding errors dominate in slivers
    share /= sum;
    return sum > 0;
  }

 private:
  std::array<Edge, 3> edges_;  // each opposite to its corner
  double area_;                // twice the signed area, above 0 for counter-clockwise corners
};

TileCells::TileCells(std::span<const Strand> strands, double tile, double share)
    : tile_(tile),
      side_(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(strands.size()) * share / strands_of_cell)))) {
  std::vector<std::uint32_t> chosen;
  std::vector<std::size_t> cells;
  for (std::uint32_t i = 0; i < strands.size(); ++i) {
    if (!stays(i, share)) continue;
    const glm::dvec2 at = glm::clamp(glm::floor(strands[i].root / tile * double(side_)), 0.0, double(side_ - 1));
    chosen.push_back(i);
    cells.push_back(static_cast<std::size_t>(at.y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(at.x));
  }
  first_.assign(static_cast<std::size_t>(side_ * side_) + 1, 0);
  for (const std::size_t cell : cells) ++first_[cell + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  strands_.resize(chosen.size()), roots_.resize(chosen.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const std::uint32_t at = next[cells[i]]++;
    strands_[at] = chosen[i], roots_[at] = strands[chosen[i]].root;
  }
}

void TileCells::find_in_cell(std::int64_t x, std::int64_t y, const HalfOpenTriangle& triangle,
                             std::vector<TileCopy>& found) const {
  const std::int64_t tile_x = floored(x, side_), tile_y = floored(y, side_);
  const auto cell = static_cast<std::size_t>((y - tile_y * side_) * side_ + x - tile_x * side_);
  TileCopy copy{0, glm::ivec2(tile_x, tile_y), {}};
  const glm::dvec2 moved = glm::dvec2(copy.tiles) * tile_;
  for (std::uint32_t i = first_[cell]; i < first_[cell + 1] && found.size() < max_copies; ++i) {
    if (!triangle.contains(roots_[i] + moved, copy.share)) continue;
    copy.strand = strands_[i];
    found.push_back(copy);
  }
}

void TileCells::find(const std::array<glm::dvec2, 3>& triangle, std::vector<TileCopy>& found) const {
  found.clear();
  for (const glm::dvec2& corner : triangle) {
    if (!(std::abs(corner.x) <= furthest && std::abs(corner.y) <= furthest)) return;
  }
  const HalfOpenTriangle inside(triangle);
  if (!inside.has_area()) return;
  std::array<glm::dvec2, 3> corners = triangle;  // in cells
  for (glm::dvec2& corner : corners) corner *= double(side_) / tile_;
  const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const std::int64_t last = cell_of(high + slack);
  for (std::int64_t y = cell_of(low - slack); y <= last && found.size() < max_copies; ++y) {
    const Span span = row_span(corners, double(y) - slack, double(y + 1) + slack);
    if (span.low > span.high) continue;
    const std::int64_t end = cell_of(span.high + slack);
    for (std::int64_t x = cell_of(span.low - slack); x <= end && found.size() < max_copies; ++x)
      find_in_cell(x, y, inside, found);
  }
}

}  // namespace pelage
