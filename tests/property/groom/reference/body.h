// A model and its fur as plain arrays in double, for the second implementation of the tools.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <set>
#include <vector>

#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage::plain {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using Vertex = std::uint32_t;

/// The values of all fields: for each field one vector for each vertex, 0 beyond the field's own channels.
struct Fur {
  std::array<std::vector<dvec4>, field_count> values;

  std::vector<dvec4>& of(Field field) { return values[static_cast<std::size_t>(field)]; }
  const std::vector<dvec4>& of(Field field) const { return values[static_cast<std::size_t>(field)]; }
  double number(Field field, Vertex v) const { return of(field)[v].x; }
  dvec2 direction(Vertex v) const { return dvec2(of(Field::direction)[v]); }

  /// Colours times what they cover, for blending, and back.
  void multiply_colours();
  void divide_colours();
};

Fur read(const FieldSet& fields);

/// The mesh in internal coordinates, and who shares an edge with whom. `surface` answers where the nearest place is.
struct Body {
  explicit Body(const Surface& surface);

  const Surface& surface;
  std::vector<dvec3> positions, normals, tangents, bitangents;
  std::vector<std::array<Vertex, 3>> triangles;
  std::vector<std::set<Vertex>> neighbours;

  std::size_t size() const { return positions.size(); }
  dvec3 inside(dvec3 model) const;                // from model to internal coordinates
  double sizes(double value, Units units) const;  // a length of a command
  dvec2 in_frame(Vertex v, dvec3 vector) const { return {dot(vector, tangents[v]), dot(vector, bitangents[v])}; }
  dvec3 in_space(Vertex v, dvec2 direction) const { return direction.x * tangents[v] + direction.y * bitangents[v]; }
};

/// What the tools may read beside the fur itself.
struct Stage {
  Body body;
  Coat coat;
  Fur rest;  // what erase goes back to
};

/// The unit vector along `v`, or 0.
dvec3 unit(dvec3 v);

/// A vector turned by the smallest rotation that takes one direction to another, as a rotation about their cross
/// product; it stays between opposite ones.
dvec3 brought(dvec3 vector, dvec3 from, dvec3 to);

/// V + w (lean t - V), t the unit tangent part of `towards`; V where that part is shorter than 1e-6 (science.md 3).
dvec2 turned_to(const Body& body, Vertex v, dvec2 direction, dvec3 towards, double lean, double w);

}  // namespace pelage::plain
