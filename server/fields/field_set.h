// The fields on a surface's vertices, their hash, and sparse changes of them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "protocol/commands/answers.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A value on each vertex; its own type so that it cannot be mixed with one on triangles or corners.
template <class T>
struct VertexField {
  std::vector<T> values;
};

/// What one vertex holds.
struct Groom {
  glm::vec2 direction{0};  // in the vertex's (tangent, bitangent); length is the inclination, [0, 1]
  float length = 0;        // sizes, >= 0
  float stretch = 0;       // what the attracting stick has built up, >= 0
  bool operator==(const Groom&) const = default;
};

/// The nearest groom that can be stored: no direction longer than 1 after rounding, and 0 in place of -0.
Groom stored_groom(glm::dvec2 direction, double length, double stretch);

/// Half-open range of vertices.
struct VertexRange {
  std::uint32_t begin = 0, end = 0;
};

/// A sparse change: rising vertices with what they held and what they hold. Applying needs `before` to match.
struct FieldDelta {
  std::vector<std::uint32_t> vertices;
  std::vector<Groom> before, after;

  bool empty() const { return vertices.empty(); }
  /// Runs of touched vertices, merged where gaps are under 64.
  std::vector<VertexRange> dirty_ranges() const;
};

/// Sorts, and joins ranges with fewer than `gap` vertices between them.
std::vector<VertexRange> merge_ranges(std::vector<VertexRange> ranges, std::uint32_t gap);

FieldDelta inverse(FieldDelta delta);
/// First `first`, then `second`; vertices that end where they began are dropped.
FieldDelta compose(const FieldDelta& first, const FieldDelta& second);

class FieldSet {
 public:
  /// All fur upright and of length 0.
  explicit FieldSet(std::size_t vertices);

  std::size_t size() const { return direction_.values.size(); }
  Groom at(std::uint32_t vertex) const {
    return {direction_.values[vertex], length_.values[vertex], stretch_.values[vertex]};
  }
  const std::vector<glm::vec2>& direction() const { return direction_.values; }
  const std::vector<float>& length() const { return length_.values; }
  const std::vector<float>& stretch() const { return stretch_.values; }
  /// Kept up to date for touched vertices only.
  FieldsHash hash() const { return hash_; }

  /// What it will be once the delta is applied.
  FieldsHash hash_after(const FieldDelta& delta) const;

  /// Asserts that the delta's `before` is what the fields hold.
  void apply(const FieldDelta& delta);
  void set(std::uint32_t vertex, const Groom& groom);

 private:
  VertexField<glm::vec2> direction_;
  VertexField<float> length_;
  VertexField<float> stretch_;
  FieldsHash hash_;
};

/// The change that leads from one set of fields to another on the same vertices.
FieldDelta difference(const FieldSet& from, const FieldSet& to);

/// By field ("direction", "length", "stretch"), those that changed only: the vertices that changed a bit, and by how
/// much. A direction's change is the length of the difference, in inclinations.
std::vector<FieldChange> measure(const FieldDelta& delta);

/// The first groom: from nose to tail (-Z) and a little down, with the mesh's length scale; -0 is stored as 0.
FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur);

}  // namespace pelage
