// Structs of the server's answers, before they are encoded as JSON.
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

/// 128-bit sum of the hashes of all (field, vertex, bits); 32 hex digits on the wire.
struct FieldsHash {
  std::uint64_t low = 0, high = 0;
  bool operator==(const FieldsHash&) const = default;
};
std::string to_hex(FieldsHash hash);
/// Parses 32 hex digits in lower case; returns nullopt for any other text.
std::optional<FieldsHash> hash_of_hex(std::string_view text);

/// The GL work of a frame. Without a GL, all members except `bytes` and `redrawn` are 0. `bytes` counts the data sent
/// to the renderer for the frame, changes of fields included.
struct FrameCounters {
  std::size_t passes = 0;       // times that a shader program was put to use
  std::size_t draws = 0;        // draw calls
  std::size_t textures = 0;     // textures bound
  std::size_t bytes = 0;        // sent from the CPU
  std::uint64_t fragments = 0;  // fragment shader invocations, without the pass that writes the final pixels
  std::size_t objects = 0;      // buffers, textures, targets and programs created
  std::size_t allocated = 0;    // bytes of storage requested, without mip levels
  double redrawn = 1;           // share of the picture drawn, [0, 1]; below 1 if only the dirty region of a stroke was
  bool operator==(const FrameCounters&) const = default;
};

/// How one field changed: the number of vertices whose value differs in any bit, and the mean and largest change over
/// them, in the field's unit.
struct FieldChange {
  std::string field;
  std::size_t changed = 0;
  double mean_change = 0;
  double max_change = 0;
  bool operator==(const FieldChange&) const = default;
};

struct CommandResult {
  std::string op;
  std::size_t touched = 0;  // vertices at which any field changed
  double mean_change = 0;   // of the first field that changed, in its unit
  double max_change = 0;
  std::size_t clamped = 0;  // vertices at which a value was clamped to its range
  double milliseconds = 0;
  std::vector<FieldChange> fields = {};
  std::vector<std::string> warnings = {};  // effects that were probably not intended
  bool operator==(const CommandResult&) const = default;
};

struct CommandAnswer {
  Revision revision = 0;
  FieldsHash fields_hash;
  std::vector<CommandResult> results;
  bool operator==(const CommandAnswer&) const = default;
};

/// Something that preparation repaired in a model, or left out of it.
struct Repair {
  std::string code;  // "welded_vertices", "degenerate_faces", ...
  std::size_t count = 0;
  std::vector<std::string> names = {};  // the first few things left out; empty if they have no names
  bool operator==(const Repair&) const = default;
};

/// An axis-aligned box in model coordinates.
struct Bounds {
  glm::dvec3 min{0}, max{0};
  bool operator==(const Bounds&) const = default;
};

/// A connected part that the report of a loaded model refers to.
struct NumberedPart {
  int part = 1;  // its number, from 1
  std::size_t triangles = 0;
  glm::dvec3 centre{0};  // centre of its box, model coordinates
  bool operator==(const NumberedPart&) const = default;
};

/// A material of the model's file.
struct MaterialReport {
  std::string name;
  std::size_t triangles = 0;
  bool bare = false;  // true if its name means something without fur (an eye, a claw), so it began bare
  bool operator==(const MaterialReport&) const = default;
};

/// The model as preparation made it, and what it found in the file.
struct ModelReport {
  std::size_t source_vertices = 0;
  std::size_t source_faces = 0;
  std::size_t vertices = 0;  // number after welding equal positions
  std::size_t triangles = 0;
  std::size_t parts = 0;  // connected parts
  double size = 0;        // diagonal of the box, in the model's unit
  Bounds bounds;
  Axis up = Axis::plus_y, front = Axis::plus_z;  // axes of the file that were taken as up and front
  std::string pose = {};                         // pose as "NAME@SECONDS"; "" for the pose of the file
  std::vector<std::string> animations = {};      // names of the animations in the file
  std::vector<MaterialReport> materials = {};    // named materials, in the order of their first triangles
  std::vector<Repair> repairs;
  // Parts that may be wound the wrong way. They are open, so their outside is uncertain, and the sign of the small
  // volume that they enclose contradicts their winding.
  std::vector<NumberedPart> doubtful_parts = {};
  std::vector<NumberedPart> sheets = {};  // open parts that enclose next to nothing, if there are several parts
  bool operator==(const ModelReport&) const = default;
};

/// How a scene's groom was transferred to a new version of its model.
struct TransferReport {
  Alignment align = Alignment::none;
  std::size_t vertices = 0;
  std::size_t far = 0;      // vertices farther than .05 sizes from the old model
  std::string before = {};  // id of a scene that holds the previous state and log
  bool operator==(const TransferReport&) const = default;
};

struct SceneSummary {
  std::string id;
  std::string name;
  Revision revision = 0;
  std::string model;          // name of a built-in model, or format of the file: "creature", "obj", ...
  std::string model_id = {};  // 32 hex digits; the same as long as the mesh is
  std::string fur_patches = "overlapping";
  std::optional<double> metres_per_unit = {};  // metres per unit of the model's file; absent if the format does not say
  ModelReport report;
  FieldsHash fields_hash;
  std::size_t undo_steps = 0;  // steps that can be undone
  std::size_t redo_steps = 0;
  std::vector<CoatEntry> coats = {};            // without the settings of their strands (CoatEntry::coat)
  std::vector<EditLayer> edit_layers = {};      // bottom to top
  std::string damage = {};                      // damage of its journal; "" for none
  std::optional<TransferReport> transfer = {};  // only in the answer to the upload of a new version of the model
  bool operator==(const SceneSummary&) const = default;
};

struct SceneList {
  std::vector<SceneSummary> scenes;
  bool operator==(const SceneList&) const = default;
};

/// Values of the painted fields, from first_painted on. A scalar is in x; a colour field is the linear colour of the
/// paint and its coverage.
using PaintedValues = std::array<glm::dvec4, field_count - first_painted>;

enum class StrandKind { coat, curve };

/// The strand that covers most of a pixel.
struct PickedStrand {
  int id = 1;  // its number in Aov::strand
  StrandKind kind = StrandKind::coat;
  std::string coat = {};  // name of its coat; "" for a curve
  double along = 0;       // position along the strand, [0, 1]: 0 at its root
  glm::dvec3 root{0};     // position of its root, model coordinates
  bool operator==(const PickedStrand&) const = default;
};

/// What a pick found.
struct PickAnswer {
  bool hit = false;
  std::optional<PickedStrand> strand = {};  // the strand that is visible at the pixel, also where no skin is behind it
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
  glm::dvec3 position{0};  // model coordinates
  glm::dvec3 normal{0};
  glm::dvec3 direction{0};  // direction in which the fur leans, unit vector in model coordinates; 0 if upright
  double inclination = 0;   // [0, 1]
  double length = 0;        // sizes
  double stretch = 0;
  PaintedValues painted{};
  bool operator==(const PickAnswer&) const = default;
};

/// The differences between two revisions of a scene.
struct Comparison {
  Revision from = 0, to = 0;
  std::size_t touched = 0;  // vertices at which any field differs
  std::vector<FieldChange> fields;
  bool operator==(const Comparison&) const = default;
};

/// What made a revision. command: a new step ("do" on the wire). join: a part that joins the last step. undo, redo and
/// revert: a move through the steps. replay: commands that are listed by themselves but belong to the undo step of the
/// entry before. Journals store the enumerators' numbers.
enum class EntryKind { command, join, undo, redo, revert, replay };

/// One line of the undo log.
struct LogEntry {
  Revision revision = 0;
  std::string kind;      // the word of an EntryKind
  Revision step = 0;     // number of the step that it made, joined or replayed: that step's first revision; else 0
  std::string commands;  // JSON text of the resolved commands, "" for undo, redo and revert
  std::size_t touched = 0;
  bool in_effect = false;   // true if its commands are among those that made the present state
  std::string author = {};  // name that the client gave for who made the change; "" for none
  bool operator==(const LogEntry&) const = default;
};

struct Log {
  std::vector<LogEntry> entries;
  bool operator==(const Log&) const = default;
};

/// The state of a scene, for clients that follow its events.
struct SceneEvent {
  Revision revision = 0;
  Revision first_revision = 0;  // revision at which the present model was loaded
  std::size_t undo_steps = 0;   // steps that can be undone
  std::size_t redo_steps = 0;
  std::string model_id;  // as in SceneSummary
  bool operator==(const SceneEvent&) const = default;
};

/// A change of a scene, for clients that follow its events: an entry of the log without its commands.
struct ChangeEvent {
  Revision revision = 0;
  std::string kind;              // the word of an EntryKind
  std::uint64_t argument = 0;    // number of steps of undo and redo, or the revision that a revert goes back to; else 0
  std::string author;            // as in LogEntry
  std::vector<std::string> ops;  // op of each of its commands, each once, in order
  std::size_t touched = 0;
  std::size_t undo_steps = 0;  // steps that can be undone after it
  std::size_t redo_steps = 0;
  bool operator==(const ChangeEvent&) const = default;
};

/// A refusal as a problem document (RFC 9457).
struct Problem {
  std::string type;   // "urn:pelage:problem:" and a name, or "about:blank"
  std::string title;  // title of the type
  int status = 500;   // HTTP status
  std::string detail;
  std::optional<std::string> pointer = {};  // JSON pointer of the bad field, "" for the whole body
  std::string limit = {};                   // limit that was violated; "" for none
  std::string nearest = {};                 // known name nearest to an unknown one; "" for none
  bool operator==(const Problem&) const = default;
};

}  // namespace pelage
