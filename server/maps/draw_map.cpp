#include "server/maps/draw_map.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

bool is_float(MapFormat format) { return format == MapFormat::exr || format == MapFormat::exr_half; }

double largest(const FieldSet& fields, Field field) {
  if (fields.at_rest(field)) return shape_of(field).rest;
  const std::vector<float>& values = fields.values(field);
  return *std::max_element(values.begin(), values.end());
}

/// Which field the scale is of; shares need none.
Field scaled_field(Field field, MapEncoding encoding) {
  if (encoding == MapEncoding::fast_fur) return Field::width;
  return encoding == MapEncoding::vector ? Field::length : field;
}

bool is_length(Field field) { return field == Field::length; }

/// The asked scale, or the one that uses the whole range of a PNG; in the field's unit, lengths in sizes.
double scale_of(const Mesh& mesh, const FieldSet& fields, const MapRequest& request, MapEncoding encoding) {
  const Field scaled = scaled_field(request.field, encoding);
  const bool world = is_length(scaled) && request.units == Units::world;
  if (request.scale) return world ? *request.scale / mesh.size : *request.scale;
  const bool is_open = scaled == Field::length || scaled == Field::stretch || scaled == Field::width;
  if (is_float(request.format)) return world ? 1 / mesh.size : 1;
  if (!is_open) return 1;
  const double most = largest(fields, scaled);
  return most > 0 ? most : 1;
}

/// A corner's value in the map, colours multiplied by what they cover.
glm::dvec4 value_at(const UvCorner& corner, const FieldSet& fields, Field field, MapEncoding encoding, double scale) {
  const glm::dvec4 value(fields.value(field, corner.vertex));
  if (encoding == MapEncoding::value) {
    if (shape_of(field).channels == 4) return glm::dvec4(glm::dvec3(value) * value.w, value.w);
    return value / scale;
  }
  const glm::dvec2 direction = corner.to_uv(glm::dvec2(value));
  if (encoding == MapEncoding::uv_tangent) return glm::dvec4(direction, 0, 0);
  if (encoding == MapEncoding::fast_fur) {
    return glm::dvec4(direction, fields.number(Field::width, corner.vertex) / scale,
                      fields.number(Field::density, corner.vertex));
  }
  const double upright = std::sqrt(std::max(1 - glm::dot(direction, direction), 0.0));
  return glm::dvec4(direction, upright, 0) * (double{fields.number(Field::length, corner.vertex)} / scale);
}

void divide_by_cover(MapImage& image) {
  for (std::size_t i = 0; i < image.values.size(); i += 4) {
    const float cover = image.values[i + 3];
    for (std::size_t k = 0; k < 3; ++k) image.values[i + k] = cover > 0 ? image.values[i + k] / cover : 0.0f;
  }
}

double covered_share(const MapImage& image) {
  const auto count = std::count(image.covered.begin(), image.covered.end(), std::uint8_t{1});
  return static_cast<double>(count) / static_cast<double>(image.covered.size());
}

}  // namespace

DrawnMap draw_map(const Mesh& mesh, const FieldSet& fields, const MapRequest& request) {
  const MapEncoding encoding = encoding_of(request.field, request.encoding);
  const double scale = scale_of(mesh, fields, request, encoding);
  const UvCorners uvs = make_uv_corners(mesh);
  std::vector<glm::vec4> values;
  values.reserve(uvs.corners.size());
  for (const UvCorner& corner : uvs.corners)
    values.emplace_back(value_at(corner, fields, request.field, encoding, scale));

  DrawnMap map;
  map.layout = layout_of(request.field, encoding, scale, is_float(request.format));
  map.image = make_map_image(request.size, map.layout.channels, map.layout.background);
  draw_triangles(uvs, values, map.image);
  const double covered = covered_share(map.image);
  dilate(map.image, request.dilate);
  fit_corners(uvs, values, map.layout.least, map.layout.most, map.image);
  if (map.layout.premultiplied && !is_float(request.format)) divide_by_cover(map.image);
  map.answer = {.field = request.field, .encoding = encoding, .units = request.units, .covered = covered};
  const bool world = is_length(scaled_field(request.field, encoding)) && request.units == Units::world;
  map.answer.scale = world ? scale * mesh.size : scale;
  map.answer.outside = count_outside(uvs);
  return map;
}

}  // namespace pelage
