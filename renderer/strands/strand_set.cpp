#include "renderer/strands/strand_set.h"

#include <algorithm>
#include <cmath>

#include "renderer/strands/grow.h"

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

/// A triangle of the surface, its centroid and its expected number of strands.
struct WeightedTriangle {
  glm::vec3 middle;
  std::uint32_t triangle;
  double strands;
};

/// Halves a set of triangles across the longest side of its bounding box until each chunk expects few enough strands.
/// Chunks are compact, so that a local change touches few of them.
void add_chunks(std::span<WeightedTriangle> triangles, double strands_each, std::vector<StrandChunk>& chunks) {
  double strands = 0;
  glm::vec3 low(1e9f), high(-1e9f);
  for (const WeightedTriangle& weighted : triangles)
    low = glm::min(low, weighted.middle), high = glm::max(high, weighted.middle), strands += weighted.strands;
  if (triangles.size() == 1 || strands <= strands_each) {
    StrandChunk& chunk = chunks.emplace_back();
    for (const WeightedTriangle& weighted : triangles) chunk.push_back(weighted.triangle);
    std::sort(chunk.begin(), chunk.end());
    return;
  }
  const glm::vec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = triangles.size() / 2;
  std::nth_element(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
                   [axis](const WeightedTriangle& a, const WeightedTriangle& b) {
                     return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis]
                                                             : a.triangle < b.triangle;
                   });
  add_chunks(triangles.first(half), strands_each, chunks);
  add_chunks(triangles.subspan(half), strands_each, chunks);
}

}  // namespace

std::vector<StrandChunk> make_chunks(const FurModel& model, EachCoat<Coat> coats, double strands_each) {
  std::vector<WeightedTriangle> triangles;
  triangles.reserve(model.triangles.size());
  for (std::uint32_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::vec3 sum = model.positions[t.x] + model.positions[t.y] + model.positions[t.z];
    double strands = 0;
    for (const Coat& coat : coats) strands += expected_strands(model.corners[i], coat);
    triangles.push_back({sum / 3.0f, i, strands});
  }
  std::vector<StrandChunk> chunks;
  if (!triangles.empty()) add_chunks(triangles, strands_each, chunks);
  return chunks;
}

}  // namespace pelage
