// A sparse change of fields. It holds which bits flip, so that it is its own inverse.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/limits.h"
#include "protocol/commands/coat.h"
#include "protocol/commands/field.h"

namespace pelage {

/// Half-open range of vertices.
struct VertexRange {
  std::uint32_t begin = 0, end = 0;
};

/// A field is stored on sheets: visible_sheet has the visible values; base_sheet has the values below all edit layers,
/// where any of them adds to it; from first_edit_layer on there is a sheet for each edit layer, from the lowest, with
/// what it adds at full weight.
using Sheet = std::uint8_t;
inline constexpr Sheet visible_sheet = 0, base_sheet = 1, first_edit_layer = 2;
inline constexpr std::size_t sheet_count = first_edit_layer + limits::edit_layers;

/// Applied once, it leads from one state to another; applied again, it leads back.
struct FieldDelta {
  /// The change of one field of one coat on one sheet.
  struct Part {
    Field field = Field::direction;
    std::vector<std::uint32_t> vertices;  // rising
    std::vector<std::uint32_t> flips;     // for each channel of each vertex: bits before xor bits after; not all 0
    Sheet sheet = visible_sheet;
    CoatId coat = 0;  // 0 for a field that all coats share
    bool operator==(const Part&) const = default;
  };

  std::vector<Part> parts;  // by rising sheet, then coat, then field; none is empty

  bool empty() const { return parts.empty(); }
  /// Returns the part of a field; null if the field does not change there.
  const Part* part(Field field, Sheet sheet = visible_sheet, CoatId coat = 0) const;
  /// Returns the vertices at which any field changes on any sheet, rising.
  std::vector<std::uint32_t> vertices() const;
  /// Returns the ranges of exactly those vertices at which a visible value changes.
  std::vector<VertexRange> dirty_ranges() const;
  /// Returns the size in memory.
  std::size_t bytes() const;
  bool operator==(const FieldDelta&) const = default;
};

/// Adds a vertex, which must be larger than those before it, with the changed bits of its value, if there are any.
inline void put_change(FieldDelta::Part& part, std::uint32_t vertex, const glm::vec4& before, const glm::vec4& after) {
  const int channels = shape_of(part.field).channels;
  std::uint32_t flips[4] = {}, any = 0;
  for (int c = 0; c < channels; ++c) {
    flips[c] = std::bit_cast<std::uint32_t>(before[c]) ^ std::bit_cast<std::uint32_t>(after[c]);
    any |= flips[c];
  }
  if (any == 0) return;
  part.vertices.push_back(vertex);
  part.flips.insert(part.flips.end(), flips, flips + channels);
}

/// Returns whether the first part comes before the second in a delta.
bool comes_before(const FieldDelta::Part& first, const FieldDelta::Part& second);

/// Returns both changes as one; the order does not matter. Bits that flip twice are dropped.
FieldDelta compose(const FieldDelta& first, const FieldDelta& second);

/// Sorts ranges, and joins those that touch or overlap.
std::vector<VertexRange> merge_ranges(std::vector<VertexRange> ranges);

}  // namespace pelage
