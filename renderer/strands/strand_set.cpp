#include "renderer/strands/strand_set.h"

#include <algorithm>
#include <cmath>

#include "renderer/strands/grow.h"
#include "renderer/strands/strand_part.h"

namespace pelage {

namespace {
constexpr float brightest = 4, colour_steps = 1023;
}

std::uint32_t pack_colour(glm::vec3 colour) {
  const glm::vec3 share = glm::sqrt(glm::clamp(colour / brightest, 0.0f, 1.0f)) * colour_steps + 0.5f;
  return static_cast<std::uint32_t>(share.r) | static_cast<std::uint32_t>(share.g) << 10 |
         static_cast<std::uint32_t>(share.b) << 20;
}

glm::vec3 unpack_colour(std::uint32_t packed) {
  const glm::vec3 share = glm::vec3(packed & 1023, packed >> 10 & 1023, packed >> 20 & 1023) / colour_steps;
  return brightest * share * share;
}

std::size_t StrandSet::bytes() const {
  return (points.size() + closing.size()) * sizeof(StrandPoint) +
         (colours.size() + to_mean.size() + neighbour.size()) * sizeof(std::uint32_t) +
         roots.size() * sizeof(StrandRoot);
}

namespace {

/// A piece of the surface, its centroid and its expected number of strands.
struct Placed {
  glm::vec3 middle;
  std::uint32_t piece;
  double strands;
};

/// Halves a set of pieces across the longest side of its bounding box until each chunk expects few enough strands.
/// Chunks are compact, so that a local change touches few of them.
void add_chunks(std::span<Placed> pieces, double strands_each, std::vector<StrandChunk>& chunks) {
  double strands = 0;
  glm::vec3 low(1e9f), high(-1e9f);
  for (const Placed& placed : pieces)
    low = glm::min(low, placed.middle), high = glm::max(high, placed.middle), strands += placed.strands;
  if (pieces.size() == 1 || strands <= strands_each) {
    StrandChunk& chunk = chunks.emplace_back();
    for (const Placed& placed : pieces) chunk.push_back(placed.piece);
    std::sort(chunk.begin(), chunk.end());
    return;
  }
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = pieces.size() / 2;
  std::nth_element(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(half), pieces.end(),
                   [axis](const Placed& a, const Placed& b) {
                     return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.piece < b.piece;
                   });
  add_chunks(pieces.first(half), strands_each, chunks);
  add_chunks(pieces.subspan(half), strands_each, chunks);
}

}  // namespace

std::vector<StrandChunk> make_chunks(const FurModel& model, EachCoat<Coat> coats, double strands_each) {
  std::vector<Placed> pieces;
  pieces.reserve(model.triangles.size());
  for (std::uint32_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::vec3 sum = model.positions[t.x] + model.positions[t.y] + model.positions[t.z];
    double strands = 0;
    for (const Coat& coat : coats) strands += expected_strands(model.corners[i], coat);
    pieces.push_back({sum / 3.0f, i, strands});
  }
  std::vector<StrandChunk> chunks;
  if (!pieces.empty()) add_chunks(pieces, strands_each, chunks);
  return chunks;
}

}  // namespace pelage
