#include "server/fields/field_writer.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace pelage {

bool FieldWriter::put(std::uint32_t vertex, glm::dvec4 value) {
  assert(part_.vertices.empty() || part_.vertices.back() < vertex);
  const Field field = part_.field;
  const int channels = shape_of(field).channels;
  const glm::vec4 before = fields_.value(field, vertex);
  glm::vec4 after = before;
  bool clamped = false;
  if (field == Field::direction) {
    after = glm::vec4(stored_direction(glm::dvec2(value)), 0, 0);
  } else {
    for (int c = 0; c < channels; ++c) {
      after[c] = stored_value(field, value[c]);
      clamped = clamped || value[c] < shape_of(field).min || value[c] > shape_of(field).max;
    }
  }
  if (before == after) return clamped;
  part_.vertices.push_back(vertex);
  for (int c = 0; c < channels; ++c) {
    part_.flips.push_back(std::bit_cast<std::uint32_t>(before[c]) ^ std::bit_cast<std::uint32_t>(after[c]));
  }
  return clamped;
}

void FieldWriter::reserve(std::size_t vertices) {
  part_.vertices.reserve(vertices);
  part_.flips.reserve(vertices * static_cast<std::size_t>(shape_of(part_.field).channels));
}

void FieldWriter::finish_together(std::span<FieldWriter> writers, FieldDelta& delta) {
  if (writers.empty()) return;
  std::size_t vertices = 0;
  for (const FieldWriter& writer : writers) vertices += writer.part_.vertices.size();
  FieldWriter all(writers.front().fields_, writers.front().part_.field);
  all.reserve(vertices);
  for (const FieldWriter& writer : writers) {
    const FieldDelta::Part& part = writer.part_;
    all.part_.vertices.insert(all.part_.vertices.end(), part.vertices.begin(), part.vertices.end());
    all.part_.flips.insert(all.part_.flips.end(), part.flips.begin(), part.flips.end());
  }
  all.finish(delta);
}

void FieldWriter::finish(FieldDelta& delta) {
  if (part_.vertices.empty()) return;
  assert(delta.parts.empty() || comes_before(delta.parts.back(), part_));
  delta.parts.push_back(std::move(part_));
}

glm::dvec4& WorkingField::at(std::uint32_t vertex) {
  const auto [entry, added] = touched_.try_emplace(vertex);
  if (added) entry->second = glm::dvec4(fields_.value(field_, vertex));
  return entry->second;
}

std::size_t WorkingField::finish(FieldDelta& delta) const {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(touched_.size());
  for (const auto& [vertex, value] : touched_) vertices.push_back(vertex);
  std::sort(vertices.begin(), vertices.end());
  FieldWriter writer(fields_, field_);
  std::size_t clamped = 0;
  for (const std::uint32_t v : vertices) clamped += writer.put(v, touched_.at(v));
  writer.finish(delta);
  return clamped;
}

}  // namespace pelage
