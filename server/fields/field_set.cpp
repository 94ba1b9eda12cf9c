#include "server/fields/field_set.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "protocol/base/random.h"

namespace pelage {

namespace {

constexpr std::uint32_t dirty_gap = 64;

std::uint64_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

void add_hash(FieldsHash& sum, std::uint64_t field, std::uint64_t vertex, std::uint64_t bits, bool remove) {
  const std::uint64_t key = (vertex << 2) | field;
  const std::uint64_t low = mix_bits(bits ^ mix_bits(key));
  const std::uint64_t high = mix_bits(bits + mix_bits(~key));
  sum.low += remove ? 0 - low : low;
  sum.high += remove ? 0 - high : high;
}

void add_hash(FieldsHash& sum, std::uint32_t vertex, const Groom& groom, bool remove) {
  add_hash(sum, 0, vertex, bits_of(groom.direction.x) << 32 | bits_of(groom.direction.y), remove);
  add_hash(sum, 1, vertex, bits_of(groom.length), remove);
  add_hash(sum, 2, vertex, bits_of(groom.stretch), remove);
}

}  // namespace

Groom stored_groom(glm::dvec2 direction, double length, double stretch) {
  const double inclination = glm::length(direction);
  if (inclination > 1) direction /= inclination;
  glm::vec2 rounded(direction);
  const glm::dvec2 wide(rounded);
  if (glm::dot(wide, wide) > 1) rounded = glm::vec2(direction * (1 - 2e-7));  // rounding must not pass 1
  return {rounded + 0.0f, static_cast<float>(length) + 0.0f, static_cast<float>(stretch) + 0.0f};
}

FieldSet::FieldSet(std::size_t vertices) {
  direction_.values.resize(vertices);
  length_.values.resize(vertices);
  stretch_.values.resize(vertices);
  for (std::uint32_t v = 0; v < vertices; ++v) add_hash(hash_, v, {}, false);
}

void FieldSet::set(std::uint32_t vertex, const Groom& groom) {
  assert(vertex < size());
  const Groom clean{groom.direction + 0.0f, groom.length + 0.0f, groom.stretch + 0.0f};
  add_hash(hash_, vertex, at(vertex), true);
  direction_.values[vertex] = clean.direction;
  length_.values[vertex] = clean.length;
  stretch_.values[vertex] = clean.stretch;
  add_hash(hash_, vertex, clean, false);
}

FieldsHash FieldSet::hash_after(const FieldDelta& delta) const {
  FieldsHash hash = hash_;
  for (std::size_t i = 0; i < delta.vertices.size(); ++i) {
    add_hash(hash, delta.vertices[i], delta.before[i], true);
    add_hash(hash, delta.vertices[i], delta.after[i], false);
  }
  return hash;
}

void FieldSet::apply(const FieldDelta& delta) {
  for (std::size_t i = 0; i < delta.vertices.size(); ++i) {
    assert(at(delta.vertices[i]) == delta.before[i]);
    set(delta.vertices[i], delta.after[i]);
  }
}

FieldDelta difference(const FieldSet& from, const FieldSet& to) {
  assert(from.size() == to.size());
  FieldDelta delta;
  for (std::uint32_t v = 0; v < from.size(); ++v) {
    if (from.at(v) == to.at(v)) continue;
    delta.vertices.push_back(v);
    delta.before.push_back(from.at(v));
    delta.after.push_back(to.at(v));
  }
  return delta;
}

std::vector<VertexRange> merge_ranges(std::vector<VertexRange> ranges, std::uint32_t gap) {
  std::sort(ranges.begin(), ranges.end(), [](VertexRange a, VertexRange b) { return a.begin < b.begin; });
  std::vector<VertexRange> merged;
  for (const VertexRange range : ranges) {
    if (!merged.empty() && range.begin < std::uint64_t{merged.back().end} + gap) {
      merged.back().end = std::max(merged.back().end, range.end);
    } else {
      merged.push_back(range);
    }
  }
  return merged;
}

std::vector<VertexRange> FieldDelta::dirty_ranges() const {
  std::vector<VertexRange> ranges;
  for (const std::uint32_t v : vertices) {
    if (!ranges.empty() && v < std::uint64_t{ranges.back().end} + dirty_gap) {
      ranges.back().end = v + 1;
    } else {
      ranges.push_back({v, v + 1});
    }
  }
  return ranges;
}

FieldDelta inverse(FieldDelta delta) {
  std::swap(delta.before, delta.after);
  return delta;
}

FieldDelta compose(const FieldDelta& first, const FieldDelta& second) {
  FieldDelta both;
  const auto add = [&both](std::uint32_t vertex, const Groom& before, const Groom& after) {
    if (before == after) return;
    both.vertices.push_back(vertex);
    both.before.push_back(before);
    both.after.push_back(after);
  };
  std::size_t i = 0, k = 0;
  while (i < first.vertices.size() || k < second.vertices.size()) {
    const bool in_first =
        i < first.vertices.size() && (k == second.vertices.size() || first.vertices[i] <= second.vertices[k]);
    const bool in_second =
        k < second.vertices.size() && (i == first.vertices.size() || second.vertices[k] <= first.vertices[i]);
    assert(!in_first || !in_second || first.after[i] == second.before[k]);
    add(in_first ? first.vertices[i] : second.vertices[k], in_first ? first.before[i] : second.before[k],
        in_second ? second.after[k] : first.after[i]);
    i += in_first;
    k += in_second;
  }
  return both;
}

}  // namespace pelage
