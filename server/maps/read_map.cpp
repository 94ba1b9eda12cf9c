#include "server/maps/read_map.h"

#include <algorithm>
#include <cmath>

#include "base/colour_space.h"
#include "server/maps/draw_map.h"

namespace pelage {

namespace {

/// Returns the weighted sum of pixel(rgba) over the four taps.
template <class Pixel>
glm::dvec4 sample_bilinear(const MapPicture& picture, glm::vec2 uv, const Pixel& pixel) {
  const Taps taps = taps_at(uv, picture.width, picture.height);
  glm::dvec4 sum(0);
  for (std::size_t i = 0; i < 4; ++i) {
    if (taps.weights[i] > 0) sum += taps.weights[i] * pixel(&picture.rgba[4 * taps.pixels[i]]);
  }
  return sum;
}

/// Returns the values of one pixel; colours are premultiplied, as in an EXR.
glm::dvec4 decoded(const float* rgba, const MapLayout& layout, int bits) {
  glm::dvec4 value(0);
  for (int k = 0; k < layout.channels; ++k)
    value[k] = decode_channel(layout.kinds[static_cast<std::size_t>(k)], rgba[k], bits);
  if (layout.premultiplied && bits != 32) value = glm::dvec4(glm::dvec3(value) * value.w, value.w);
  return value;
}

/// Calls use(corner) for the corners of a vertex that are mapped, or for all if none is. Returns their number.
template <class Use>
int for_each_corner(const UvCorners& uvs, std::uint32_t vertex, const Use& use) {
  const std::span<const UvCorner> corners = uvs.of_vertex(vertex);
  const bool any = std::any_of(corners.begin(), corners.end(), [](const UvCorner& c) { return c.mapped; });
  int count = 0;
  for (const UvCorner& corner : corners) {
    if (any && !corner.mapped) continue;
    use(corner);
    ++count;
  }
  return count;
}

/// Returns the picture's value at a vertex: directions in its (tangent, bitangent), other values unchanged.
glm::dvec4 value_at_vertex(const UvCorners& uvs, std::uint32_t v, const MapPicture& picture, const MapLayout& layout,
                           MapEncoding encoding) {
  glm::dvec4 sum(0);
  const int count = for_each_corner(uvs, v, [&](const UvCorner& corner) {
    glm::dvec4 value =
        sample_bilinear(picture, corner.uv, [&](const float* rgba) { return decoded(rgba, layout, picture.bits); });
    if (encoding != MapEncoding::value) {
      const glm::dvec2 turned = corner.from_uv(glm::dvec2(value));
      value.x = turned.x, value.y = turned.y;
    }
    sum += value;
  });
  return count > 0 ? sum / static_cast<double>(count) : sum;
}

std::vector<Field> fields_of(Field field, MapEncoding encoding) {
  if (encoding == MapEncoding::fast_fur) return {Field::direction, Field::density, Field::width};
  if (encoding == MapEncoding::vector) return {Field::direction, Field::length};
  return {field};
}

glm::dvec4 unpremultiplied(glm::dvec4 colour) {
  return colour.w > 0 ? glm::dvec4(glm::dvec3(colour) / colour.w, colour.w) : glm::dvec4(0);
}

/// Splits the vector of a strand into direction and length. A vector that points into the skin is laid flat on it.
void split_vector(glm::dvec3 strand, double scale, std::uint32_t v, MapTargets& targets) {
  const double length = glm::length(strand);
  auto& directions = targets.values[static_cast<std::size_t>(Field::direction)];
  targets.values[static_cast<std::size_t>(Field::length)][v].x = length * scale;
  if (!(length > 0)) {
    targets.no_direction[v] = true;
    return;
  }
  glm::dvec2 lean = glm::dvec2(strand) / length;
  const double flat = glm::length(lean);
  if (strand.z < 0 && flat > 0) lean /= flat;
  directions[v] = glm::dvec4(lean, 0, 0);
}

void split(glm::dvec4 value, const MapLayout& layout, MapEncoding encoding, double scale, std::uint32_t v,
           MapTargets& targets) {
  const auto of = [&](Field field) -> glm::dvec4& { return targets.values[static_cast<std::size_t>(field)][v]; };
  if (encoding == MapEncoding::vector) return split_vector(glm::dvec3(value), scale, v, targets);
  const Field first = targets.fields.front();
  if (encoding == MapEncoding::value) {
    of(first) = layout.premultiplied ? unpremultiplied(value) : value * scale;
    return;
  }
  of(Field::direction) = glm::dvec4(value.x, value.y, 0, 0);
  if (encoding == MapEncoding::fast_fur) of(Field::width).x = value.z * scale, of(Field::density).x = value.w;
}

/// Reads a list with a value for each vertex.
MapTargets read_list(const Mesh& mesh, const MapPicture& list, Field field, double scale) {
  MapTargets targets;
  targets.fields = {field};
  std::vector<glm::dvec4>& values = targets.values[static_cast<std::size_t>(field)];
  values.resize(mesh.positions.size());
  for (std::size_t v = 0; v < values.size(); ++v) {
    const glm::dvec4 given(list.rgba[4 * v], list.rgba[4 * v + 1], list.rgba[4 * v + 2], list.rgba[4 * v + 3]);
    if (field == Field::direction) {
      const glm::dvec3 x(mesh.tangents[v]), y = glm::cross(glm::dvec3(mesh.normals[v]), x);
      values[v] = glm::dvec4(glm::dot(glm::dvec3(given), x), glm::dot(glm::dvec3(given), y), 0, 0);
    } else {
      values[v] = shape_of(field).channels == 4 ? given : given * scale;
    }
  }
  return targets;
}

}  // namespace

MapTargets read_map(const Mesh& mesh, const MapPicture& picture, Field field, MapEncoding encoding, double scale,
                    int tile) {
  if (encoding == MapEncoding::vertices) return read_list(mesh, picture, field, scale);
  const UvCorners uvs = in_udim(make_uv_corners(mesh), tile);
  const MapLayout layout = layout_of(field, encoding, scale, picture.bits == 32);
  MapTargets targets;
  targets.fields = fields_of(field, encoding);
  for (const Field each : targets.fields)
    targets.values[static_cast<std::size_t>(each)].resize(mesh.positions.size(), glm::dvec4(0));
  if (encoding == MapEncoding::vector) targets.no_direction.resize(mesh.positions.size(), false);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v)
    split(value_at_vertex(uvs, v, picture, layout, encoding), layout, encoding, scale, v, targets);
  if (tile != 0) {
    targets.outside_tile.resize(mesh.positions.size());
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) targets.outside_tile[v] = uvs.of_vertex(v).empty();
  }
  return targets;
}

double luminance_at(const MapPicture& picture, glm::dvec2 uv) {
  const auto colour = [](const float* rgba) { return glm::dvec4(rgba[0], rgba[1], rgba[2], rgba[3]); };
  return std::clamp(luminance(glm::dvec3(sample_bilinear(picture, uv, colour))), 0.0, 1.0);
}

std::vector<double> read_channel(const Mesh& mesh, const MapPicture& picture, PictureChannel channel) {
  const UvCorners uvs = make_uv_corners(mesh);
  const auto number = [&](glm::dvec4 rgba) {
    if (channel == PictureChannel::luminance) return luminance(glm::dvec3(rgba));
    return rgba[static_cast<int>(channel) - static_cast<int>(PictureChannel::red)];
  };
  std::vector<double> values(mesh.positions.size(), 0);
  for (std::uint32_t v = 0; v < values.size(); ++v) {
    glm::dvec4 sum(0);
    const int count = for_each_corner(uvs, v, [&](const UvCorner& corner) {
      sum += sample_bilinear(picture, corner.uv,
                             [](const float* rgba) { return glm::dvec4(rgba[0], rgba[1], rgba[2], rgba[3]); });
    });
    if (count > 0) values[v] = std::clamp(number(sum / static_cast<double>(count)), 0.0, 1.0);
  }
  return values;
}

}  // namespace pelage
