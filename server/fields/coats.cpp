#include "server/fields/coats.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>

#include "server/fields/edit_layers.h"

namespace pelage {

namespace {

Status refused(std::size_t entry, const char* member, const char* message, const std::string& limit) {
  return failure(Code::invalid, message, "/coats/" + std::to_string(entry) + member, limit);
}

std::string listed(const std::vector<NamedCoat>& coats) {
  std::string names;
  for (const NamedCoat& coat : coats) names += (names.empty() ? "" : ", ") + coat.name;
  return names;
}

/// Returns the coat that an entry refers to; null for a new coat.
const NamedCoat* coat_of(const CoatEntry& entry, const std::vector<NamedCoat>& coats) {
  const auto found = std::ranges::find_if(
      coats, [&](const NamedCoat& coat) { return entry.id ? coat.id == *entry.id : coat.name == entry.name; });
  return found == coats.end() ? nullptr : &*found;
}

const NamedCoat& beginning_of(const CoatEntry& entry, const std::vector<NamedCoat>& coats) {
  const NamedCoat* from = find_coat(coats, entry.begins ? entry.begins->from : "");
  assert(from);  // the command was checked
  return *from;
}

/// Returns the id of the coat of each entry. A new coat without an id gets the lowest free one; limits::coats or more
/// if there is none. The ids of removed coats are free only for the next command.
std::vector<CoatId> ids_of(const SetCoats& command, const std::vector<NamedCoat>& coats) {
  std::array<bool, limits::coats> taken{};
  for (const NamedCoat& coat : coats) taken[coat.id] = true;
  for (const CoatEntry& entry : command.coats)
    if (entry.id) taken[*entry.id] = true;
  std::vector<CoatId> ids;
  for (const CoatEntry& entry : command.coats) {
    const NamedCoat* coat = coat_of(entry, coats);
    const auto free = static_cast<std::size_t>(std::ranges::find(taken, false) - taken.begin());
    ids.push_back(coat ? coat->id : static_cast<CoatId>(entry.id.value_or(free)));
    if (ids.back() < taken.size()) taken[ids.back()] = true;
  }
  return ids;
}

}  // namespace

const NamedCoat* find_coat(const std::vector<NamedCoat>& coats, const std::string& name) {
  if (name.empty()) return &coats.front();
  const auto found = std::ranges::find(coats, name, &NamedCoat::name);
  return found == coats.end() ? nullptr : &*found;
}

std::vector<CoatEntry> names_of(const std::vector<NamedCoat>& coats) {
  std::vector<CoatEntry> names;
  for (const NamedCoat& coat : coats) names.push_back({.name = coat.name, .id = coat.id, .muted = coat.muted});
  return names;
}

const NamedCoat& first_unmuted(const std::vector<NamedCoat>& coats) {
  const auto seen = std::ranges::find(coats, false, &NamedCoat::muted);
  assert(seen != coats.end());
  return *seen;
}

Status check(const SetCoats& command, const std::vector<NamedCoat>& coats) {
  for (std::size_t k = 0; k < command.coats.size(); ++k) {
    const CoatEntry& entry = command.coats[k];
    if (coat_of(entry, coats)) {
      if (entry.begins) return refused(k, "/begins", "the coat is there already", "of a new coat alone");
    } else if (entry.begins && !find_coat(coats, entry.begins->from)) {
      return refused(k, "/begins/from", "the scene has no coat of this name", listed(coats));
    }
  }
  std::vector<CoatId> ids = ids_of(command, coats);
  std::ranges::sort(ids);
  if (ids.back() >= limits::coats)
    return failure(Code::invalid, "no number is free for a new coat", "/coats",
                   "at most " + std::to_string(limits::coats) + ", with those that are removed");
  if (std::ranges::adjacent_find(ids) == ids.end()) return {};
  return failure(Code::invalid, "two entries are about one coat", "/coats", "each coat once, by its id or its name");
}

Status check(const SetCoat& command, const std::vector<NamedCoat>& coats) {
  if (find_coat(coats, command.name)) return {};
  return failure(Code::invalid, "the scene has no coat of this name", "/name", listed(coats));
}

std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoats& command) {
  const std::vector<CoatId> ids = ids_of(command, coats);
  std::vector<NamedCoat> after;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const CoatEntry& entry = command.coats[k];
    const NamedCoat* before = coat_of(entry, coats);
    after.push_back({entry.name, ids[k], entry.muted,
                     entry.coat.value_or(before ? before->coat : beginning_of(entry, coats).coat)});
  }
  return after;
}

std::vector<NamedCoat> with_change(const std::vector<NamedCoat>& coats, const SetCoat& command) {
  std::vector<NamedCoat> after = coats;
  const NamedCoat* coat = find_coat(coats, command.name);
  if (coat) after[static_cast<std::size_t>(coat - coats.data())].coat = command.coat;
  return after;
}

std::vector<EditLayer> with_coats(std::vector<EditLayer> layers, const std::vector<NamedCoat>& before,
                                  const std::vector<NamedCoat>& after) {
  for (EditLayer& layer : layers) {
    const NamedCoat* old = layer.coat.empty() ? nullptr : find_coat(before, layer.coat);
    const auto now = std::ranges::find_if(after, [&](const NamedCoat& coat) { return old && coat.id == old->id; });
    layer.coat = now == after.end() ? std::string() : now->name;
  }
  return layers;
}

namespace {

/// Adds the change that gives a coat value(part, vertex) in all of its own fields on all sheets.
template <class Value>
void put_all(const FieldSet& fields, CoatId coat, FieldDelta& delta, const Value& value) {
  for (std::size_t s = 0; s < sheet_count; ++s) {
    for (std::size_t f = 0; f < field_count; ++f) {
      if (is_shared(field_at(f))) continue;
      FieldDelta::Part part{field_at(f), {}, {}, static_cast<Sheet>(s), coat};
      for (std::uint32_t v = 0; v < fields.size(); ++v) put_change(part, v, fields.value_of(part, v), value(part, v));
      if (!part.vertices.empty()) delta.parts.push_back(std::move(part));
    }
  }
}

glm::vec4 density_in(CoatRegion region, const FieldSet& fields, glm::vec4 density, std::uint32_t vertex) {
  if (region == CoatRegion::none) return glm::vec4(0);
  if (region == CoatRegion::mask) density.x *= fields.number(Field::mask, vertex);
  return density;
}

/// Adds the first values of a new coat: the visible values of the one that it begins from. Its edit layers are empty.
void begin_coat(const CoatBeginning& how, CoatId from, CoatId coat, const FieldSet& fields, FieldDelta& delta) {
  const FieldSet other = fields.of_coat(from), none(fields.size());
  put_all(fields, coat, delta, [&](const FieldDelta::Part& part, std::uint32_t v) {
    if (part.sheet != visible_sheet) return none.on_sheet(part.sheet, part.field, v);
    const glm::vec4 value = other.value(part.field, v);
    if (part.field == Field::density) return density_in(how.region, fields, value, v);
    if (part.field != Field::length) return value;
    return glm::vec4(stored_value(Field::length, how.length * double{value.x}), 0, 0, 0);
  });
}

void end_coat(CoatId coat, const FieldSet& fields, FieldDelta& delta) {
  const FieldSet none(fields.size());
  put_all(fields, coat, delta,
          [&](const FieldDelta::Part& part, std::uint32_t v) { return none.on_sheet(part.sheet, part.field, v); });
}

}  // namespace

FieldDelta change_coats(const SetCoats& command, const std::vector<NamedCoat>& coats, const FieldSet& fields) {
  const std::vector<NamedCoat> after = with_change(coats, command);
  FieldDelta delta;
  for (const NamedCoat& coat : coats) {
    const bool stays = std::ranges::any_of(after, [&](const NamedCoat& other) { return other.id == coat.id; });
    if (!stays) end_coat(coat.id, fields, delta);
  }
  for (std::size_t k = 0; k < after.size(); ++k) {
    const CoatEntry& entry = command.coats[k];
    if (coat_of(entry, coats)) continue;
    begin_coat(entry.begins.value_or(CoatBeginning{}), beginning_of(entry, coats).id, after[k].id, fields, delta);
  }
  finish_parts(delta);
  return delta;
}

namespace {

const std::string& coat_of_layer(const std::string& edit_layer, const std::vector<EditLayer>& layers) {
  static const std::string none;
  const auto layer = std::ranges::find(layers, edit_layer, &EditLayer::name);
  return edit_layer.empty() || layer == layers.end() ? none : layer->coat;
}

}  // namespace

std::vector<CoatId> coats_to_groom(const std::vector<std::string>& names, const std::string& edit_layer,
                                   const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers) {
  const std::string& own = coat_of_layer(edit_layer, layers);
  std::vector<CoatId> ids;
  for (const NamedCoat& coat : coats) {
    const bool named = names.empty() || std::ranges::count(names, coat.name) > 0;
    if (named && !coat.muted && (own.empty() || own == coat.name)) ids.push_back(coat.id);
  }
  return ids;
}

Status check_groomed_coats(const std::vector<std::string>& names, const std::string& edit_layer,
                           const std::vector<NamedCoat>& coats, const std::vector<EditLayer>& layers) {
  const std::string& own = coat_of_layer(edit_layer, layers);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const NamedCoat* coat = names[k].empty() ? nullptr : find_coat(coats, names[k]);
    if (!coat) return refused(k, "", "the scene has no coat of this name", listed(coats));
    if (coat->muted) return refused(k, "", "the coat is muted, so that grooming it would not be seen", "not muted");
    if (!own.empty() && own != coat->name)
      return refused(k, "", "the edit layer keeps the changes of another coat", own);
  }
  const NamedCoat* layered = own.empty() ? nullptr : find_coat(coats, own);
  if (!layered || !layered->muted) return {};
  return failure(Code::invalid, "the coat of the edit layer is muted", "/edit_layer", "not muted");
}

}  // namespace pelage
