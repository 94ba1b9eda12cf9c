#include "server/fields/layer_stack.h"

#include <algorithm>
#include <limits>

#include "server/fields/colour_sum.h"

namespace pelage {

namespace {

Sheet sheet_of(std::size_t layer) { return static_cast<Sheet>(first_layer + layer); }

/// As it is stored on the seen and the under sheet.
glm::vec4 stored(Field field, glm::dvec4 sum) {
  if (field == Field::direction) return glm::vec4(stored_direction(glm::dvec2(sum)), 0, 0);
  const glm::dvec4 value = from_summable(field, sum);
  glm::vec4 result(0);
  for (int c = 0; c < shape_of(field).channels; ++c) result[c] = stored_value(field, value[c]);
  return result;
}

/// 0 in place of -0, and only the field's own channels.
glm::vec4 stored_addition(Field field, glm::dvec4 added) {
  glm::vec4 result(0);
  for (int c = 0; c < shape_of(field).channels; ++c) result[c] = static_cast<float>(added[c]) + 0.0f;
  return result;
}

}  // namespace

LayerStack stack_at(const FieldSet& fields, Field field, std::uint32_t vertex, std::size_t layers) {
  LayerStack stack;
  const glm::vec4 under = fields.on_sheet(under_sheet, field, vertex);
  stack.covered = under.x == under.x;  // at rest it is NaN
  stack.base = to_summable(field, glm::dvec4(stack.covered ? under : fields.value(field, vertex)));
  for (std::size_t k = 0; stack.covered && k < layers; ++k)
    stack.added[k] = glm::dvec4(fields.on_sheet(sheet_of(k), field, vertex));
  return stack;
}

glm::dvec4 held(Field field, glm::dvec4 sum) {
  const FieldShape& shape = shape_of(field);
  if (field == Field::direction) {
    const double length = glm::length(glm::dvec2(sum));
    return length > 1 ? sum / length : sum;
  }
  if (shape.channels == 1) return {glm::clamp(sum.x, double{shape.least}, double{shape.most}), 0, 0, 0};
  const double cover = glm::clamp(sum.w, 0.0, 1.0);
  return {glm::clamp(glm::dvec3(sum), 0.0, cover), cover};
}

glm::dvec4 held_addition(Field field, glm::dvec4 added) {
  const double most = 1000.0 * shape_of(field).most;
  return glm::clamp(added, -most, most);
}

glm::dvec4 seen_through(const LayerStack& stack, Field field, const std::vector<EditLayer>& layers) {
  glm::dvec4 sum = stack.base;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (!layers[k].muted) sum = held(field, sum + layers[k].weight * stack.added[k]);
  }
  return sum;
}

StackWriter::StackWriter(const FieldSet& fields, Field field, std::size_t sheets) : fields_(fields), field_(field) {
  for (std::size_t s = 0; s < first_layer + sheets; ++s) parts_.push_back({field, {}, {}, static_cast<Sheet>(s)});
}

void StackWriter::put(std::uint32_t vertex, Sheet sheet, glm::vec4 value) {
  put_change(parts_[sheet], vertex, fields_.on_sheet(sheet, field_, vertex), value);
}

void StackWriter::put(std::uint32_t vertex, const LayerStack& stack, const std::vector<EditLayer>& layers) {
  // What is seen follows from what is stored, so that making it anew gives the same bits.
  const glm::vec4 base = stored(field_, stack.base);
  LayerStack kept{true, to_summable(field_, glm::dvec4(base)), {}};
  bool adds = false;
  for (std::size_t s = first_layer; s < parts_.size(); ++s) {
    const glm::vec4 added = stored_addition(field_, stack.added[s - first_layer]);
    adds = adds || added != glm::vec4(0);
    kept.added[s - first_layer] = glm::dvec4(added);
    put(vertex, static_cast<Sheet>(s), added);
  }
  put(vertex, seen_sheet, adds ? stored(field_, seen_through(kept, field_, layers)) : base);
  put(vertex, under_sheet, adds ? base : glm::vec4(std::numeric_limits<float>::quiet_NaN()));
}

void StackWriter::finish(FieldDelta& delta) {
  for (FieldDelta::Part& part : parts_) {
    if (!part.vertices.empty()) delta.parts.push_back(std::move(part));
  }
}

void finish_parts(FieldDelta& delta) { std::sort(delta.parts.begin(), delta.parts.end(), comes_before); }

}  // namespace pelage
