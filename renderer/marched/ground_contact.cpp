#include "renderer/marched/ground_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "protocol/base/clamped_index.h"
#include "protocol/base/parallel.h"
#include "renderer/marched/depth_map.h"

namespace pelage {

namespace {

constexpr int contact_texels = 256, taps = 40;
constexpr float contact_radius = 0.75f;  // of the view from below: the model and what surrounds it, sizes
constexpr float contact_reach = 0.22f;   // sizes

/// Where around a place the skin above is looked for, and how much it counts.
struct Tap {
  glm::vec2 off{0};
  float square = 0;  // of the distance, as it counts
  float weight = 0;
};

std::array<Tap, taps> make_taps() {
  std::array<Tap, taps> all;
  for (int i = 0; i < taps; ++i) {
    const float angle = 2.399963f * static_cast<float>(i), radius = (static_cast<float>(i) + 0.5f) / taps;
    Tap& tap = all[static_cast<std::size_t>(i)];
    tap.off = contact_reach * radius * glm::vec2(std::cos(angle), std::sin(angle));
    const float reach = std::max(contact_reach * radius, 0.004f);
    tap.square = reach * reach, tap.weight = 1 - 0.6f * reach / contact_reach;
  }
  return all;
}

/// Between the four texels around a place, which lies at x, y texels; outside the nearest counts.
float between(const DepthMap& map, glm::vec2 at) {
  const glm::vec2 low = glm::floor(at - 0.5f), share = at - 0.5f - low;
  const auto texel = [&](int x, int y) {
    return map.at(clamped_index(low.x + static_cast<float>(x), 0, map.side - 1),
                  clamped_index(low.y + static_cast<float>(y), 0, map.side - 1));
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), share.x), glm::mix(texel(0, 1), texel(1, 1), share.x), share.y);
}

}  // namespace

GroundContact make_ground_contact(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                                  float height, int threads) {
  const LightView below = *view_of_light({.direction = {0, 1, 0}}, contact_radius, contact_texels);
  const DepthMap map = draw_depth_map(places, triangles, below, contact_texels, threads);
  const std::array<Tap, taps> all = make_taps();
  const float lowest = below.axis.y * height + below.axis.w;
  const auto hidden_at = [&](float x, float z) {
    float sum = 0, whole = 0;
    for (const Tap& tap : all) {
      const glm::vec4 clip = below.world_to_clip * glm::vec4(x + tap.off.x, height, z + tap.off.y, 1);
      const float above =
          between(map, (glm::vec2(0.5f, -0.5f) * glm::vec2(clip) + 0.5f) * float{contact_texels}) - lowest;
      sum += tap.weight / (1 + above * above / (tap.square + 0.0036f)), whole += tap.weight;
    }
    return sum / whole;
  };
  GroundContact contact;
  constexpr int side = GroundContact::side;
  contact.hidden.resize(std::size_t{side} * side);
  for_each_in_parallel(
      side,
      [&](std::uint32_t row) {
        const auto place = [](std::size_t i) {
          return GroundContact::extent * (2 * (static_cast<float>(i) + 0.5f) / side - 1);
        };
        for (std::size_t i = 0; i < side; ++i) contact.hidden[row * side + i] = hidden_at(place(i), place(row));
      },
      threads);
  return contact;
}

}  // namespace pelage
