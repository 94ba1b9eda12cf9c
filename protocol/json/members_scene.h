// Requests about whole scenes and their history, on the wire.
#pragma once

#include "protocol/commands/guides.h"
#include "protocol/commands/history.h"
#include "protocol/commands/map.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/scene.h"
#include "protocol/json/decode.h"
#include "protocol/json/members_look.h"
#include "protocol/json/members_tools.h"

namespace pelage::json_parts {

struct StepsBody {
  int steps = 1;
};

struct RevisionBody {
  std::uint64_t revision = 0;
};

struct Revisions {
  std::uint64_t from = 0, to = 0;
};

struct AtRevision {
  std::optional<std::uint64_t> revision = {};
};

struct Batch {
  std::vector<Command> commands;
};

/// What a query says about the environment that comes with it.
struct EnvironmentUpload {
  Environment environment;
};

template <class V>
void fur_members(V& v, Visited<V, FirstGroom>& c) {
  v.number("length", c.length, {0, 10}, "Sizes.");
  v.number("inclination", c.inclination, share, "0 upright, 1 lying. Where fur begins, ends and parts it stands up.");
  v.name(
      "form", c.form, json_names::groom_forms,
      "animal: shorter on face and paws, longer on chest and tail, estimated from where they lie in the model's box.");
}

template <class V>
void members(V& v, Visited<V, FirstGroom>& c) {
  v.type("FirstGroom",
         "The first fur, which flows from under the chin to the ends of limbs, ears and tail; on sheets from front to "
         "back.");
  fur_members(v, c);
}

template <class V>
void fur_patches_member(V& v, Visited<V, FurPatches>& patches) {
  v.name("fur_patches", patches, json_names::fur_patches);
}

template <class V>
void members(V& v, Visited<V, BuiltinModel>& c) {
  v.type("BuiltinModel");
  v.name("builtin", c.shape, json_names::builtins);
  v.integer("triangles", c.triangles, {2, static_cast<double>(limits::builtin_triangles)},
            "Triangles that are wished for.");
}

template <class V>
void members(V& v, Visited<V, NewScene>& c) {
  v.type("NewScene");
  v.label("name", c.name, "At most 200 bytes of UTF-8, no control characters.");
  v.object("model", c.model);
  v.object("fur", c.fur);
  fur_patches_member(v, c.fur_patches);
}

template <class V>
void members(V& v, Visited<V, Subdivide>& c) {
  v.type("Subdivide");
  v.integer("levels", c.levels, {1, limits::subdivide_levels}, "How often triangles are split.");
  v.boolean("masked", c.masked,
            "Only triangles with a corner whose mask is above 0.5, and their neighbours so that no crack opens.");
}

template <class V>
void members(V& v, Visited<V, StepsBody>& c) {
  v.type("Steps");
  v.integer("steps", c.steps, {1, 1000000});
}

template <class V>
void members(V& v, Visited<V, RevisionBody>& c) {
  v.type("RevisionBody");
  v.counter(required("revision"), c.revision);
}

template <class V>
void members(V& v, Visited<V, BranchRequest>& c) {
  v.type("BranchRequest");
  v.label("name", c.name, "At most 200 bytes of UTF-8, no control characters.");
  v.counter("revision", c.revision, "One of this model; the present one when it is not given.");
}

template <class V>
void members(V& v, Visited<V, AmendRequest>& c) {
  v.type("AmendRequest");
  v.counter(required("revision"), c.revision,
            "That made, joined or replayed the step, as in the log, or the number of the step.");
  v.objects(required("commands"), c.commands, {0, limits::commands_per_batch},
            "What takes its place; strokes are whole. None leaves the step out.");
}

template <class V>
void members(V& v, Visited<V, PickRay>& c) {
  v.type("PickRay", "The first place of the surface that it hits, from either side.");
  v.position(required("origin"), c.origin);
  v.direction(required("direction"), c.direction);
}

template <class V>
void members(V& v, Visited<V, PickFarthest>& c) {
  v.type("PickFarthest",
         "The place of the surface that lies farthest along a direction, of what lies in a box: the tip of an ear.");
  v.direction(required("direction"), c.direction);
  v.position("min", c.min, "Lowest corner of the box; the whole model unless given.");
  v.position("max", c.max, "Highest corner of the box. With `min`, and nowhere below it.");
}

template <class V>
void members(V& v, Visited<V, PickRequest>& c) {
  v.type("PickRequest",
         "Which place is meant: what lies under a pixel of a view; or the first that a ray hits, the farthest along a "
         "direction, or the nearest to a point.");
  if (v.has("ray", c.ray.has_value())) return v.object(required("ray"), c.ray);
  if (v.has("farthest", c.farthest.has_value())) return v.object(required("farthest"), c.farthest);
  if (v.has("nearest", c.nearest.has_value())) return v.position(required("nearest"), c.nearest);
  v.object("view", c.view);
  v.pixel(required("pixel"), c.pixel, c.view, "Pixels from the top left, within the view.");
}

template <class V>
void members(V& v, Visited<V, ImportOptions>& c) {
  v.type("ImportOptions");
  v.name(required("format"), c.format, json_names::model_formats);
  v.name("up", c.up, json_names::axes, "The file's axis that points up. Unless given: z of stl, else y.");
  v.name(
      "front", c.front, json_names::axes,
      "The file's axis that the model faces, on another line than `up`. Unless given it follows from joints that are "
      "called left and right; without such -y where z is up, else z.");
  v.text(
      "pose", c.pose,
      "NAME@SECONDS of an animation of a glTF, at most 200 bytes: the model stands as it shows it then. Unless given "
      "it stands as the file has it.");
  v.number("crease_degrees", c.crease_degrees, {0, 180},
           "An edge whose triangles' normals differ by more is seen as an edge, and skin and fur beside it are lit by "
           "their own side alone; 180: none is.");
  v.integers("flip", c.flip, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Parts that are turned inside out, by the numbers that `doubtful_parts` of the answer gives.");
  v.integers("two_sided", c.two_sided, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Parts of one layer that get a back, so that fur grows on both sides, by the numbers that `sheets` of the "
             "answer gives; the only part of a model is 1.");
  fur_members(v, c.fur);
  fur_patches_member(v, c.fur_patches);
}

template <class V>
void members(V& v, Visited<V, MeshRequest>& c) {
  v.type("MeshRequest");
  v.integer("triangles", c.triangles, {100, limits::proxy_triangles},
            "At most so many, but where the model cannot be made simpler.");
}

template <class V>
void members(V& v, Visited<V, ExportRequest>& c) {
  v.type("ExportRequest");
  v.name(required("format"), c.format, json_names::export_formats);
  v.integer("every", c.every, {1, 1e6},
            "About one strand of so many, chosen by numbers of their own; above 1 they count as guides, unless they "
            "are widened.");
  v.boolean("widen", c.widen, "Makes strands `every` times as wide, which keeps what they cover.");
  v.boolean("curves", c.curves, "With whiskers, lashes and brows.");
  v.integer("shells", c.shells, {1, 32}, "Layers of `shells`.");
  v.integer("cards", c.cards, {100, 200000}, "Of the finest level of `cards`, about.");
}

template <class V>
void members(V& v, Visited<V, Revisions>& c) {
  v.type("Revisions");
  v.counter(required("from"), c.from);
  v.counter(required("to"), c.to);
}

template <class V>
void members(V& v, Visited<V, AtRevision>& c) {
  v.type("AtRevision");
  v.counter("revision", c.revision, "One of this model; the present one when it is not given.");
}

template <class V>
void members(V& v, Visited<V, Batch>& c) {
  v.type("Batch");
  v.objects(required("commands"), c.commands, {1, limits::commands_per_batch});
}

template <class V>
void members(V& v, Visited<V, EnvironmentUpload>& c) {
  v.type("EnvironmentUpload");
  intensity_member(v, c.environment), turn_member(v, c.environment);
}

/// What requests for maps and uploads of maps have in common.
template <class V, class Map>
void map_members(V& v, Map& c, const char* scale_words) {
  v.name(required("field"), c.field, json_names::fields);
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units, scale_words);
  v.name("units", c.units, json_names::units, "Of a scale of lengths.");
}

template <class V>
void members(V& v, Visited<V, MapRequest>& c) {
  v.type("MapRequest");
  map_members(
      v, c,
      "What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. Unless "
      "given the field's largest value for PNG, else 1.");
  v.name("format", c.format, json_names::map_formats,
         "8 or 16 bits, an EXR of floats or halfs, or a NumPy array of floats: [size, size] or [size, size, channels], "
         "rows from the top; of `vertices` [vertices] or [vertices, channels], without size and dilate.");
  v.integer("size", c.size, {1, limits::map_pixels}, "Pixels of a side. Above 4096 one map is made at a time.");
  v.integer("dilate", c.dilate, {0, limits::map_dilation}, "Pixels by which islands grow over their seams.");
  v.integer("tile", c.tile, {0, last_udim}, "UDIM tile to draw, from 1001; 0: all of them over one another.");
}

template <class V>
void members(V& v, Visited<V, MapUpload>& c) {
  v.type("MapUpload");
  map_members(v, c,
              "What 1 in the picture stands for. With neither it nor `units`: what the file says of itself, else 1.");
  v.number("strength", c.strength, share, "How far the field goes to the picture's.");
  v.integer("tile", c.tile, {0, last_udim},
            "UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats, "
            "and all do.");
}

template <class V>
void members(V& v, Visited<V, GuideUpload>& c) {
  v.type("GuideUpload");
  v.name(required("format"), c.format, json_names::guide_formats);
  v.integer(
      "keys", c.keys, {1, limits::keys},
      "Curves that are used at most, chosen evenly by their order; fewer where the model has so many vertices that "
      "they would be too much work.");
  v.number("sigma", c.sigma, {1e-6, 1e6},
           "Width of the Gaussians that spread them, sizes; from the distance between roots unless given.");
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
}

}  // namespace pelage::json_parts
