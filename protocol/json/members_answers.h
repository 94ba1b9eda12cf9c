// JSON members of the server's answers.
#pragma once

#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/map.h"
#include "protocol/commands/quality.h"
#include "protocol/commands/recipe.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, FrameCounters>& c) {
  v.answer("FrameCounters", "GL work of a frame; without a GL all but `bytes` and `redrawn` are 0.");
  v.counter("passes", c.passes, "Times that a shader program was bound.");
  v.counter("draws", c.draws, "Draw calls.");
  v.counter("textures", c.textures, "Textures bound.");
  v.counter("bytes", c.bytes, "Bytes sent to the renderer for the frame, changes of fields included.");
  v.counter("fragments", c.fragments,
            "Fragment shader invocations, without the pass that writes the final pixels; drawn samples if the GL does "
            "not count invocations.");
  v.counter("objects", c.objects, "Buffers, textures, targets and programs created.");
  v.counter("allocated", c.allocated, "Bytes of storage requested, without mip levels.");
  v.number("redrawn", c.redrawn, share,
           "Share of the picture that was drawn. Below 1 after a stroke if the previous frame showed the same view: "
           "the rest is reused, and the picture has the same bits as if drawn whole.");
}

template <class V>
void members(V& v, Visited<V, FrameEstimate>& c) {
  v.answer("FrameEstimate", "Estimated error and drawing time of a frame.");
  v.number("error", c.error, share.in("mean FLIP"),
           "Mean FLIP over the fur, against `reference`; half of such frames have at most this.");
  v.number("error_safety", c.error_safety, one_or_more.in("factor"),
           "95% of frames have at most `error` times this factor.");
  std::size_t reference = 0;
  v.name("reference", reference, json_names::error_references,
         "What errors are measured against: the same strands, traced.");
  v.number("cost_ms", c.cost_ms, not_negative.in("milliseconds"),
           "Drawing time, estimated before drawing; what `budget_ms` limits.");
  v.number("cost_safety", c.cost_safety, one_or_more.in("factor"),
           "95% of frames take at most `cost_ms` times this factor.");
  v.number("correction", c.correction, positive.in("factor"),
           "Measured over predicted cost of this scene's frames so far; `cost_ms` includes it. It changes in steps, "
           "and only when it is off by more than 8%.");
  v.name("end", c.end, json_names::plan_ends,
         "Why these knobs were chosen. asked: the request named them. budget: better ones exceed the budget. error: "
         "the cheapest within the error. best: the best known ones. cheapest: even the cheapest exceed the budget.");
  v.text("calibration", c.calibration,
         "Name of the cost calibration; `defaults` until `pelage calibrate` has measured the machine.");
}

template <class V>
void members(V& v, Visited<V, FrameCost>& c) {
  v.answer("FrameCost", "Expected drawing time of a frame, without waiting and encoding.");
  v.number("seconds", c.seconds, not_negative.in("seconds"), "Time that half of such frames take at most.");
  v.number("safety", c.safety, one_or_more.in("factor"),
           "95% of such frames take at most `seconds` times this factor.");
}

template <class V>
void members(V& v, Visited<V, ExportAnswer>& c) {
  v.answer("ExportAbout", "Contents of an exported file.");
  v.counter("revision", c.revision, "Revision that is exported.");
  v.name("format", c.format, json_names::export_formats, "Format of the file.");
  v.counter("strands", c.strands, "Number of strands, whiskers, lashes and brows; 0 for a GLB.");
  v.counter("points", c.points, "Number of points of all strands.");
  v.counter("triangles", c.triangles,
            "Number of triangles of a GLB: the skin, and all shells or the finest level of cards.");
  v.counter("cards", c.cards, "Number of cards of the finest level.");
  v.counter("bytes", c.bytes, "Size of the file.");
}

template <class V>
void members(V& v, Visited<V, FrameProgress>& c) {
  v.answer("FrameProgress", "A frame that is being drawn or waits.");
  v.text("view", c.view, "Name of the viewer, from its request.");
  v.integer("width", c.width, pixels, "Width of the picture.");
  v.integer("height", c.height, pixels, "Height of the picture.");
  v.number("share", c.share, share,
           "Share of the expected drawing time that has passed, at most 0.99; 0 while it waits.");
  v.number("seconds", c.seconds, not_negative.in("seconds"), "Time since the request.");
  v.number("expected_seconds", c.expected_seconds, not_negative.in("seconds"), "Expected drawing time.");
}

template <class V>
void members(V& v, Visited<V, FrameProgressList>& c) {
  v.answer("FrameProgressList", "Frames that are being drawn or wait.");
  v.objects("frames", c.frames, any_count, "Frames, in the order of their requests.");
}

template <class V>
void members(V& v, Visited<V, TraceReport>& c) {
  v.answer("TraceReport", "Progress of a traced picture.");
  v.integer("passes", c.passes, {0, limits::trace_passes}, "Passes in this picture; 0 if nothing is traced.");
  v.number("samples", c.samples, not_negative.in("samples"), "Mean number of samples per pixel.");
  v.number("noise", c.noise, share, "Estimated mean absolute error of a displayed channel.");
  v.counter("strands", c.strands, "Number of strands.");
  v.name("end", c.end, json_names::trace_ends, "Why tracing ended; none while it goes on.");
  v.number("grow_ms", c.grow_ms, not_negative.in("milliseconds"), "Time for growing and indexing strands.");
  v.number("trace_ms", c.trace_ms, not_negative.in("milliseconds"), "Time for tracing.");
}

template <class V>
void members(V& v, Visited<V, MapAnswer>& c) {
  v.answer("MapAbout", "How to read a map.");
  v.counter("revision", c.revision, "Revision that was drawn.");
  v.name("field", c.field, json_names::fields, "Field that was drawn.");
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, any_number.in("the field's unit"), "Value of 1 in the picture.");
  v.name("units", c.units, json_names::units);
  v.number("covered", c.covered, share, "Share of the pixels that lie in triangles.");
  v.counter("outside", c.outside,
            "Number of triangles partly outside [0, 1]; drawn where a repeating picture shows them.");
  v.integers("tiles", c.tiles, {first_udim, last_udim}, any_count,
             "UDIM tiles that the model has texture coordinates in.");
}

template <class V>
void members(V& v, Visited<V, PictureAnswer>& c) {
  v.answer("StoredPicture", "A picture that the server stores.");
  v.picture("picture", c.picture, "Name of the picture, for commands.");
  v.integer("width", c.width, {1, limits::picture_pixels}, "Width of the picture.");
  v.integer("height", c.height, {1, limits::picture_pixels}, "Height of the picture.");
  v.integer("bits", c.bits, {8, 32}, "Bits of a channel: 8, 16, or 32 for any float.");
  v.number(sparse("scale"), c.scale, any_number.in("the field's unit"),
           "Value of 1 in the picture, if the file states it.");
}

template <class V>
void members(V& v, Visited<V, EditLayer>& c) {
  v.answer("EditLayer", "An edit layer of the scene.");
  v.text("name", c.name, "Name of the edit layer.");
  v.number("weight", c.weight, edit_layer_weight, "Factor on its changes.");
  v.boolean("muted", c.muted, "Whether its changes are left out.");
  v.text(sparse("coat"), c.coat, "Only coat whose changes it stores; absent: those of all.");
}

template <class V>
void members(V& v, Visited<V, Bounds>& c) {
  v.answer("Bounds", "A box along the model's axes.");
  v.position("min", c.min, "Corner with the smallest coordinates.");
  v.position("max", c.max, "Corner with the largest coordinates.");
}

template <class V>
void members(V& v, Visited<V, Repair>& c) {
  v.answer("Repair", "A repair of the file, or something left out of it.");
  v.text("code", c.code, "Kind of repair, such as welded_vertices.");
  v.counter("count", c.count, "Number of cases.");
  v.texts(sparse("names"), c.names, "Names of the first few that were left out.");
}

template <class V>
void members(V& v, Visited<V, NumberedPart>& c) {
  v.answer("NumberedPart", "A connected part of the model that the load report names.");
  v.integer("part", c.part, {1, static_cast<double>(limits::model_triangles)},
            "Number of the part, from 1, as `flip` and `two_sided` take it.");
  v.counter("triangles", c.triangles, "Number of its triangles.");
  v.position("centre", c.centre, "Centre of its box.");
}

template <class V>
void members(V& v, Visited<V, MaterialReport>& c) {
  v.answer("Material", "A material of the model's file.");
  v.text("name", c.name, "The file's name for it.");
  v.counter("triangles", c.triangles, "Number of its triangles.");
  v.boolean("bare", c.bare,
            "Whether it began without fur because of its name: an eye, tooth, claw or hoof. Paint `bare` with 0 to "
            "grow some.");
}

template <class V>
void report_members(V& v, Visited<V, ModelReport>& c) {
  v.counter("source_vertices", c.source_vertices, "Number of vertices in the file.");
  v.counter("source_faces", c.source_faces, "Number of faces in the file.");
  v.counter("vertices", c.vertices, "Number of vertices, with equal positions welded.");
  v.counter("triangles", c.triangles, "Number of triangles.");
  v.counter("parts", c.parts, "Number of connected parts.");
  v.number("size", c.size, positive.in("model units"), "Diagonal of the box, in the model's unit.");
  v.object("bounds", c.bounds, "Box of the model.");
  v.name("up", c.up, json_names::axes, "The file's axis that was taken for up.");
  v.name("front", c.front, json_names::axes, "The file's axis that was taken for forward.");
  v.text("pose", c.pose, "Pose from an animation, as NAME@SECONDS; empty: the file's own pose.", any_length);
  v.texts("animations", c.animations, "Names of the file's animations.");
  v.objects("materials", c.materials, {0, limits::named_materials}, "Named materials of the file; `mask` chooses one.");
  v.objects("repairs", c.repairs, any_count, "Repairs, and what was left out.");
  v.objects("doubtful_parts", c.doubtful_parts, any_count,
            "Open parts that may be inside out, by the sign of their small volume. `flip` turns one.");
  v.objects("sheets", c.sheets, any_count,
            "Open parts that enclose almost nothing, if the model has several parts. They have no fur behind; "
            "`two_sided` gives one a back.");
}

template <class V>
void members(V& v, Visited<V, TransferReport>& c) {
  v.answer("Carried", "How the groom was transferred to a new version of the model.");
  v.name("align", c.align, json_names::alignments, "How both models were aligned.");
  v.counter("vertices", c.vertices, "Number of vertices; each took the fur nearest to it.");
  v.counter("far", c.far, "Number of them farther than .05 sizes from the previous model.");
  v.text("before", c.before, "Id of a scene with the previous state and its undo log.");
}

template <class V>
void members(V& v, Visited<V, SceneSummary>& c) {
  v.answer("Scene", "A scene: its model and the state of its log.");
  v.text("id", c.id, "Id of the scene, for addresses.");
  v.text("name", c.name, "Name of the scene.");
  v.counter("revision", c.revision, "Number of the newest entry of its log.");
  v.text("model", c.model, "Name of a built-in model, or the format of the file.");
  v.text("model_id", c.model_id,
         "Id of the mesh, as a key for caches of it. Uploads and subdivisions change it; a restart may.");
  v.word("fur_patches", c.fur_patches, json_names::fur_patches);
  v.number(sparse("metres_per_unit"), c.metres_per_unit, metres,
           "Metres per unit of the model's file, if its format states it (glTF).");
  report_members(v, c.report);
  v.hash("fields_hash", c.fields_hash);
  v.counter("undo_steps", c.undo_steps, "Steps that can be undone.");
  v.counter("redo_steps", c.redo_steps, "Steps that can be redone.");
  v.objects("coats", c.coats, {0, limits::coats}, "Coats, as set_coats takes them; none if the model is damaged.");
  v.objects("edit_layers", c.edit_layers, {0, limits::edit_layers}, "Edit layers, from the lowest.");
  v.text("damage", c.damage,
         "Damage of its journal; empty for none. A damaged scene has its state from before the damage and refuses "
         "changes (409); it can be viewed, exported and branched, unless its model is damaged.",
         any_length);
  v.object(sparse("carried"), c.transfer,
           "How the groom was transferred; only in the answer to a new version of the model.");
}

template <class V>
void members(V& v, Visited<V, SceneList>& c) {
  v.answer("SceneList", "The scenes of the server.");
  v.objects("scenes", c.scenes, {0, limits::scenes}, "All scenes.");
}

template <class V>
void members(V& v, Visited<V, FieldChange>& c) {
  v.answer("FieldChange", "How much a field changed.");
  v.word("field", c.field, json_names::fields, "Field that changed.");
  v.counter("changed", c.changed, "Number of vertices that changed in any bit.");
  v.number("mean_change", c.mean_change, not_negative.in("the field's unit"),
           "Mean change over these vertices, in the field's unit; for several channels, the length of the difference.");
  v.number("max_change", c.max_change, not_negative.in("the field's unit"), "Largest change, in the field's unit.");
}

template <class V>
void members(V& v, Visited<V, CommandResult>& c) {
  v.answer("CommandResult", "What one command did.");
  v.text("op", c.op, "The command's `op`.");
  v.counter("touched", c.touched, "Number of vertices that changed in any bit.");
  v.number("mean_change", c.mean_change, not_negative.in("the field's unit"),
           "Mean change of the first field that changed, over its changed vertices, in its unit.");
  v.number("max_change", c.max_change, not_negative.in("the field's unit"),
           "Largest change of that field, in its unit.");
  v.counter("clamped", c.clamped, "Number of vertices at which a value was clamped to its range.");
  v.number("milliseconds", c.milliseconds, not_negative.in("milliseconds"), "Time that the command took.");
  v.objects("fields", c.fields, any_count, "Fields that changed.");
  v.texts("warnings", c.warnings, "Effects that were probably not intended, such as of a brush finer than the mesh.");
}

template <class V>
void members(V& v, Visited<V, CommandAnswer>& c) {
  v.answer("CommandAnswer", "What commands did, and the revision that they made.");
  v.counter("revision", c.revision, "Revision of the scene afterwards.");
  v.hash("fields_hash", c.fields_hash);
  v.objects("results", c.results, any_count, "A result for each command, in order.");
}

template <class V>
void members(V& v, Visited<V, Comparison>& c) {
  v.answer("Comparison", "Differences between two revisions.");
  v.counter("from", c.from, "First revision.");
  v.counter("to", c.to, "Second revision.");
  v.counter("touched", c.touched, "Number of vertices at which any field differs.");
  v.objects("fields", c.fields, any_count, "Fields that differ.");
}

template <class V>
void members(V& v, Visited<V, LogEntry>& c) {
  v.answer("LogEntry", "One entry of the log.");
  v.counter("revision", c.revision, "Revision that it made.");
  v.word("kind", c.kind, json_names::entry_kinds,
         "Kind of entry. `join` and `replay` belong to the undo step of the entry before.");
  v.counter("step", c.step,
            "Number of the step that these commands belong to: the revision that first made it. Steps that an amend "
            "changes or replays keep theirs. 0 for undo, redo and revert.");
  v.counter("touched", c.touched, "Number of vertices that it changed.");
  v.boolean("in_effect", c.in_effect, "Whether its commands are part of the present state, and so can be amended.");
  v.text("author", c.author, "Name from the `Pelage-Author` of the request that made it; empty where none was named.");
  v.json(sparse("commands"), c.commands, "The resolved commands.");
}

template <class V>
void members(V& v, Visited<V, Log>& c) {
  v.answer("Log", "The log since the model was loaded.");
  v.objects("entries", c.entries, any_count, "Entries, the oldest first.");
}

template <class V>
void members(V& v, Visited<V, SceneEvent>& c) {
  v.answer("SceneEvent", "State of a scene, sent when its events begin and when its mesh changes.");
  v.counter("revision", c.revision, "Revision of the scene.");
  v.counter("first_revision", c.first_revision, "Revision at which the model was loaded; the log begins after it.");
  v.counter("undo_steps", c.undo_steps, "Steps that can be undone.");
  v.counter("redo_steps", c.redo_steps, "Steps that can be redone.");
  v.text("model_id", c.model_id, "Id of the mesh, as in `Scene`.");
}

template <class V>
void members(V& v, Visited<V, ChangeEvent>& c) {
  v.answer("ChangeEvent", "An entry of the log without its commands.");
  v.counter("revision", c.revision, "Revision that the change made.");
  v.word("kind", c.kind, json_names::entry_kinds,
         "Kind of change. `join` and `replay` belong to the undo step of the entry before.");
  v.counter("argument", c.argument, "Steps of `undo` and `redo`; the revision that `revert` goes back to; else 0.");
  v.text("author", c.author, "Author of the change, as in `LogEntry`.");
  v.texts("ops", c.ops, "The `op` of its commands, each once.");
  v.counter("touched", c.touched, "Number of vertices that it changed.");
  v.counter("undo_steps", c.undo_steps, "Steps that can be undone after it.");
  v.counter("redo_steps", c.redo_steps, "Steps that can be redone after it.");
}

/// Visits a member for each painted field. Its range ends a little above the field's, since sums of floats round.
template <class V>
void members(V& v, Visited<V, PaintedValues>& c) {
  static constexpr const char* words[] = {"Share of the coat's strands that grow.",
                                          "Factor on the coat's strand widths.",
                                          "Curl, added to the coat's own.",
                                          "Clumping, added to the coat's own.",
                                          "Wetness, added to the coat's own.",
                                          "1 where skin shows.",
                                          "How much tools may change: 1 all, 0 nothing.",
                                          "Colour at the roots, and how much it covers.",
                                          "Colour at the tips, and how much it covers.",
                                          "Factor on how stiff fur is in the wind."};
  static_assert(std::size(words) == std::tuple_size_v<PaintedValues>);
  v.answer("PaintedValues",
           "Painted fields at a point. A colour is linear red, green and blue, and how much of the coat's colour it "
           "covers.");
  for (std::size_t i = 0; i < c.size(); ++i) {
    const FieldShape& shape = field_shapes[first_painted + i];
    const Range range{0, static_cast<double>(shape.max) + 1e-6, "the field's unit"};
    if (shape.channels == 1) v.number(shape.name.data(), c[i].x, range, words[i]);
    if (shape.channels == 4) v.vector(shape.name.data(), c[i], range, words[i]);
  }
}

template <class V>
void members(V& v, Visited<V, PickedStrand>& c) {
  v.answer("PickedStrand", "The strand that covers most of a pixel.");
  v.integer("id", c.id, {1, 16777216}, "Its number, as in the AOV strand.");
  v.name("kind", c.kind, json_names::strand_kinds, "Whether it belongs to a coat or is a curve, such as a whisker.");
  v.text(sparse("coat"), c.coat, "Name of its coat; absent for a curve.");
  v.number("along", c.along, share, "Position of the pixel along it: 0 at its root, 1 at its tip.");
  v.position("root", c.root, "Position of its root.");
}

template <class V>
void members(V& v, Visited<V, TouchLimits>& c) {
  v.answer("TouchLimits", "Limits on the vertices that a command touches; the client that runs the step checks them.");
  v.counter("command", c.command, "Index of the command in its step, from 0.");
  v.counter(sparse("min_vertices"), c.min_vertices, "Smallest number of vertices; absent: no limit.");
  v.counter(sparse("max_vertices"), c.max_vertices, "Largest number of vertices; absent: no limit.");
}

template <class V>
void members(V& v, Visited<V, RecipeStep>& c) {
  v.answer("RecipeStep", "One undo step, with variables and positions filled in.");
  v.objects("commands", c.commands, {1, limits::commands_per_batch}, "Commands to run as one step.");
  v.text("file", c.file, "Name of the file that contains the step.", limits::file_name_bytes);
  v.text("pointer", c.pointer, "JSON pointer to the step, within the request.", any_length);
  v.objects("asserts", c.asserts, any_count, "Limits that the recipe asserts for the commands.");
}

template <class V>
void members(V& v, Visited<V, RecipeAnswer>& c) {
  v.answer("RecipeAnswer", "The steps of a recipe for this model, none of them run yet.");
  v.counter("revision", c.revision, "Revision of the scene that picks were made in.");
  v.objects("steps", c.steps, any_count, "Steps, in order.");
}

template <class V>
void members(V& v, Visited<V, PickAnswer>& c) {
  v.answer("Pick", "What a pick found.");
  v.boolean(tag("hit"), c.hit, "Whether the model was hit.");
  v.object(sparse("strand"), c.strand,
           "The strand that shows most at the pixel, also where no skin is behind it; absent if skin or nothing shows "
           "more.");
  if (!v.takes(c.hit)) return;
  v.seed("triangle", c.triangle, "Index of the triangle.");
  v.vector("barycentric", c.barycentric, share, "Weights of the triangle's corners.");
  v.position("position", c.position, "Position of the hit.");
  v.vector("normal", c.normal, any_number.in("unit vector"), "Normal of the skin, a unit vector.");
  v.vector("direction", c.direction, any_number.in("unit vector"),
           "Direction that the fur leans in, a unit vector; 0 if upright.");
  v.number("inclination", c.inclination, {0, 1 + 1e-6, "share"}, "How far the fur leans: 0 upright, 1 lying.");
  v.number("length", c.length, not_negative.in("sizes"), "Length of the fur.");
  v.number("stretch", c.stretch, not_negative.in("share"), "Value of the field stretch.");
  v.object("painted", c.painted);
}

template <class V>
void members(V& v, Visited<V, Problem>& c) {
  v.answer("Problem", "A refusal, as a problem document (RFC 9457).");
  v.text("type", c.type,
         "Name of the kind of problem: `urn:pelage:problem:` and a name, or `about:blank` if the status says it all.",
         any_length);
  v.text("title", c.title, "What went wrong, the same for all problems of the type.", any_length);
  v.integer("status", c.status, {400, 599}, "Status of the answer.");
  v.text("detail", c.detail, "What went wrong this time.", any_length);
  v.text(sparse("pointer"), c.pointer, "JSON pointer of the bad field; empty for the whole body.", any_length);
  v.text(sparse("limit"), c.limit, "Limit that was violated.", any_length);
  v.text(sparse("nearest"), c.nearest, "Known name nearest to an unknown one.", any_length);
}

}  // namespace pelage::json_parts
