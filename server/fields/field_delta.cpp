#include "server/fields/field_delta.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

namespace pelage {

namespace {

/// Merges two parts with rising vertices. Bits that flip in both do not change.
FieldDelta::Part compose(const FieldDelta::Part& first, const FieldDelta::Part& second) {
  const auto channels = static_cast<std::size_t>(shape_of(first.field).channels);
  FieldDelta::Part both{first.field, {}, {}, first.sheet, first.coat};
  std::size_t i = 0, k = 0;
  while (i < first.vertices.size() || k < second.vertices.size()) {
    const bool in_first =
        i < first.vertices.size() && (k == second.vertices.size() || first.vertices[i] <= second.vertices[k]);
    const bool in_second =
        k < second.vertices.size() && (i == first.vertices.size() || second.vertices[k] <= first.vertices[i]);
    std::uint32_t flips[4] = {}, any = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      flips[c] = (in_first ? first.flips[i * channels + c] : 0) ^ (in_second ? second.flips[k * channels + c] : 0);
      any |= flips[c];
    }
    if (any != 0) {
      both.vertices.push_back(in_first ? first.vertices[i] : second.vertices[k]);
      both.flips.insert(both.flips.end(), flips, flips + channels);
    }
    i += in_first, k += in_second;
  }
  return both;
}

std::vector<std::uint32_t> united(std::span<const FieldDelta::Part> parts) {
  std::vector<std::uint32_t> all;
  for (const FieldDelta::Part& part : parts) {
    if (part.vertices == all) continue;
    std::vector<std::uint32_t> merged;
    std::set_union(all.begin(), all.end(), part.vertices.begin(), part.vertices.end(), std::back_inserter(merged));
    all = std::move(merged);
  }
  return all;
}

}  // namespace

bool comes_before(const FieldDelta::Part& first, const FieldDelta::Part& second) {
  return std::tuple(first.sheet, first.coat, first.field) < std::tuple(second.sheet, second.coat, second.field);
}

const FieldDelta::Part* FieldDelta::part(Field field, Sheet sheet, CoatId coat) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
    return part.field == field && part.sheet == sheet && part.coat == coat;
  });
  return found == parts.end() ? nullptr : &*found;
}

std::vector<std::uint32_t> FieldDelta::vertices() const { return united(parts); }

std::vector<VertexRange> FieldDelta::dirty_ranges() const {
  const auto seen_end =
      std::find_if(parts.begin(), parts.end(), [](const Part& p) { return p.sheet != visible_sheet; });
  std::vector<VertexRange> ranges;
  for (const std::uint32_t v : united({parts.begin(), seen_end})) {
    if (!ranges.empty() && v == ranges.back().end) {
      ranges.back().end = v + 1;
    } else {
      ranges.push_back({v, v + 1});
    }
  }
  return ranges;
}

std::size_t FieldDelta::bytes() const {
  std::size_t sum = 0;
  for (const Part& part : parts) sum += 4 * (part.vertices.size() + part.flips.size());
  return sum;
}

FieldDelta compose(const FieldDelta& first, const FieldDelta& second) {
  FieldDelta both;
  auto a = first.parts.begin(), b = second.parts.begin();
  while (a != first.parts.end() || b != second.parts.end()) {
    const bool in_first = a != first.parts.end() && (b == second.parts.end() || !comes_before(*b, *a));
    const bool in_second = b != second.parts.end() && (a == first.parts.end() || !comes_before(*a, *b));
    FieldDelta::Part part = in_first && in_second ? compose(*a, *b) : in_first ? *a : *b;
    if (!part.vertices.empty()) both.parts.push_back(std::move(part));
    a += in_first, b += in_second;
  }
  return both;
}

std::vector<VertexRange> merge_ranges(std::vector<VertexRange> ranges) {
  std::sort(ranges.begin(), ranges.end(), [](VertexRange a, VertexRange b) { return a.begin < b.begin; });
  std::vector<VertexRange> merged;
  for (const VertexRange range : ranges) {
    if (!merged.empty() && range.begin <= merged.back().end) {
      merged.back().end = std::max(merged.back().end, range.end);
    } else {
      merged.push_back(range);
    }
  }
  return merged;
}

}  // namespace pelage
