// What the server answers, before it is JSON.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/commands/coat.h"
#include "protocol/commands/field.h"
#include "protocol/commands/scene.h"

namespace pelage {

using Revision = std::uint64_t;

/// 128-bit sum over (field, vertex, bits) hashes; on the wire 32 hex digits.
struct FieldsHash {
  std::uint64_t low = 0, high = 0;
  bool operator==(const FieldsHash&) const = default;
};
std::string to_hex(FieldsHash hash);
/// The hash of 32 hex digits in lower case; nothing of any other text.
std::optional<FieldsHash> hash_of_hex(std::string_view text);

/// What a frame took from the GL. Without a GL all but `bytes` and `redrawn` are 0. `bytes` counts what was sent for
/// the frame to the renderer, changes of fields included.
struct FrameCounters {
  std::size_t passes = 0;       // programs put to use, one after another
  std::size_t draws = 0;        // draw calls
  std::size_t textures = 0;     // textures bound
  std::size_t bytes = 0;        // sent from the CPU
  std::uint64_t fragments = 0;  // runs of fragment shaders, but for the pass that writes the picture's pixels
  std::size_t objects = 0;      // buffers, textures, targets and programs that were made
  std::size_t allocated = 0;    // bytes of storage that was asked for, without mip levels
  double redrawn = 1;           // share of the picture, [0, 1]; after a stroke only what it changed is drawn
  bool operator==(const FrameCounters&) const = default;
};

/// How one field changed: vertices that changed a bit, the mean change over them and the largest, in the field's unit.
struct FieldChange {
  std::string field;
  std::size_t changed = 0;
  double mean_change = 0;
  double max_change = 0;
  bool operator==(const FieldChange&) const = default;
};

struct CommandResult {
  std::string op;
  std::size_t touched = 0;  // vertices that changed a bit of any field
  double mean_change = 0;   // of the first field that changed
  double max_change = 0;
  std::size_t clamped = 0;  // vertices at which a value was held at its limit
  double milliseconds = 0;
  std::vector<FieldChange> fields = {};
  std::vector<std::string> warnings = {};  // what was done but is hardly what was meant
  bool operator==(const CommandResult&) const = default;
};

struct CommandAnswer {
  Revision revision = 0;
  FieldsHash fields_hash;
  std::vector<CommandResult> results;
  bool operator==(const CommandAnswer&) const = default;
};

/// What preparation mended, or left out of a model.
struct Repair {
  std::string code;  // "welded_vertices", "degenerate_faces", ...
  std::size_t count = 0;
  std::vector<std::string> names = {};  // of what was left out, the first few; empty where it has none
  bool operator==(const Repair&) const = default;
};

/// A box along the axes, in the model's own coordinates.
struct Bounds {
  glm::dvec3 min{0}, max{0};
  bool operator==(const Bounds&) const = default;
};

/// A connected part that the report of a loaded model names.
struct NumberedPart {
  int part = 1;  // its number, from 1
  std::size_t triangles = 0;
  glm::dvec3 centre{0};  // of its box, model's coordinates
  bool operator==(const NumberedPart&) const = default;
};

/// What a file calls some of its faces.
struct MaterialReport {
  std::string name;
  std::size_t triangles = 0;
  bool bare = false;  // named after what has no fur, and begun without
  bool operator==(const MaterialReport&) const = default;
};

/// What preparation made of a model.
struct ModelReport {
  std::size_t source_vertices = 0;
  std::size_t source_faces = 0;
  std::size_t vertices = 0;  // welded on equal positions
  std::size_t triangles = 0;
  std::size_t parts = 0;  // connected
  double size = 0;        // diagonal of the box, in the model's unit
  Bounds bounds;
  Axis up = Axis::plus_y, front = Axis::plus_z;  // of the file, as they were taken
  std::string pose = {};                         // "NAME@SECONDS" that it stands in; "" as the file has it
  std::vector<std::string> animations = {};      // that the file has
  std::vector<MaterialReport> materials = {};    // that have names, in the order of their first triangles
  std::vector<Repair> repairs;
  // Parts that may be wound the wrong way. They are open, so that no side is known to be outside, and the sign of the
  // little volume that they enclose contradicts their winding.
  std::vector<NumberedPart> doubtful_parts = {};
  std::vector<NumberedPart> sheets = {};  // of several parts, those of one layer of triangles, bare on their backs
  bool operator==(const ModelReport&) const = default;
};

/// How the groom of a scene went over to a new version of its model.
struct CarriedReport {
  Alignment align = Alignment::none;
  std::size_t vertices = 0;
  std::size_t far = 0;      // of them, farther than .05 sizes from the model before
  std::string before = {};  // id of the scene that is as this one was, with its log
  bool operator==(const CarriedReport&) const = default;
};

struct SceneSummary {
  std::string id;
  std::string name;
  Revision revision = 0;
  std::string model;          // "creature" or "obj", ...
  std::string model_id = {};  // follows from the mesh: equal while it is, 32 hex digits
  std::string fur_patches = "overlapping";
  std::optional<double> metres_per_unit = {};  // of the model's file, where its format says it
  ModelReport report;
  FieldsHash fields_hash;
  std::size_t undo_steps = 0;  // that can be undone
  std::size_t redo_steps = 0;
  std::vector<CoatEntry> coats = {};          // without their strands
  std::vector<EditLayer> edit_layers = {};    // from the lowest
  std::string damage = {};                    // of its journal; "" for none
  std::optional<CarriedReport> carried = {};  // in the answer to a new version of the model
  bool operator==(const SceneSummary&) const = default;
};

struct SceneList {
  std::vector<SceneSummary> scenes;
  bool operator==(const SceneList&) const = default;
};

/// The values of the painted fields, from first_painted on; a colour is that of the paint that covers.
using PaintedValues = std::array<glm::dvec4, field_count - first_painted>;

enum class StrandKind { coat, curve };

/// The strand that covers most of a pixel.
struct PickedStrand {
  int id = 1;  // as Aov::strand has it
  StrandKind kind = StrandKind::coat;
  std::string coat = {};  // its name; "" for a curve
  double along = 0;       // where on it, [0, 1]: 0 at its root
  glm::dvec3 root{0};     // where it stands, model coordinates
  bool operator==(const PickedStrand&) const = default;
};

/// What lies under a pixel.
struct PickAnswer {
  bool hit = false;
  std::optional<PickedStrand> strand = {};  // that is seen there, beside the model too
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
  glm::dvec3 position{0};  // model coordinates
  glm::dvec3 normal{0};
  glm::dvec3 direction{0};  // where the fur leans, a unit vector in model coordinates, 0 when upright
  double inclination = 0;   // [0, 1]
  double length = 0;        // sizes
  double stretch = 0;
  PaintedValues painted{};
  bool operator==(const PickAnswer&) const = default;
};

/// What two revisions of a scene differ in.
struct Comparison {
  Revision from = 0, to = 0;
  std::size_t touched = 0;  // vertices at which any field differs
  std::vector<FieldChange> fields;
  bool operator==(const Comparison&) const = default;
};

/// What made a revision. command: a new step ("do" on the wire). join: a part that joins the last step. undo, redo and
/// revert: a move through the steps. replay: commands that are listed by themselves but belong to the undo step of the
/// entry before. Journals store the numbers.
enum class EntryKind { command, join, undo, redo, revert, replay };

/// One line of the undo log.
struct LogEntry {
  Revision revision = 0;
  std::string kind;      // the word of an EntryKind
  Revision step = 0;     // number of the step that it made, joined or replayed: that step's first revision; else 0
  std::string commands;  // JSON text of the resolved commands, "" for undo and redo
  std::size_t touched = 0;
  bool in_effect = false;   // whether its commands are among those that lead to the present
  std::string author = {};  // who made the change, as the client named them; "" for nobody
  bool operator==(const LogEntry&) const = default;
};

struct Log {
  std::vector<LogEntry> entries;
  bool operator==(const Log&) const = default;
};

/// What a scene is now, for those who follow it.
struct SceneEvent {
  Revision revision = 0;
  Revision first_revision = 0;  // at which the model came
  std::size_t undo_steps = 0;   // that can be undone
  std::size_t redo_steps = 0;
  std::string model_id;  // as in SceneSummary
  bool operator==(const SceneEvent&) const = default;
};

/// One change of a scene, for those who follow it: a line of the log without its commands.
struct ChangeEvent {
  Revision revision = 0;
  std::string kind;              // the word of an EntryKind
  std::uint64_t argument = 0;    // steps of undo and redo, the revision that a revert goes back to
  std::string author;            // as in LogEntry
  std::vector<std::string> ops;  // of its commands, each once, in their order
  std::size_t touched = 0;
  std::size_t undo_steps = 0;  // that could be undone after it
  std::size_t redo_steps = 0;
  bool operator==(const ChangeEvent&) const = default;
};

/// A refusal as RFC 9457 has it.
struct Problem {
  std::string type;   // "urn:pelage:problem:" and a name, or "about:blank"
  std::string title;  // of the type
  int status = 500;   // of HTTP
  std::string detail;
  std::optional<std::string> pointer = {};  // JSON pointer of the bad field, "" for the whole body
  std::string limit = {};                   // that was broken; "" for none
  std::string nearest = {};                 // known name to an unknown one; "" for none
  bool operator==(const Problem&) const = default;
};

}  // namespace pelage
