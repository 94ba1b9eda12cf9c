#include "server/fields/field_mix.h"

#include <cassert>

#include "server/surface/transport.h"

namespace pelage {

namespace {

/// A vertex's frame, orthonormal to double precision.
struct Frame {
  glm::dvec3 normal, tangent, bitangent;
};

Frame frame_of(const Mesh& mesh, std::uint32_t vertex) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(mesh.normals[vertex]));
  const glm::dvec3 stored(mesh.tangents[vertex]);
  const glm::dvec3 tangent = glm::normalize(stored - glm::dot(stored, normal) * normal);
  return {normal, tangent, glm::cross(normal, tangent)};
}

bool same_frame(const Mesh& a, std::uint32_t at_a, const Mesh& b, std::uint32_t at_b) {
  return a.normals[at_a] == b.normals[at_b] && a.tangents[at_a] == b.tangents[at_b];
}

glm::vec4 stored(Field field, glm::dvec4 value) {
  if (field == Field::direction) return {stored_direction(glm::dvec2(value)), 0, 0};
  glm::vec4 result(0);
  for (int c = 0; c < shape_of(field).channels; ++c) result[c] = stored_value(field, value[c]);
  return result;
}

glm::dvec4 mixed_direction(const FieldSet& fields, std::span<const MixShare> shares, const Mesh& from, const Mesh& to,
                           std::uint32_t vertex) {
  const Frame frame = frame_of(to, vertex);
  glm::dvec3 sum(0);
  for (const MixShare& share : shares) {
    if (share.weight == 0) continue;
    const glm::dvec4 own(fields.value(Field::direction, share.vertex));
    if (share.weight == 1 && same_frame(from, share.vertex, to, vertex)) return own;
    const Frame there = frame_of(from, share.vertex);
    sum += share.weight * transported(own.x * there.tangent + own.y * there.bitangent, there.normal, frame.normal);
  }
  return {glm::dot(sum, frame.tangent), glm::dot(sum, frame.bitangent), 0, 0};
}

glm::dvec4 mixed_colour(const FieldSet& fields, Field field, std::span<const MixShare> shares) {
  glm::dvec4 premultiplied(0), plain(0);
  for (const MixShare& share : shares) {
    const glm::dvec4 own(fields.value(field, share.vertex));
    premultiplied += share.weight * glm::dvec4(glm::dvec3(own) * own.w, own.w);
    plain += share.weight * own;
  }
  if (premultiplied.w <= 0) return plain;
  return {glm::dvec3(premultiplied) / premultiplied.w, premultiplied.w};
}

}  // namespace

glm::dvec4 mixed(const FieldSet& fields, Field field, std::span<const MixShare> shares, const Mesh& from,
                 const Mesh& to, std::uint32_t vertex) {
  if (field == Field::direction) return mixed_direction(fields, shares, from, to, vertex);
  if (shape_of(field).channels == 4) return mixed_colour(fields, field, shares);
  glm::dvec4 sum(0);
  for (const MixShare& share : shares) sum += share.weight * glm::dvec4(fields.value(field, share.vertex));
  return sum;
}

FieldSet refined(const FieldSet& fields, const Mesh& before, const Mesh& after,
                 const std::vector<glm::uvec2>& parents) {
  const auto old = static_cast<std::uint32_t>(fields.size());
  assert(before.positions.size() == old && after.positions.size() == old + parents.size());
  FieldSet result(after.positions.size());
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (fields.at_rest(field)) continue;
    for (std::uint32_t v = 0; v < old; ++v) result.set(field, v, fields.value(field, v));
    for (std::uint32_t k = 0; k < parents.size(); ++k) {
      const MixShare shares[] = {{parents[k].x, 0.5}, {parents[k].y, 0.5}};
      result.set(field, old + k, stored(field, mixed(fields, field, shares, before, after, old + k)));
    }
  }
  return result;
}

}  // namespace pelage
