#include "renderer/skin/fur_vertex.h"

#include <algorithm>

#include "renderer/skin/bare.h"

namespace pelage {

namespace {

float value_of(std::span<const float> field, std::size_t vertex, float default_value) {
  return field.empty() ? default_value : field[vertex];
}

/// Returns a colour premultiplied by its cover, so that it fades out over an edge without the colour of unpainted
/// vertices.
glm::vec4 covered(std::span<const glm::vec4> field, std::size_t vertex) {
  return field.empty() ? glm::vec4(0) : glm::vec4(glm::vec3(field[vertex]) * field[vertex].a, field[vertex].a);
}

}  // namespace

FurVertex fur_vertex(const FurFields& fields, std::size_t v, glm::vec3 position, glm::vec3 normal) {
  const FurPaint& paint = fields.paint;
  const double skin = fields.skin.empty() ? 1 : fur_share(fields.skin, position, normal);
  const float bare = value_of(paint.bare, v, 0);
  return {fields.direction[v],           std::max(fields.length[v] * static_cast<float>(skin) * (1 - bare), 0.0f),
          value_of(paint.density, v, 1), value_of(paint.width, v, 1),
          value_of(paint.wetness, v, 0), bare,
          value_of(paint.curl, v, 0),    value_of(paint.clump, v, 0),
          covered(paint.root_colour, v), covered(paint.tip_colour, v)};
}

}  // namespace pelage
