#include "server/fields/field_mix.h"

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

/// The value of a vertex that enters a mean.
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

/// The mean of values that add up.
glm::dvec4 mean(Field field, const ValueOf& value, std::span<const MixShare> shares, const Mesh& from, const Mesh& to,
                std::uint32_t vertex) {
  if (field == Field::direction) return mixed_direction(value, shares, from, to, vertex);
  glm::dvec4 sum(0);
  for (const MixShare& share : shares) sum += share.weight * value(share.vertex);
  return sum;
}

/// What lies under the edit layers and what each of them adds, at the vertices that any edit layer covers.
class SubdividedEditLayers {
 public:
  SubdividedEditLayers(const FieldSet& fields, Field field, const Mesh& before, const Mesh& after, std::size_t layers)
      : fields_(fields), field_(field), before_(before), after_(after), layers_(layers) {}

  EditLayerStack at(std::uint32_t vertex, glm::uvec2 parents) const {
    const MixShare shares[] = {{parents.x, 0.5}, {parents.y, 0.5}};
    EditLayerStack stack;
    stack.covered = stack_at(parents.x).covered || stack_at(parents.y).covered;
    stack.base = mixed(vertex, shares, [&](std::uint32_t v) { return stack_at(v).base; });
    for (std::size_t k = 0; stack.covered && k < layers_; ++k)
      stack.added[k] = mixed(vertex, shares, [&](std::uint32_t v) { return stack_at(v).added[k]; });
    return stack;
  }
  EditLayerStack stack_at(std::uint32_t old) const { return pelage::stack_at(fields_, field_, old, layers_); }

 private:
  glm::dvec4 mixed(std::uint32_t vertex, std::span<const MixShare> shares, const ValueOf& value) const {
    return mean(field_, value, shares, before_, after_, vertex);
  }

  const FieldSet& fields_;
  Field field_;
  const Mesh &before_, &after_;
  std::size_t layers_;
};

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
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (fields.at_default(field)) continue;
    for (std::uint32_t v = 0; v < old; ++v) result.set(field, v, fields.value(field, v));
    for (std::uint32_t k = 0; k < parents.size(); ++k) {
      const MixShare shares[] = {{parents[k].x, 0.5}, {parents[k].y, 0.5}};
      result.set(field, old + k, stored(field, mixed(fields, field, shares, before, after, old + k)));
    }
    if (fields.untouched(under_sheet, field)) continue;
    const SubdividedEditLayers finer(fields, field, before, after, layers.size());
    StackWriter writer(result, field, layers.size());
    for (std::uint32_t v = 0; v < after.positions.size(); ++v) {
      const EditLayerStack stack = v < old ? finer.stack_at(v) : finer.at(v, parents[v - old]);
      if (stack.covered) writer.put(v, stack, layers);
    }
    FieldDelta delta;
    writer.finish(delta);
    result.apply(delta);
  }
  return result;
}

FieldSet turned(const FieldSet& fields, const Mesh& before, const Mesh& after, const glm::dmat3& turn,
                const std::vector<EditLayer>& layers) {
  assert(before.positions.size() == fields.size() && after.positions.size() == fields.size());
  constexpr Field field = Field::direction;
  FieldSet result = fields;
  if (fields.at_default(field)) return result;
  const auto along = [&](std::uint32_t vertex, glm::dvec4 value) {
    const Frame from = frame_of(before, vertex), to = frame_of(after, vertex);
    const glm::dvec3 direction = turn * (value.x * from.tangent + value.y * from.bitangent);
    return glm::dvec4(glm::dot(direction, to.tangent), glm::dot(direction, to.bitangent), 0, 0);
  };
  for (std::uint32_t v = 0; v < fields.size(); ++v)
    result.set(field, v, stored(field, along(v, glm::dvec4(fields.value(field, v)))));
  if (fields.untouched(under_sheet, field)) return result;
  StackWriter writer(result, field, layers.size());
  for (std::uint32_t v = 0; v < fields.size(); ++v) {
    EditLayerStack stack = stack_at(fields, field, v, layers.size());
    if (!stack.covered) continue;
    stack.base = along(v, stack.base);
    for (std::size_t k = 0; k < layers.size(); ++k) stack.added[k] = along(v, stack.added[k]);
    writer.put(v, stack, layers);
  }
  FieldDelta delta;
  writer.finish(delta);
  result.apply(delta);
  return result;
}

}  // namespace pelage
