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
  return (points.size() + closing.size()) * sizeof(StrandPoint) + colours.size() * sizeof(std::uint32_t) +
         roots.size() * sizeof(StrandRoot);
}

namespace {

/// Every third bit of the result is one of the 21 bits of x.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Place along a Z curve (Morton 1966) through [-1, 1]^3, in which a model of diagonal 1 about the origin lies.
std::uint64_t morton(glm::dvec3 place) {
  const glm::dvec3 cell = glm::clamp((place + 1.0) * 0x1p20, 0.0, 0x1p21 - 1);
  return spread_bits(static_cast<std::uint64_t>(cell.x)) | spread_bits(static_cast<std::uint64_t>(cell.y)) << 1 |
         spread_bits(static_cast<std::uint64_t>(cell.z)) << 2;
}

struct Placed {
  std::uint64_t code;
  std::uint32_t piece;
  bool operator<(const Placed& other) const { return code != other.code ? code < other.code : piece < other.piece; }
};

}  // namespace

std::vector<StrandChunk> make_chunks(const FurModel& model, const Coat& coat, double strands_each) {
  std::vector<Placed> order;
  order.reserve(model.triangles.size());
  for (std::uint32_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::dvec3 sum =
        glm::dvec3(model.positions[t.x]) + glm::dvec3(model.positions[t.y]) + glm::dvec3(model.positions[t.z]);
    order.push_back({morton(sum / 3.0), i});
  }
  std::sort(order.begin(), order.end());
  std::vector<StrandChunk> chunks;
  double strands = 0;
  for (const Placed& placed : order) {
    if (chunks.empty() || strands >= strands_each) chunks.emplace_back(), strands = 0;
    chunks.back().push_back(placed.piece);
    strands += expected_strands(model.corners[placed.piece], coat);
  }
  return chunks;
}

}  // namespace pelage
