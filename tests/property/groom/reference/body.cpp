#include "tests/property/groom/reference/body.h"

#include <algorithm>
#include <cmath>

namespace pelage::plain {

Fur read(const FieldSet& fields) {
  Fur fur;
  for (std::size_t f = 0; f < field_count; ++f) {
    for (Vertex v = 0; v < fields.size(); ++v) fur.values[f].push_back(dvec4(fields.value(field_at(f), v)));
  }
  return fur;
}

void Fur::multiply_colours() {
  for (const Field field : {Field::root_colour, Field::tip_colour}) {
    for (dvec4& value : of(field)) value.x *= value.w, value.y *= value.w, value.z *= value.w;
  }
}

void Fur::divide_colours() {
  for (const Field field : {Field::root_colour, Field::tip_colour}) {
    for (dvec4& value : of(field)) {
      for (int c = 0; c < 3; ++c) value[c] = value.w > 0 ? value[c] / value.w : 0;
    }
  }
}

Body::Body(const Surface& of) : surface(of) {
  const Mesh& mesh = of.mesh();
  for (Vertex v = 0; v < mesh.positions.size(); ++v) {
    positions.push_back(dvec3(mesh.positions[v]));
    normals.push_back(dvec3(mesh.normals[v]));
    tangents.push_back(dvec3(mesh.tangents[v]));
    bitangents.push_back(glm::cross(normals.back(), tangents.back()));
  }
  neighbours.resize(positions.size());
  for (const glm::uvec3& t : mesh.triangles) {
    triangles.push_back({t.x, t.y, t.z});
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        if (a != b) neighbours[t[a]].insert(t[b]);
      }
    }
  }
}

dvec3 Body::inside(dvec3 model) const { return (model - surface.mesh().centre) / surface.mesh().size; }

double Body::sizes(double value, Units units) const {
  return units == Units::relative ? value : value / surface.mesh().size;
}

dvec3 unit(dvec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : v;
}

dvec3 brought(dvec3 vector, dvec3 from, dvec3 to) {
  const dvec3 a = unit(from), b = unit(to), turn = glm::cross(a, b);
  const double sine = glm::length(turn), cosine = glm::dot(a, b);
  if (sine < 3e-5) return cosine < 0 ? vector : vector - glm::dot(vector, b) * b;
  const dvec3 axis = turn / sine;  // rotation by Rodrigues' formula
  return vector * cosine + glm::cross(axis, vector) * sine + axis * (glm::dot(axis, vector) * (1 - cosine));
}

dvec2 turned_to(const Body& body, Vertex v, dvec2 direction, dvec3 towards, double lean, double w) {
  const dvec2 part = body.in_frame(v, towards);
  const double along = std::sqrt(part.x * part.x + part.y * part.y);
  if (along < 1e-6) return direction;
  return (1 - w) * direction + w * lean / along * part;
}

}  // namespace pelage::plain
