#include "server/fields/field_mix.h"

#include <array>
#include <cassert>
#include <functional>

#include "server/fields/edit_layers.h"
#include "server/fields/field_set.h"
#include "server/surface/geodesics.h"

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

/// Returns the value of a vertex, in summable form, for a mean.
using ValueOf = std::function<glm::dvec4(std::uint32_t vertex)>;

glm::dvec4 mixed_direction(const ValueOf& value, std::span<const MixShare> shares, const Mesh& from, const Mesh& to,
                           std::uint32_t vertex) {
  const Frame frame = frame_of(to, vertex);
  glm::dvec3 sum(0);
  for (const MixShare& share : shares) {
    if (share.weight == 0) continue;
    const glm::dvec4 own = value(share.vertex);
    if (share.weight == 1 && same_frame(from, share.vertex, to, vertex)) return own;
    const Frame there = frame_of(from, share.vertex);
    sum += share.weight * transported(own.x * there.tangent + own.y * there.bitangent, there.normal, frame.normal);
  }
  return {glm::dot(sum, frame.tangent), glm::dot(sum, frame.bitangent), 0, 0};
}

/// Returns the mean of values in summable form.
glm::dvec4 mean(Field field, const ValueOf& value, std::span<const MixShare> shares, const Mesh& from, const Mesh& to,
                std::uint32_t vertex) {
  if (field == Field::direction) return mixed_direction(value, shares, from, to, vertex);
  glm::dvec4 sum(0);
  for (const MixShare& share : shares) sum += share.weight * value(share.vertex);
  return sum;
}

/// Returns the mean of the stacks of several vertices: of the groom below the edit layers, and of their additions.
EditLayerStack mixed_stack(const FieldSet& fields, Field field, std::span<const MixShare> shares, const Mesh& from,
                           const Mesh& to, std::uint32_t vertex, std::size_t layers) {
  const auto at = [&](std::uint32_t v) { return stack_at(fields, field, v, layers); };
  const auto mean_of = [&](const ValueOf& value) { return mean(field, value, shares, from, to, vertex); };
  EditLayerStack stack;
  for (const MixShare& share : shares) stack.covered = stack.covered || (share.weight > 0 && at(share.vertex).covered);
  if (!stack.covered) return stack;
  stack.base = mean_of([&](std::uint32_t v) { return at(v).base; });
  for (std::size_t k = 0; k < layers; ++k) stack.added[k] = mean_of([&](std::uint32_t v) { return at(v).added[k]; });
  return stack;
}

/// Calls fill(own, field) for each coat and each of its touched fields; the coat is selected in both sets.
template <class Fill>
void fill_each(const FieldSet& fields, FieldSet& result, const Fill& fill) {
  for (std::size_t c = 0; c < fields.coats(); ++c) {
    const auto coat = static_cast<CoatId>(c);
    const FieldSet own = fields.of_coat(coat);
    result.select(coat);
    for (std::size_t f = 0; f < field_count; ++f)
      if (own.owner(field_at(f)) == coat && !own.at_default(field_at(f))) fill(own, field_at(f));
  }
  result.select(fields.coat());
}

/// Writes the stacks of vertices that edit layers cover into `result`; does nothing if none covers the field.
void put_stacks(FieldSet& result, Field field, const FieldSet& fields, const std::vector<EditLayer>& layers,
                const std::function<EditLayerStack(std::uint32_t)>& stack_of) {
  if (fields.untouched(base_sheet, field)) return;
  StackWriter writer(result, field, layers.size());
  for (std::uint32_t v = 0; v < result.size(); ++v) {
    const EditLayerStack stack = stack_of(v);
    if (stack.covered) writer.put(v, stack, layers);
  }
  FieldDelta delta;
  writer.finish(delta);
  result.apply(delta);
}

}  // namespace

glm::dvec4 mixed(const FieldSet& fields, Field field, std::span<const MixShare> shares, const Mesh& from,
                 const Mesh& to, std::uint32_t vertex) {
  const auto value = [&](std::uint32_t v) { return to_summable(field, glm::dvec4(fields.value(field, v))); };
  return from_summable(field, mean(field, value, shares, from, to, vertex));
}

FieldSet subdivided(const FieldSet& fields, const Mesh& before, const Mesh& after,
                    const std::vector<glm::uvec2>& parents, const std::vector<EditLayer>& layers) {
  const auto old = static_cast<std::uint32_t>(fields.size());
  assert(before.positions.size() == old && after.positions.size() == old + parents.size());
  FieldSet result(after.positions.size());
  fill_each(fields, result, [&](const FieldSet& own, Field field) {
    const auto parents_of = [&](std::uint32_t v) {
      return std::array<MixShare, 2>{{{parents[v - old].x, 0.5}, {parents[v - old].y, 0.5}}};
    };
    for (std::uint32_t v = 0; v < old; ++v) result.set(field, v, own.value(field, v));
    for (std::uint32_t v = old; v < after.positions.size(); ++v)
      result.set(field, v, stored(field, mixed(own, field, parents_of(v), before, after, v)));
    put_stacks(result, field, own, layers, [&](std::uint32_t v) {
      return v < old ? stack_at(own, field, v, layers.size())
                     : mixed_stack(own, field, parents_of(v), before, after, v, layers.size());
    });
  });
  return result;
}

FieldSet transferred(const FieldSet& fields, const Mesh& before, const Mesh& after,
                     const std::vector<std::array<MixShare, 3>>& shares, double length_scale,
                     const std::vector<EditLayer>& layers) {
  assert(before.positions.size() == fields.size() && after.positions.size() == shares.size());
  FieldSet result(shares.size());
  fill_each(fields, result, [&](const FieldSet& own, Field field) {
    const double factor = field == Field::length ? length_scale : 1;
    for (std::uint32_t v = 0; v < shares.size(); ++v)
      result.set(field, v, stored(field, factor * mixed(own, field, shares[v], before, after, v)));
    put_stacks(result, field, own, layers, [&](std::uint32_t v) {
      EditLayerStack stack = mixed_stack(own, field, shares[v], before, after, v, layers.size());
      stack.base *= factor;
      for (glm::dvec4& added : stack.added) added *= factor;
      return stack;
    });
  });
  return result;
}

FieldSet rotated(const FieldSet& fields, const Mesh& before, const Mesh& after, const glm::dmat3& rotation,
                 const std::vector<EditLayer>& layers) {
  assert(before.positions.size() == fields.size() && after.positions.size() == fields.size());
  FieldSet result = fields;
  const auto along = [&](std::uint32_t vertex, glm::dvec4 value) {
    const Frame from = frame_of(before, vertex), to = frame_of(after, vertex);
    const glm::dvec3 direction = rotation * (value.x * from.tangent + value.y * from.bitangent);
    return glm::dvec4(glm::dot(direction, to.tangent), glm::dot(direction, to.bitangent), 0, 0);
  };
  fill_each(fields, result, [&](const FieldSet& own, Field field) {
    if (field != Field::direction) return;
    for (std::uint32_t v = 0; v < fields.size(); ++v)
      result.set(field, v, stored(field, along(v, glm::dvec4(own.value(field, v)))));
    put_stacks(result, field, own, layers, [&](std::uint32_t v) {
      EditLayerStack stack = stack_at(own, field, v, layers.size());
      if (!stack.covered) return stack;
      stack.base = along(v, stack.base);
      for (std::size_t k = 0; k < layers.size(); ++k) stack.added[k] = along(v, stack.added[k]);
      return stack;
    });
  });
  return result;
}

}  // namespace pelage
