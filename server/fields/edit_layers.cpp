#include "server/fields/edit_layers.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "server/fields/field_set.h"

namespace pelage {

namespace {

Sheet sheet_of(std::size_t layer) { return static_cast<Sheet>(first_edit_layer + layer); }

/// Returns a sum as visible_sheet and base_sheet store it.
glm::vec4 stored_sum(Field field, glm::dvec4 sum) {
  if (field == Field::direction) return glm::vec4(stored_direction(glm::dvec2(sum)), 0, 0);
  const glm::dvec4 value = from_summable(field, sum);
  glm::vec4 result(0);
  for (int c = 0; c < shape_of(field).channels; ++c) result[c] = stored_value(field, value[c]);
  return result;
}

/// Returns an addition as it is stored: 0 in place of -0, and only the field's own channels.
glm::vec4 stored_addition(Field field, glm::dvec4 added) {
  glm::vec4 result(0);
  for (int c = 0; c < shape_of(field).channels; ++c) result[c] = static_cast<float>(added[c]) + 0.0f;
  return result;
}

}  // namespace

EditLayerStack stack_at(const FieldSet& fields, Field field, std::uint32_t vertex, std::size_t layers) {
  EditLayerStack stack;
  const glm::vec4 under = fields.on_sheet(base_sheet, field, vertex);
  stack.covered = under.x == under.x;  // NaN where no edit layer adds anything
  stack.base = to_summable(field, glm::dvec4(stack.covered ? under : fields.value(field, vertex)));
  for (std::size_t k = 0; stack.covered && k < layers; ++k)
    stack.added[k] = glm::dvec4(fields.on_sheet(sheet_of(k), field, vertex));
  return stack;
}

glm::dvec4 clamped(Field field, glm::dvec4 sum) {
  const FieldShape& shape = shape_of(field);
  if (field == Field::direction) {
    const double length = glm::length(glm::dvec2(sum));
    return length > 1 ? sum / length : sum;
  }
  if (shape.channels == 1) return {glm::clamp(sum.x, double{shape.min}, double{shape.max}), 0, 0, 0};
  const double cover = glm::clamp(sum.w, 0.0, 1.0);
  return {glm::clamp(glm::dvec3(sum), 0.0, cover), cover};
}

glm::dvec4 clamped_addition(Field field, glm::dvec4 added) {
  const double max = 1000.0 * shape_of(field).max;
  return glm::clamp(added, -max, max);
}

glm::dvec4 visible_value(const EditLayerStack& stack, Field field, const std::vector<EditLayer>& layers) {
  glm::dvec4 sum = stack.base;
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (!layers[k].muted) sum = clamped(field, sum + layers[k].weight * stack.added[k]);
  }
  return sum;
}

StackWriter::StackWriter(const FieldSet& fields, Field field, std::size_t sheets) : fields_(fields), field_(field) {
  for (std::size_t s = 0; s < first_edit_layer + sheets; ++s)
    parts_.push_back({field, {}, {}, static_cast<Sheet>(s), fields.owner(field)});
}

void StackWriter::put(std::uint32_t vertex, Sheet sheet, glm::vec4 value) {
  put_change(parts_[sheet], vertex, fields_.on_sheet(sheet, field_, vertex), value);
}

void StackWriter::put(std::uint32_t vertex, const EditLayerStack& stack, const std::vector<EditLayer>& layers) {
  // The visible value is computed from the stored ones, so that computing it again gives the same bits.
  const glm::vec4 base = stored_sum(field_, stack.base);
  EditLayerStack stored{true, to_summable(field_, glm::dvec4(base)), {}};
  bool adds = false;
  for (std::size_t s = first_edit_layer; s < parts_.size(); ++s) {
    const glm::vec4 added = stored_addition(field_, stack.added[s - first_edit_layer]);
    adds = adds || added != glm::vec4(0);
    stored.added[s - first_edit_layer] = glm::dvec4(added);
    put(vertex, static_cast<Sheet>(s), added);
  }
  put(vertex, visible_sheet, adds ? stored_sum(field_, visible_value(stored, field_, layers)) : base);
  put(vertex, base_sheet, adds ? base : glm::vec4(std::numeric_limits<float>::quiet_NaN()));
}

void StackWriter::finish(FieldDelta& delta) {
  for (FieldDelta::Part& part : parts_) {
    if (!part.vertices.empty()) delta.parts.push_back(std::move(part));
  }
}

void finish_parts(FieldDelta& delta) { std::sort(delta.parts.begin(), delta.parts.end(), comes_before); }

namespace {

constexpr int no_layer = -1;

int index_of(const std::string& name, const std::vector<EditLayer>& layers) {
  const auto found = std::find_if(layers.begin(), layers.end(), [&](const EditLayer& l) { return l.name == name; });
  return found == layers.end() ? no_layer : static_cast<int>(found - layers.begin());
}

Status unknown(const char* pointer) {
  return failure(Code::invalid, "the scene has no edit layer of this name", pointer);
}

/// New edit layers, and for each the index of the old one whose contents it takes.
struct Arrangement {
  std::vector<EditLayer> layers;
  std::vector<int> from;

  void insert(std::size_t index, EditLayer layer, int old) {
    layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(index), std::move(layer));
    from.insert(from.begin() + static_cast<std::ptrdiff_t>(index), old);
  }
  void erase(std::size_t index) {
    layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(index));
    from.erase(from.begin() + static_cast<std::ptrdiff_t>(index));
  }
  std::size_t index_above(const std::optional<std::string>& below) const {
    if (!below) return layers.size();
    return below->empty() ? 0 : static_cast<std::size_t>(index_of(*below, layers)) + 1;
  }
};

Arrangement arranged(const std::vector<EditLayer>& layers, const ChangeEditLayer& command) {
  Arrangement now{layers, {}};
  for (std::size_t k = 0; k < layers.size(); ++k) now.from.push_back(static_cast<int>(k));
  if (command.action == EditLayerAction::add) {
    now.insert(now.index_above(command.above),
               {command.name, command.weight.value_or(1), command.muted.value_or(false), command.coat.value_or("")},
               no_layer);
    return now;
  }
  const std::size_t at = edit_layer_index(command.name, layers);
  switch (command.action) {
    case EditLayerAction::add: break;
    case EditLayerAction::set: {
      EditLayer& layer = now.layers[at];
      layer.weight = command.weight.value_or(layer.weight), layer.muted = command.muted.value_or(layer.muted);
      if (!command.rename.empty()) layer.name = command.rename;
      break;
    }
    case EditLayerAction::move:
      now.erase(at);
      now.insert(now.index_above(command.above), layers[at], static_cast<int>(at));
      break;
    case EditLayerAction::merge_down:
      if (at > 0) now.layers[at - 1].weight = 1;
      now.erase(at);
      break;
    case EditLayerAction::remove: now.erase(at); break;
  }
  return now;
}

/// Adds the edit layer's weighted share to the edit layer below it or, for the lowest, to the groom.
void merge_down(EditLayerStack& stack, std::size_t at, const std::vector<EditLayer>& layers, Field field) {
  const glm::dvec4 share = layers[at].weight * stack.added[at];
  if (at == 0)
    stack.base = clamped(field, stack.base + share);
  else
    stack.added[at - 1] = clamped_addition(field, layers[at - 1].weight * stack.added[at - 1] + share);
}

bool any_edit_layer_has(Field field, const FieldSet& fields) { return !fields.untouched(base_sheet, field); }

}  // namespace

std::size_t edit_layer_index(const std::string& layer, const std::vector<EditLayer>& layers) {
  const int at = index_of(layer, layers);
  assert(at != no_layer);
  return static_cast<std::size_t>(at);
}

Status check(const ChangeEditLayer& command, const std::vector<EditLayer>& layers) {
  const int at = index_of(command.name, layers);
  const auto taken = [](const char* pointer) { return failure(Code::invalid, "the name is taken", pointer); };
  if (command.above && !command.above->empty() && index_of(*command.above, layers) == no_layer)
    return unknown("/above");
  if (command.action == EditLayerAction::add) {
    if (at != no_layer) return taken("/name");
    if (layers.size() < limits::edit_layers) return {};
    return failure(Code::invalid, "the scene has too many edit layers", "/action",
                   "at most " + std::to_string(limits::edit_layers));
  }
  if (at == no_layer) return unknown("/name");
  const int renamed = index_of(command.rename, layers);
  if (command.action == EditLayerAction::set && renamed != no_layer && renamed != at) return taken("/rename");
  const auto muted = [&](int k) { return k >= 0 && layers[static_cast<std::size_t>(k)].muted; };
  if (command.action == EditLayerAction::merge_down && (muted(at) || muted(at - 1)))
    return failure(Code::invalid, "a muted edit layer cannot be merged", "/name", "edit layers that are not muted");
  return {};
}

Status check_groomed(const std::string& layer, const std::vector<EditLayer>& layers) {
  if (layer.empty()) return {};
  const int at = index_of(layer, layers);
  if (at == no_layer) return unknown("/edit_layer");
  const EditLayer& groomed = layers[static_cast<std::size_t>(at)];
  if (!groomed.muted && std::abs(groomed.weight) >= limits::min_groomed_weight) return {};
  return failure(Code::invalid, "the edit layer hardly shows, so that grooming it would not be seen", "/edit_layer",
                 "not muted, and a weight of at least .05 or at most -.05");
}

std::vector<EditLayer> with_change(const std::vector<EditLayer>& layers, const ChangeEditLayer& command) {
  return arranged(layers, command).layers;
}

/// Adds the change of the selected coat. Fields that all coats share belong to coat 0.
static void change_edit_layers(const ChangeEditLayer& command, const std::vector<EditLayer>& layers,
                               const FieldSet& fields, FieldDelta& delta) {
  const Arrangement next = arranged(layers, command);
  const auto at = static_cast<std::size_t>(std::max(index_of(command.name, layers), 0));
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (fields.owner(field) != fields.coat() || !any_edit_layer_has(field, fields)) continue;
    StackWriter writer(fields, field, std::max(layers.size(), next.layers.size()));
    for (std::uint32_t v = 0; v < fields.size(); ++v) {
      EditLayerStack stack = stack_at(fields, field, v, layers.size());
      if (!stack.covered) continue;
      if (command.action == EditLayerAction::merge_down) merge_down(stack, at, layers, field);
      EditLayerStack moved{stack.covered, stack.base, {}};
      for (std::size_t k = 0; k < next.from.size(); ++k) {
        if (next.from[k] != no_layer) moved.added[k] = stack.added[static_cast<std::size_t>(next.from[k])];
      }
      writer.put(v, moved, next.layers);
    }
    writer.finish(delta);
  }
}

FieldDelta change_edit_layers(const ChangeEditLayer& command, const std::vector<EditLayer>& layers,
                              const FieldSet& fields) {
  FieldDelta delta;
  for (std::size_t coat = 0; coat < fields.coats(); ++coat)
    change_edit_layers(command, layers, fields.of_coat(static_cast<CoatId>(coat)), delta);
  finish_parts(delta);
  return delta;
}

/// Stores one field's change of the visible values in the groom or an edit layer.
static void store_part(const FieldDelta::Part& part, int layer, const std::vector<EditLayer>& layers,
                       const FieldSet& fields, StackWriter& writer) {
  const int channels = shape_of(part.field).channels;
  const std::uint32_t* flips = part.flips.data();
  for (const std::uint32_t v : part.vertices) {
    const glm::vec4 before = fields.value(part.field, v);
    glm::vec4 after = before;
    for (int c = 0; c < channels; ++c)
      after[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(before[c]) ^ flips[c]);
    flips += channels;
    EditLayerStack stack = stack_at(fields, part.field, v, layers.size());
    if (layer == no_layer && !stack.covered) {
      writer.put_visible(v, after);
      continue;
    }
    const glm::dvec4 change = to_summable(part.field, glm::dvec4(after)) - to_summable(part.field, glm::dvec4(before));
    if (layer == no_layer) {
      stack.base = clamped(part.field, stack.base + change);
    } else {
      const auto at = static_cast<std::size_t>(layer);
      stack.added[at] = clamped_addition(part.field, stack.added[at] + change / layers[at].weight);
    }
    writer.put(v, stack, layers);
  }
}

FieldDelta stored_in_edit_layer(const FieldDelta& seen, const std::string& layer, const std::vector<EditLayer>& layers,
                                const FieldSet& fields) {
  const int at = index_of(layer, layers);
  FieldDelta stored;
  for (const FieldDelta::Part& part : seen.parts) {
    const bool unchanged = part.field == Field::mask || (at == no_layer && !any_edit_layer_has(part.field, fields));
    if (unchanged) {
      stored.parts.push_back(part);
      continue;
    }
    StackWriter writer(fields, part.field, layers.size());
    store_part(part, at, layers, fields, writer);
    writer.finish(stored);
  }
  finish_parts(stored);
  return stored;
}

}  // namespace pelage
