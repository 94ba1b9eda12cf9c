// A sparse change of fields. It holds which bits turn over, so that it is its own inverse.
#pragma once

#include <cstdint>
#include <vector>

#include "protocol/commands/field.h"

namespace pelage {

/// Half-open range of vertices.
struct VertexRange {
  std::uint32_t begin = 0, end = 0;
};

/// Applied once it leads from one state to another, applied again it leads back.
struct FieldDelta {
  /// The change of one field.
  struct Part {
    Field field = Field::direction;
    std::vector<std::uint32_t> vertices;  // rising
    std::vector<std::uint32_t> flips;     // for each vertex its channels: the bits before xor the bits after; not all 0
    bool operator==(const Part&) const = default;
  };

  std::vector<Part> parts;  // by rising field; none is empty

  bool empty() const { return parts.empty(); }
  /// Null when the field does not change.
  const Part* part(Field field) const;
  /// The vertices at which any field changes, rising.
  std::vector<std::uint32_t> vertices() const;
  /// Runs of touched vertices, merged where gaps are under 64.
  std::vector<VertexRange> dirty_ranges() const;
  /// What it takes in memory.
  std::size_t bytes() const;
  bool operator==(const FieldDelta&) const = default;
};

/// Both, one after the other, in either order; what turns over twice is dropped.
FieldDelta compose(const FieldDelta& first, const FieldDelta& second);

/// Sorts, and joins ranges with fewer than `gap` vertices between them.
std::vector<VertexRange> merge_ranges(std::vector<VertexRange> ranges, std::uint32_t gap);

}  // namespace pelage
