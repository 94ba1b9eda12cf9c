// A model and its fur as plain arrays in double, for the reference implementation of the tools.
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

/// The values of all fields: for each field a vector for each vertex, 0 beyond the field's own channels.
struct Fur {
  std::array<std::vector<dvec4>, field_count> values;

  std::vector<dvec4>& of(Field field) { return values[static_cast<std::size_t>(field)]; }
  const std::vector<dvec4>& of(Field field) const { return values[static_cast<std::size_t>(field)]; }
  double number(Field field, Vertex v) const { return of(field)[v].x; }
  dvec2 direction(Vertex v) const { return dvec2(of(Field::direction)[v]); }

  /// Premultiplies colours by their coverage for blending, and divides them again.
  void multiply_colours();
  void divide_colours();
};

Fur read(const FieldSet& fields);

/// The mesh in internal coordinates, with the neighbours of each vertex. `surface` finds the nearest surface point.
struct Body {
  explicit Body(const Surface& surface);

  const Surface& surface;
  std::vector<dvec3> positions, normals, tangents, bitangents;
  std::vector<std::array<Vertex, 3>> triangles;
  std::vector<std::set<Vertex>> neighbours;

  std::size_t size() const { return positions.size(); }
  dvec3 inside(dvec3 model) const;                // converts from model to internal coordinates
  double sizes(double value, Units units) const;  // converts a command's length to model sizes
  dvec2 in_frame(Vertex v, dvec3 vector) const { return {dot(vector, tangents[v]), dot(vector, bitangents[v])}; }
  dvec3 in_space(Vertex v, dvec2 direction) const { return direction.x * tangents[v] + direction.y * bitangents[v]; }
};

/// What tools may read besides the fur itself.
struct Stage {
  Body body;
  Coat coat;
  Fur baseline;  // the fur that erase restores
};

/// Returns the unit vector along `v`, or 0 for a zero vector.
dvec3 unit(dvec3 v);

/// Rotates a vector by the smallest rotation that takes one direction to the other, about their cross product. If the
/// directions are opposite, the vector is kept.
dvec3 brought(dvec3 vector, dvec3 from, dvec3 to);

/// Returns V + w (lean t - V), where t is the unit tangent part of `towards`; V if that part is shorter than 1e-6
/// (science.md 3).
dvec2 turned_to(const Body& body, Vertex v, dvec2 direction, dvec3 towards, double lean, double w);

}  // namespace pelage::plain
