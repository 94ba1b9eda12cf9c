#include "renderer/marched/light_map_overlay.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "protocol/base/clamped_index.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/shadow_width.h"
#include "renderer/overlay/plain_overlay.h"

namespace pelage {

namespace {

/// One number for each texel, black at the one end and white at the other.
struct Greys {
  int side = 1;
  std::vector<float> values;
  float black = 0, white = 1;

  /// The texel that a place lies in, in texels; beyond an edge the nearest.
  float at(float x, float y) const {
    const auto column = static_cast<std::size_t>(clamped_index(x, 0, side - 1)),
               row = static_cast<std::size_t>(clamped_index(y, 0, side - 1));
    return values[row * static_cast<std::size_t>(side) + column];
  }
  float shade(float value) const { return std::clamp((value - black) / (white - black), 0.0f, 1.0f); }
  float nearest(glm::vec2 place) const {
    const glm::vec2 texel = place * static_cast<float>(side);
    return shade(at(texel.x, texel.y));
  }
  /// Between four texels, as shadows read widths.
  float between(glm::vec2 place) const {
    const glm::vec2 texel = place * static_cast<float>(side) - 0.5f, low = glm::floor(texel), share = texel - low;
    const float x = low.x, y = low.y;
    return shade(glm::mix(glm::mix(at(x, y), at(x + 1, y), share.x), glm::mix(at(x, y + 1), at(x + 1, y + 1), share.x),
                          share.y));
  }
};

std::vector<float> firsts(const std::vector<glm::vec2>& pairs) {
  std::vector<float> values;
  for (const glm::vec2& pair : pairs) values.push_back(pair.x);
  return values;
}

Greys greys_of(const FurFrame& frame, const FurLight& light, const LightView& view, float radius, const MarchMesh& mesh,
               int threads) {
  const int side = frame.knobs.shadow_resolution;
  const float middle = view.axis.w;  // depth of the model's centre
  const DepthMap skin = draw_depth_map(mesh.positions, mesh.triangles, view, side, threads);
  if (frame.overlay == Overlay::light_depth) {
    const bool hull = light.cast_shadow == CastShadow::penumbra;
    const DepthMap& depths =
        hull ? draw_depth_map(fur_hull(mesh, frame.coat), mesh.triangles, view, side, threads) : skin;
    return {side, depths.depths, middle + radius, middle - radius};
  }
  const std::vector<glm::vec2> occlusion =
      occlusion_map(mesh.positions, mesh.normals, mesh.triangles, view, skin, threads);
  if (frame.overlay == Overlay::light_occlusion) return {side, firsts(occlusion)};
  return {shadow_width_side(side), firsts(shadow_widths(occlusion, side))};
}

}  // namespace

bool is_light_map(Overlay overlay) {
  return overlay == Overlay::light_depth || overlay == Overlay::light_occlusion || overlay == Overlay::shadow_width;
}

std::optional<FloatImage> light_map_overlay(const FurFrame& frame, const MarchMesh& mesh, int threads) {
  const auto light = std::find_if(frame.lights.begin(), frame.lights.end(),
                                  [](const FurLight& each) { return each.cast_shadow != CastShadow::none; });
  if (!frame.knobs.shadow_maps || light == frame.lights.end()) return {};
  const float radius = radius_of_fur(mesh);
  const std::optional<LightView> view = view_of_light(*light, radius, frame.knobs.shadow_resolution);
  if (!view) return {};
  const Greys greys = greys_of(frame, *light, *view, radius, mesh, threads);
  const auto side = static_cast<float>(std::min(frame.width, frame.height));
  const glm::vec2 corner = 0.5f * (glm::vec2(frame.width, frame.height) - side);
  return plain_overlay(frame.width, frame.height, threads, [&](int x, int y) {
    const glm::vec2 at = (glm::vec2(x, y) + 0.5f - corner) / side;
    const bool beside = at.x < 0 || at.y < 0 || at.x > 1 || at.y > 1;
    const float grey = beside ? 0.0f : frame.overlay == Overlay::shadow_width ? greys.between(at) : greys.nearest(at);
    return glm::vec4(glm::vec3(grey), 1);
  });
}

}  // namespace pelage
