#include "renderer/strands/strand_set.h"

#include <algorithm>
#include <cmath>

#include "renderer/strands/even_order.h"
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
         neighbour.size() * sizeof(std::uint32_t) + roots.size() * sizeof(StrandRoot);
}

namespace {

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
    order.push_back({place_on_curve(sum / 3.0), i});
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
