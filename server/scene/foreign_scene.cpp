#include "server/scene/foreign_scene.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "protocol/json/author.h"
#include "protocol/json/decode.h"
#include "protocol/json/names.h"
#include "server/groom/evaluate.h"
#include "server/import/import.h"
#include "server/import/map_picture.h"
#include "server/scene/map_pictures.h"

namespace pelage {

namespace {

Status refused(const std::string& why) { return failure(Code::invalid, why); }

bool is_known_model(const std::string& name) {
  const auto has = [&](const auto& names) {
    return std::any_of(names.begin(), names.end(), [&](const auto& known) { return known.text == name; });
  };
  return has(json_names::builtins) || has(json_names::model_formats);
}

Result<std::set<std::string>> good_pictures(const Journal& file, const std::string& scene) {
  const Result<std::vector<std::string>> names = file.pictures_of(scene);
  if (!names) return names.status();
  for (const std::string& name : *names) {
    const Result<std::string> bytes = file.picture(name);
    if (!bytes) return bytes.status();
    if (name_of_picture(*bytes) != name) return refused("a picture is not the one that its name says");
    if (!decode_map_picture(std::as_bytes(std::span(*bytes)))) return refused("a picture cannot be read");
  }
  return std::set<std::string>(names->begin(), names->end());
}

/// Returns whether a vertex's value is valid on its sheet: the visible value must be in the field's range, the value
/// under the edit layers in that range or NaN (absent), and the value that an edit layer adds finite.
bool is_good(const FieldSet& fields, const FieldDelta::Part& part, std::uint32_t vertex) {
  constexpr float max_addition = 1e9f;
  const FieldShape& shape = shape_of(part.field);
  const glm::vec4 value = fields.value_of(part, vertex);
  const bool adds = part.sheet >= first_edit_layer;
  const float low = adds ? -max_addition : shape.min, high = adds ? max_addition : shape.max;
  for (int c = 0; c < shape.channels; ++c) {
    const bool nothing = part.sheet == base_sheet && std::isnan(value[c]);
    if (!nothing && !(value[c] >= low && value[c] <= high)) return false;
  }
  if (part.field != Field::direction || adds || std::isnan(value.x)) return true;
  return glm::dot(glm::dvec2(value), glm::dvec2(value)) <= 1;
}

bool in_range(const FieldSet& fields, const FieldDelta& delta) {
  return std::all_of(delta.parts.begin(), delta.parts.end(), [&](const FieldDelta::Part& part) {
    return std::all_of(part.vertices.begin(), part.vertices.end(),
                       [&](std::uint32_t vertex) { return is_good(fields, part, vertex); });
  });
}

/// Replays a log as Scene::restore does, and checks the commands, settings and values, which a restore trusts.
class LogCheck {
 public:
  LogCheck(const SceneModel& model, const StoredScene& stored, std::set<std::string> pictures)
      : surface_(model.surface),
        pictures_(std::move(pictures)),
        fields_(model.surface.mesh().positions.size()),
        history_(stored.first_revision, stored.first_settings ? *stored.first_settings : SceneSettings{},
                 {.bytes = limits::undo_bytes, .read = {}}) {}

  Status begin(const StoredScene& stored) {
    if (stored.first_settings) {
      if (Status bad = check(*stored.first_settings, stored.first_revision); !bad.ok()) return bad;
    }
    return take(stored.first_groom);
  }

  Status next(const Entry& entry) {
    if (entry.revision > max_revision || !history_.accepts(entry) || !check_author_of(entry).ok())
      return refused("it does not follow those before it");
    if (Status bad = check_commands(entry); !bad.ok()) return bad;
    if (entry.settings) {
      if (Status bad = check(*entry.settings, entry.revision); !bad.ok()) return bad;
    }
    if (Status bad = take(entry.delta); !bad.ok()) return bad;
    if (fields_.hash() != entry.fields_hash) return refused("it does not lead to the fields that it says");
    history_.record(entry);
    return {};
  }

 private:
  static constexpr Revision max_revision = Revision{1} << 53;  // exact in JSON

  static Status check_author_of(const Entry& entry) {
    return entry.author.empty() ? Status{} : check_author(entry.author);
  }

  Status take(const FieldDelta& delta) {
    if (!fields_.accepts(delta)) return refused("it changes vertices that the model does not have");
    fields_.apply(delta);
    return in_range(fields_, delta) ? Status{} : refused("a value of its fields is out of range");
  }

  Status check_picture(const std::string& name) const {
    return name.empty() || pictures_.contains(name) ? Status{} : refused("it names a picture that the file lacks");
  }

  Status check_all(const std::vector<Command>& commands) const {
    for (const Command& command : commands) {
      if (const Result<Command> good = resolve(command, surface_); !good) return good.status();
    }
    for (const std::string& picture : pictures_read_by(commands)) {
      if (Status bad = check_picture(picture); !bad.ok()) return bad;
    }
    return {};
  }

  static Status check_coats(const std::vector<NamedCoat>& coats) {
    std::set<std::string> names;
    std::set<CoatId> ids;
    for (const NamedCoat& coat : coats) names.insert(coat.name), ids.insert(coat.id);
    if (coats.empty() || names.size() != coats.size() || ids.size() != coats.size() || *ids.rbegin() >= limits::coats)
      return refused("its coats have not one name and one number each");
    return std::ranges::all_of(coats, &NamedCoat::muted) ? refused("all of its coats are muted") : Status{};
  }

  Status check(const SceneSettings& settings, Revision now) const {
    if (settings.layers.size() > limits::edit_layers) return refused("it has too many edit layers");
    std::set<std::string> layers;
    for (const EditLayer& layer : settings.layers) layers.insert(layer.name);
    if (layers.size() != settings.layers.size()) return refused("two of its edit layers have one name");
    if (Status bad = check_coats(settings.coats); !bad.ok()) return bad;
    for (const NamedRevision& named : settings.checkpoints) {
      if (named.revision < history_.first_revision() || named.revision > now)
        return refused("a checkpoint is at a revision that is not there");
    }
    if (Status bad = check_picture(settings.skin_texture); !bad.ok()) return bad;
    return check_all(commands_of(settings));
  }

  /// Checks an entry's commands. Undo, redo and revert must have none. A part of a stroke must directly follow the part
  /// before it.
  Status check_commands(const Entry& entry) {
    const bool moves =
        entry.kind == EntryKind::undo || entry.kind == EntryKind::redo || entry.kind == EntryKind::revert;
    std::string stroke;
    if (moves && !entry.commands.empty()) return refused("an undo, redo or revert has commands");
    if (!moves) {
      const Result<std::vector<Command>> commands = decode_commands(entry.commands);
      if (!commands) return commands.status();
      if (Status bad = check_all(*commands); !bad.ok()) return bad;
      if (commands->size() == 1 && stroke_of(commands->front()) != nullptr) stroke = op_of(commands->front());
    }
    if (entry.kind == EntryKind::join && (stroke.empty() || stroke != last_stroke_))
      return refused("it is part of a stroke that did not begin");
    last_stroke_ = entry.kind == EntryKind::replay ? std::string() : stroke;
    return {};
  }

  const Surface& surface_;
  std::set<std::string> pictures_;
  FieldSet fields_;
  History history_;
  std::string last_stroke_;  // op of the last entry if it is a single command with a stroke, else ""
};

}  // namespace

Status check_foreign(const Journal& file, const StoredScene& stored, const SceneModel& model) {
  const double crease = stored.model.prepare.crease_degrees;
  if (!is_known_model(stored.model.name) || !(crease >= 0 && crease <= 180)) return refused("its model is of no kind");
  Result<std::set<std::string>> pictures = good_pictures(file, stored.id);
  if (!pictures) return pictures.status();
  LogCheck log(model, stored, std::move(*pictures));
  if (Status bad = log.begin(stored); !bad.ok()) return refused("its first groom: " + bad.message);
  return file.for_each_entry(stored.id, 0, [&](const Entry& entry) {
    const Status bad = log.next(entry);
    return bad.ok() ? bad : refused("entry " + std::to_string(entry.revision) + ": " + bad.message);
  });
}

}  // namespace pelage
