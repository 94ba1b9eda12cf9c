#include "server/fields/edit_layers.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "server/fields/colour_sum.h"
#include "server/fields/layer_stack.h"

namespace pelage {

namespace {

constexpr int nothing = -1;

int index_of(const std::string& name, const std::vector<EditLayer>& layers) {
  const auto found = std::find_if(layers.begin(), layers.end(), [&](const EditLayer& l) { return l.name == name; });
  return found == layers.end() ? nothing : static_cast<int>(found - layers.begin());
}

Status unknown(const char* pointer) { return failure(Code::invalid, "the scene has no layer of this name", pointer); }

/// New layers, and for each the number of the old one whose contents it takes.
struct Arrangement {
  std::vector<EditLayer> layers;
  std::vector<int> from;

  void insert(std::size_t place, EditLayer layer, int old) {
    layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(place), std::move(layer));
    from.insert(from.begin() + static_cast<std::ptrdiff_t>(place), old);
  }
  void erase(std::size_t place) {
    layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(place));
    from.erase(from.begin() + static_cast<std::ptrdiff_t>(place));
  }
  std::size_t place_above(const std::optional<std::string>& below) const {
    if (!below) return layers.size();
    return below->empty() ? 0 : static_cast<std::size_t>(index_of(*below, layers)) + 1;
  }
};

Arrangement arranged(const std::vector<EditLayer>& layers, const ChangeLayer& command) {
  Arrangement now{layers, {}};
  for (std::size_t k = 0; k < layers.size(); ++k) now.from.push_back(static_cast<int>(k));
  if (command.action == LayerAction::add) {
    now.insert(now.place_above(command.above),
               {command.name, command.weight.value_or(1), command.muted.value_or(false)}, nothing);
    return now;
  }
  const std::size_t at = number_of(command.name, layers);
  switch (command.action) {
    case LayerAction::add: break;
    case LayerAction::set: {
      EditLayer& layer = now.layers[at];
      layer.weight = command.weight.value_or(layer.weight), layer.muted = command.muted.value_or(layer.muted);
      if (!command.rename.empty()) layer.name = command.rename;
      break;
    }
    case LayerAction::move:
      now.erase(at);
      now.insert(now.place_above(command.above), layers[at], static_cast<int>(at));
      break;
    case LayerAction::merge_down:
      if (at > 0) now.layers[at - 1].weight = 1;
      now.erase(at);
      break;
    case LayerAction::remove: now.erase(at); break;
  }
  return now;
}

/// The layer's share of what is seen goes into what lies below it.
void merge_down(LayerStack& stack, std::size_t at, const std::vector<EditLayer>& layers, Field field) {
  const glm::dvec4 share = layers[at].weight * stack.added[at];
  if (at == 0)
    stack.base = held(field, stack.base + share);
  else
    stack.added[at - 1] = held_addition(field, layers[at - 1].weight * stack.added[at - 1] + share);
}

bool any_layer_has(Field field, const FieldSet& fields) { return !fields.untouched(under_sheet, field); }

}  // namespace

std::size_t number_of(const std::string& layer, const std::vector<EditLayer>& layers) {
  const int at = index_of(layer, layers);
  assert(at != nothing);
  return static_cast<std::size_t>(at);
}

Status check(const ChangeLayer& command, const std::vector<EditLayer>& layers) {
  const int at = index_of(command.name, layers);
  const auto taken = [](const char* pointer) { return failure(Code::invalid, "the name is taken", pointer); };
  if (command.above && !command.above->empty() && index_of(*command.above, layers) == nothing) return unknown("/above");
  if (command.action == LayerAction::add) {
    if (at != nothing) return taken("/name");
    if (layers.size() < limits::edit_layers) return {};
    return failure(Code::invalid, "the scene has too many layers", "/action",
                   "at most " + std::to_string(limits::edit_layers));
  }
  if (at == nothing) return unknown("/name");
  const int renamed = index_of(command.rename, layers);
  if (command.action == LayerAction::set && renamed != nothing && renamed != at) return taken("/rename");
  const auto muted = [&](int k) { return k >= 0 && layers[static_cast<std::size_t>(k)].muted; };
  if (command.action == LayerAction::merge_down && (muted(at) || muted(at - 1)))
    return failure(Code::invalid, "a muted layer cannot be merged", "/name", "layers that are not muted");
  return {};
}

Status check_groomed(const std::string& layer, const std::vector<EditLayer>& layers) {
  if (layer.empty()) return {};
  const int at = index_of(layer, layers);
  if (at == nothing) return unknown("/layer");
  const EditLayer& groomed = layers[static_cast<std::size_t>(at)];
  if (!groomed.muted && std::abs(groomed.weight) >= limits::least_groomed_weight) return {};
  return failure(Code::invalid, "the layer hardly shows, so that grooming it would not be seen", "/layer",
                 "not muted, and a weight of at least .05 or at most -.05");
}

std::vector<EditLayer> with_change(const std::vector<EditLayer>& layers, const ChangeLayer& command) {
  return arranged(layers, command).layers;
}

FieldDelta change_layers(const ChangeLayer& command, const std::vector<EditLayer>& layers, const FieldSet& fields) {
  const Arrangement next = arranged(layers, command);
  const auto at = static_cast<std::size_t>(std::max(index_of(command.name, layers), 0));
  FieldDelta delta;
  for (std::size_t f = 0; f < field_count; ++f) {
    const Field field = field_at(f);
    if (!any_layer_has(field, fields)) continue;
    StackWriter writer(fields, field, std::max(layers.size(), next.layers.size()));
    for (std::uint32_t v = 0; v < fields.size(); ++v) {
      LayerStack stack = stack_at(fields, field, v, layers.size());
      if (!stack.covered) continue;
      if (command.action == LayerAction::merge_down) merge_down(stack, at, layers, field);
      LayerStack moved{stack.covered, stack.base, {}};
      for (std::size_t k = 0; k < next.from.size(); ++k) {
        if (next.from[k] != nothing) moved.added[k] = stack.added[static_cast<std::size_t>(next.from[k])];
      }
      writer.put(v, moved, next.layers);
    }
    writer.finish(delta);
  }
  finish_parts(delta);
  return delta;
}

/// One field's change of what is seen.
static void keep_part(const FieldDelta::Part& part, int layer, const std::vector<EditLayer>& layers,
                      const FieldSet& fields, StackWriter& writer) {
  const int channels = shape_of(part.field).channels;
  const std::uint32_t* flips = part.flips.data();
  for (const std::uint32_t v : part.vertices) {
    const glm::vec4 before = fields.value(part.field, v);
    glm::vec4 after = before;
    for (int c = 0; c < channels; ++c)
      after[c] = std::bit_cast<float>(std::bit_cast<std::uint32_t>(before[c]) ^ flips[c]);
    flips += channels;
    LayerStack stack = stack_at(fields, part.field, v, layers.size());
    if (layer == nothing && !stack.covered) {
      writer.put_seen(v, after);
      continue;
    }
    const glm::dvec4 change =
        to_summable(part.field, glm::dvec4(after)) - to_summable(part.field, glm::dvec4(before));
    if (layer == nothing) {
      stack.base = held(part.field, stack.base + change);
    } else {
      const auto at = static_cast<std::size_t>(layer);
      stack.added[at] = held_addition(part.field, stack.added[at] + change / layers[at].weight);
    }
    writer.put(v, stack, layers);
  }
}

FieldDelta kept_in_layer(const FieldDelta& seen, const std::string& layer, const std::vector<EditLayer>& layers,
                         const FieldSet& fields) {
  const int at = index_of(layer, layers);
  FieldDelta kept;
  for (const FieldDelta::Part& part : seen.parts) {
    const bool whole = part.field == Field::mask || (at == nothing && !any_layer_has(part.field, fields));
    if (whole) {
      kept.parts.push_back(part);
      continue;
    }
    StackWriter writer(fields, part.field, layers.size());
    keep_part(part, at, layers, fields, writer);
    writer.finish(kept);
  }
  finish_parts(kept);
  return kept;
}

}  // namespace pelage
