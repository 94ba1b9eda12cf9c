#include "renderer/raster/bins.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace pelage {

namespace {

int tile_of(float pixel, int first, int tiles) {
  const float at = (pixel - static_cast<float>(first)) * (1.0f / tile_side);
  return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(tiles - 1)));
}

/// Returns 1 / distance of the segment's point that is nearest to the middle of a tile, but at least half a tile away
/// from the segment's ends. So a short segment uses its own middle in every tile, and its order relative to others does
/// not change from tile to tile.
float inverse_near(const PlacedKnot& a, const PlacedKnot& b, float x, float y) {
  const float across = b.x - a.x, down = b.y - a.y, squared = std::max(across * across + down * down, 1e-6f);
  const float along = ((x - a.x) * across + (y - a.y) * down) / squared;
  const float end = std::min(0.5f * tile_side / std::sqrt(squared), 0.5f);
  return a.inverse + (b.inverse - a.inverse) * std::clamp(along, end, 1 - end);
}

/// Returns whether a segment misses a tile although its bounding box overlaps it.
bool passes_by(const PlacedKnot& a, const PlacedKnot& b, float x, float y, float wide) {
  constexpr float corner = 0.71f * tile_side;  // distance of a tile's corner from its middle, pixels
  const float across = b.x - a.x, down = b.y - a.y;
  const float off = (x - a.x) * down - (y - a.y) * across;
  return std::abs(off) > (corner + wide) * std::sqrt(across * across + down * down);
}

/// Returns whether two coordinates, in pixels, lie in the same row or column of tiles, in the box or beyond it.
bool same_tiles(float a, float b, int first) {
  const auto of = [&](float at) { return std::floor((at - static_cast<float>(first)) * (1.0f / tile_side)); };
  return of(a) == of(b);
}

/// Calls found(tile, first knot, 1 / distance) for each tile that each segment may touch in front of the background.
template <class Found>
void each_entry(const PixelBox& box, const TileRows& tiles, const PlacedStrands& strands,
                std::span<const float> furthest, const Found& found) {
  const auto left = static_cast<float>(box.left), top = static_cast<float>(box.top);
  const auto right = static_cast<float>(box.right), bottom = static_cast<float>(box.bottom);
  for (std::size_t i = 0; i + 1 < strands.first.size(); ++i) {
    for (std::uint32_t k = strands.first[i]; k + 1 < strands.first[i + 1]; ++k) {
      const PlacedKnot &a = strands.knots[k], &b = strands.knots[k + 1];
      if (!(a.inverse > 0 && b.inverse > 0)) continue;
      const float wide = std::max({a.half_width, b.half_width, 1.0f}) + 0.5f;
      const float x0 = std::min(a.x, b.x) - wide, x1 = std::max(a.x, b.x) + wide;
      const float y0 = std::min(a.y, b.y) - wide, y1 = std::max(a.y, b.y) + wide;
      if (!(x1 > left && x0 < right && y1 > top && y0 < bottom)) continue;
      const int first_x = tile_of(x0, box.left, tiles.across), last_x = tile_of(x1, box.left, tiles.across);
      const int first_y = tile_of(y0, box.top, tiles.down), last_y = tile_of(y1, box.top, tiles.down);
      const float nearest = std::max(a.inverse, b.inverse);
      const bool one = same_tiles(x0, x1, box.left) && same_tiles(y0, y1, box.top);
      for (int y = first_y; y <= last_y; ++y) {
        for (int x = first_x; x <= last_x; ++x) {
          const int tile = y * tiles.across + x;
          if (!(nearest > furthest[static_cast<std::size_t>(tile)])) continue;
          const float middle_x = left + (static_cast<float>(x) + 0.5f) * tile_side;
          const float middle_y = top + (static_cast<float>(y) + 0.5f) * tile_side;
          if (!one && passes_by(a, b, middle_x, middle_y, wide)) continue;
          found(tile, k, one ? 0.5f * (a.inverse + b.inverse) : inverse_near(a, b, middle_x, middle_y));
        }
      }
    }
  }
}

}  // namespace

void Bins::begin(const PixelBox& box, std::size_t batches) {
  assert(batches <= max_batches);
  box_ = box, tiles_ = tiles_of(box);
  batches_.resize(batches), first_.assign(static_cast<std::size_t>(tiles_.count()) + 1, 0);
}

std::size_t Bins::bytes() const {
  std::size_t bytes = entries_.capacity() * sizeof(BinEntry);
  for (const Batch& batch : batches_)
    bytes += batch.found.capacity() * sizeof(FoundEntry) + batch.next.capacity() * sizeof(std::uint32_t);
  return bytes;
}

void Bins::find(std::size_t batch, const PlacedStrands& strands, std::span<const float> furthest,
                const DistanceKeys& keys) {
  assert(strands.knots.size() <= max_knots);
  Batch& own = batches_[batch];
  own.next.assign(static_cast<std::size_t>(tiles_.count()), 0);
  own.found.clear(), own.found.reserve(strands.knots.size());
  each_entry(box_, tiles_, strands, furthest, [&](int tile, std::uint32_t knot, float inverse) {
    ++own.next[static_cast<std::size_t>(tile)];
    own.found.push_back(
        {static_cast<std::uint32_t>(tile), {static_cast<std::uint32_t>(batch), knot, keys.of(inverse)}});
  });
}

void Bins::allocate_entries() {
  std::uint32_t sum = 0;
  for (std::size_t tile = 0; tile + 1 < first_.size(); ++tile) {
    first_[tile] = sum;
    for (Batch& batch : batches_) sum += std::exchange(batch.next[tile], sum);
  }
  first_.back() = sum;
  entries_.resize(sum);
}

void Bins::put(std::size_t batch) {
  Batch& own = batches_[batch];
  for (const FoundEntry& found : own.found) entries_[own.next[found.tile]++] = found.entry;
}

namespace {

/// Sorts entries by one byte of their keys; the sort is stable.
void sort_by_byte(std::span<const BinEntry> entries, int shift, std::vector<BinEntry>& sorted) {
  constexpr std::size_t values = 256;
  std::array<std::uint32_t, values + 1> at{};
  const auto byte = [&](const BinEntry& entry) { return std::size_t{entry.key >> shift & (values - 1)}; };
  for (const BinEntry& entry : entries) ++at[byte(entry) + 1];
  for (std::size_t i = 0; i < values; ++i) at[i + 1] += at[i];
  sorted.resize(entries.size());
  for (const BinEntry& entry : entries) sorted[at[byte(entry)]++] = entry;
}

}  // namespace

void sort_by_distance(std::span<const BinEntry> entries, std::vector<BinEntry>& sorted,
                      std::vector<BinEntry>& scratch) {
  static_assert(DistanceKeys::end == 1 << 16);
  sort_by_byte(entries, 0, scratch), sort_by_byte(scratch, 8, sorted);
}

}  // namespace pelage
