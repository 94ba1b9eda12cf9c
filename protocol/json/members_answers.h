// What the server answers, on the wire.
#pragma once

#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/map.h"
#include "protocol/commands/quality.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, FrameCounters>& c) {
  v.answer("FrameCounters");
  v.counter("passes", c.passes, "Programs put to use, one after another.");
  v.counter("draws", c.draws, "Draw calls.");
  v.counter("textures", c.textures, "Textures bound.");
  v.counter("bytes", c.bytes, "Sent to what draws for the frame, changes of fields included.");
  v.counter(
      "fragments", c.fragments,
      "Runs of fragment shaders, but for the pass that writes the picture's pixels; samples that were drawn where "
      "the GL does not count runs.");
  v.counter("objects", c.objects, "Buffers, textures, targets and programs that were made.");
  v.counter("allocated", c.allocated, "Bytes of storage that was asked for, without mip levels.");
  v.number("redrawn", c.redrawn, share,
           "Share of the picture that was drawn. Below 1 after a stroke, where the frame before showed the same view: "
           "the rest is kept. The picture has the same bits as if all of it had been drawn.");
}

template <class V>
void members(V& v, Visited<V, FrameEstimate>& c) {
  v.answer("FrameEstimate");
  v.number("error", c.error, share, "Mean FLIP where there is fur, against the reference: that of half of the frames.");
  v.number("error_safety", c.error_safety, one_or_more, "95% of frames have at most `error` times it.");
  std::size_t reference = 0;
  v.name("reference", reference, json_names::error_references,
         "The same fur and light in 1024 or fewer sorted shells.");
  v.number("cost_ms", c.cost_ms, not_negative, "Drawing time, as of `budget_ms`, before the frame was drawn.");
  v.number("cost_safety", c.cost_safety, one_or_more, "95% of frames cost at most `cost_ms` times it.");
  v.number("correction", c.correction, positive,
           "Measured over predicted cost of this scene's frames so far, which `cost_ms` has in it. It moves in steps, "
           "and only when it is off by more than 8%.");
  v.name("end", c.end, json_names::plan_ends,
         "Why the frame has its knobs. asked: the request named them. budget: better ones cost too much. error: the "
         "cheapest that keep the error. best: nothing better is known. cheapest: even the cheapest are over the "
         "budget.");
  v.text("calibration", c.calibration,
         "Name of what costs are estimated by; `defaults` until `pelage calibrate` has measured the machine.");
}

template <class V>
void members(V& v, Visited<V, FrameCost>& c) {
  v.answer("FrameCost", "What drawing a frame is expected to take; waiting for others and encoding come on top.");
  v.number("seconds", c.seconds, not_negative, "Half of such frames are done by then.");
  v.number("safety", c.safety, one_or_more, "95% of such frames are done after `seconds` times it.");
}

template <class V>
void members(V& v, Visited<V, ExportAnswer>& c) {
  v.answer("ExportAbout", "What an exported file holds.");
  v.counter("revision", c.revision);
  v.name("format", c.format, json_names::export_formats);
  v.counter("strands", c.strands, "With whiskers, lashes and brows; 0 of a GLB.");
  v.counter("points", c.points, "Of all strands.");
  v.counter("triangles", c.triangles, "Of a GLB: of the skin and of all layers, or of the finest level of cards.");
  v.counter("cards", c.cards, "Of the finest level.");
  v.counter("bytes", c.bytes, "Of the file.");
}

template <class V>
void members(V& v, Visited<V, FrameProgress>& c) {
  v.answer("FrameProgress");
  v.text("view", c.view, "Of its request.");
  v.integer("width", c.width, pixels, "Pixels.");
  v.integer("height", c.height, pixels, "Pixels.");
  v.number("share", c.share, share, "Of the expected drawing time that has passed, at most 0.99; 0 while it waits.");
  v.number("seconds", c.seconds, not_negative, "Since it was asked for.");
  v.number("expected_seconds", c.expected_seconds, not_negative, "That drawing it takes.");
}

template <class V>
void members(V& v, Visited<V, FrameProgressList>& c) {
  v.answer("FrameProgressList");
  v.objects("frames", c.frames, any_count, "In the order that they were asked for.");
}

template <class V>
void members(V& v, Visited<V, TraceReport>& c) {
  v.answer("TraceReport");
  v.integer("passes", c.passes, {0, limits::trace_passes}, "In this picture; 0 for shells.");
  v.number("samples", c.samples, not_negative, "Mean of a pixel.");
  v.number("noise", c.noise, share, "Estimated mean error of a shown channel.");
  v.counter("strands", c.strands);
  v.name("end", c.end, json_names::trace_ends, "Why it ended; none while it goes on.");
  v.number("grow_ms", c.grow_ms, not_negative, "Growing and indexing strands.");
  v.number("trace_ms", c.trace_ms, not_negative);
}

template <class V>
void members(V& v, Visited<V, MapAnswer>& c) {
  v.answer("MapAbout", "How to read a map.");
  v.counter("revision", c.revision);
  v.name("field", c.field, json_names::fields);
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, any_number, "What 1 in the picture stands for.");
  v.name("units", c.units, json_names::units);
  v.number("covered", c.covered, share, "Share of the pixels that lie in triangles.");
  v.counter("outside", c.outside,
            "Triangles with a part outside [0, 1], drawn where a picture that repeats shows them.");
  v.integers("tiles", c.tiles, {first_udim, last_udim}, any_count,
             "UDIM tiles that the model has texture coordinates in.");
}

template <class V>
void members(V& v, Visited<V, PictureAnswer>& c) {
  v.answer("StoredPicture");
  v.picture("picture", c.picture);
  v.integer("width", c.width, {1, limits::picture_pixels});
  v.integer("height", c.height, {1, limits::picture_pixels});
  v.integer("bits", c.bits, {8, 32}, "Of a channel: 8, 16, or 32 for any float.");
  v.number(sparse("scale"), c.scale, any_number, "What 1 in it stands for, where the file says so.");
}

template <class V>
void members(V& v, Visited<V, EditLayer>& c) {
  v.answer("EditLayer");
  v.text("name", c.name);
  v.number("weight", c.weight, edit_layer_weight);
  v.boolean("muted", c.muted);
}

template <class V>
void members(V& v, Visited<V, Bounds>& c) {
  v.answer("Bounds");
  v.position("min", c.min);
  v.position("max", c.max);
}

template <class V>
void members(V& v, Visited<V, Repair>& c) {
  v.answer("Repair");
  v.text("code", c.code);
  v.counter("count", c.count);
  v.texts(sparse("names"), c.names, "Of what was left out, the first few.");
}

template <class V>
void members(V& v, Visited<V, NumberedPart>& c) {
  v.answer("NumberedPart");
  v.integer("part", c.part, {1, static_cast<double>(limits::model_triangles)},
            "Its number, from 1, as `flip` and `two_sided` take it.");
  v.counter("triangles", c.triangles);
  v.position("centre", c.centre, "Of its box.");
}

template <class V>
void report_members(V& v, Visited<V, ModelReport>& c) {
  v.counter("source_vertices", c.source_vertices);
  v.counter("source_faces", c.source_faces);
  v.counter("vertices", c.vertices, "Welded on equal positions.");
  v.counter("triangles", c.triangles);
  v.counter("parts", c.parts, "Connected parts.");
  v.number("size", c.size, positive, "Diagonal of the box, the model's unit.");
  v.object("bounds", c.bounds);
  v.name("up", c.up, json_names::axes, "The file's axis that was taken for up.");
  v.name("front", c.front, json_names::axes, "The file's axis that was taken for forward.");
  v.text("pose", c.pose, "NAME@SECONDS of the animation that it stands in; empty as the file has it.", any_length);
  v.texts("animations", c.animations, "Names of those that the file has.");
  v.objects("repairs", c.repairs, any_count, "What was mended, and what was left out.");
  v.objects("doubtful_parts", c.doubtful_parts, any_count,
            "Open parts that may be inside out: what little they enclose says so. `flip` turns one.");
  v.objects(
      "sheets", c.sheets, any_count,
      "Of several parts those of one layer: open, and enclosing next to nothing. They are bare behind; `two_sided` "
      "gives one a back.");
}

template <class V>
void members(V& v, Visited<V, SceneSummary>& c) {
  v.answer("Scene");
  v.text("id", c.id);
  v.text("name", c.name);
  v.counter("revision", c.revision);
  v.text("model", c.model, "A built-in's name, or a format.");
  v.text("model_id", c.model_id,
         "Equal as long as the mesh is: clients may keep what they know of the mesh under it. Uploads and subdivisions "
         "change it; a restart may.");
  v.word("fur_patches", c.fur_patches, json_names::fur_patches);
  report_members(v, c.report);
  v.hash("fields_hash", c.fields_hash);
  v.counter("undo_steps", c.undo_steps);
  v.counter("redo_steps", c.redo_steps);
  v.objects("edit_layers", c.edit_layers, {0, limits::edit_layers}, "Edit layers, from the lowest.");
}

template <class V>
void members(V& v, Visited<V, SceneList>& c) {
  v.answer("SceneList");
  v.objects("scenes", c.scenes, {0, limits::scenes});
}

template <class V>
void members(V& v, Visited<V, FieldChange>& c) {
  v.answer("FieldChange");
  v.word("field", c.field, json_names::fields);
  v.counter("changed", c.changed, "Vertices of which a bit changed.");
  v.number("mean_change", c.mean_change, not_negative,
           "Over them, in the field's unit; of several channels the length of the difference.");
  v.number("max_change", c.max_change, not_negative);
}

template <class V>
void members(V& v, Visited<V, CommandResult>& c) {
  v.answer("CommandResult");
  v.text("op", c.op);
  v.counter("touched", c.touched, "Vertices of which a bit changed.");
  v.number("mean_change", c.mean_change, not_negative,
           "Of the first field that changed, over its changed vertices, in its unit.");
  v.number("max_change", c.max_change, not_negative);
  v.counter("clamped", c.clamped, "Vertices at which a value was held at its limit.");
  v.number("milliseconds", c.milliseconds, not_negative);
  v.objects("fields", c.fields, any_count);
  v.texts("warnings", c.warnings, "What was done as asked but is hardly meant, such as a brush finer than the mesh.");
}

template <class V>
void members(V& v, Visited<V, CommandAnswer>& c) {
  v.answer("CommandAnswer");
  v.counter("revision", c.revision);
  v.hash("fields_hash", c.fields_hash);
  v.objects("results", c.results, any_count);
}

template <class V>
void members(V& v, Visited<V, Comparison>& c) {
  v.answer("Comparison");
  v.counter("from", c.from);
  v.counter("to", c.to);
  v.counter("touched", c.touched, "Vertices at which any field differs.");
  v.objects("fields", c.fields, any_count);
}

template <class V>
void members(V& v, Visited<V, FoldCount>& c) {
  v.answer("FoldCount");
  v.counter("revision", c.revision);
  v.counter("triangles", c.triangles);
  v.counter("folded", c.folded);
}

template <class V>
void members(V& v, Visited<V, LogEntry>& c) {
  v.answer("LogEntry");
  v.counter("revision", c.revision);
  v.word("kind", c.kind, json_names::entry_kinds, "`join` and `replay` belong to the undo step of the entry before.");
  v.counter("step", c.step,
            "Number of the step whose commands these are: the revision that made it first. An `amend` leaves it to the "
            "step that it changes and to those that it replays. 0 of undo, redo and revert.");
  v.counter("touched", c.touched);
  v.boolean("in_effect", c.in_effect,
            "Whether its commands are among those that lead to the present: they can be amended.");
  v.text("author", c.author, "The `Pelage-Author` of the request that made it; empty where none was named.");
  v.json(sparse("commands"), c.commands, "The commands as they were resolved.");
}

template <class V>
void members(V& v, Visited<V, Log>& c) {
  v.answer("Log");
  v.objects("entries", c.entries, any_count);
}

template <class V>
void members(V& v, Visited<V, SceneEvent>& c) {
  v.answer("SceneEvent", "What a scene is when its news begin and when its mesh is another.");
  v.counter("revision", c.revision);
  v.counter("first_revision", c.first_revision, "At which the model came; the log has those after it.");
  v.counter("undo_steps", c.undo_steps);
  v.counter("redo_steps", c.redo_steps);
  v.text("model_id", c.model_id, "As in `Scene`.");
}

template <class V>
void members(V& v, Visited<V, ChangeEvent>& c) {
  v.answer("ChangeEvent", "One line of the log without its commands.");
  v.counter("revision", c.revision);
  v.word("kind", c.kind, json_names::entry_kinds, "`join` and `replay` belong to the undo step of the entry before.");
  v.counter("argument", c.argument,
            "Of `undo` and `redo` the steps, of `revert` the revision that it goes back to; else 0.");
  v.text("author", c.author, "As in `LogEntry`.");
  v.texts("ops", c.ops, "`op` of its commands, each once.");
  v.counter("touched", c.touched);
  v.counter("undo_steps", c.undo_steps, "That could be undone after it.");
  v.counter("redo_steps", c.redo_steps);
}

/// A member for each painted field, with a little above its largest value for sums of floats.
template <class V>
void members(V& v, Visited<V, PaintedValues>& c) {
  static constexpr const char* words[] = {"Share of the coat's strands.",
                                          "Of the coat's strand widths.",
                                          "Added to the coat's own.",
                                          "Added to the coat's own.",
                                          "Added to the coat's own.",
                                          "1 where skin shows.",
                                          "How much tools may change: 1 all, 0 nothing.",
                                          "",
                                          ""};
  static_assert(std::size(words) == std::tuple_size_v<PaintedValues>);
  v.answer("PaintedValues",
           "What is painted at a place. A colour is linear red, green and blue, and how much of the coat's colour it "
           "covers.");
  for (std::size_t i = 0; i < c.size(); ++i) {
    const FieldShape& shape = field_shapes[first_painted + i];
    const Range range{0, static_cast<double>(shape.max) + 1e-6};
    if (shape.channels == 1) v.number(shape.name.data(), c[i].x, range, words[i]);
    if (shape.channels == 4) v.vector(shape.name.data(), c[i], range, words[i]);
  }
}

template <class V>
void members(V& v, Visited<V, PickAnswer>& c) {
  v.answer("Pick");
  v.boolean(tag("hit"), c.hit);
  if (!v.takes(c.hit)) return;
  v.seed("triangle", c.triangle);
  v.vector("barycentric", c.barycentric, share, "Weights of the triangle's corners.");
  v.position("position", c.position);
  v.vector("normal", c.normal, any_number);
  v.vector("direction", c.direction, any_number, "Where the fur leans, a unit vector; 0 when it stands upright.");
  v.number("inclination", c.inclination, {0, 1 + 1e-6}, "0 upright, 1 lying.");
  v.number("length", c.length, not_negative, "Sizes.");
  v.number("stretch", c.stretch, not_negative);
  v.object("painted", c.painted);
}

template <class V>
void members(V& v, Visited<V, Problem>& c) {
  v.answer("Problem", "RFC 9457.");
  v.text("type", c.type, "`urn:pelage:problem:` and a name, or `about:blank` where the status says it all.",
         any_length);
  v.text("title", c.title, "", any_length);
  v.integer("status", c.status, {400, 599});
  v.text("detail", c.detail, "", any_length);
  v.text(sparse("pointer"), c.pointer, "JSON pointer of the bad field; empty for the whole body.", any_length);
  v.text(sparse("limit"), c.limit, "The limit that was broken.", any_length);
  v.text(sparse("nearest"), c.nearest, "The nearest known name to an unknown one.", any_length);
}

}  // namespace pelage::json_parts
