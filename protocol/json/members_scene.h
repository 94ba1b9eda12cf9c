// JSON members of requests about whole scenes: models, history, recipes, picks, exports and maps.
#pragma once

#include "protocol/commands/guides.h"
#include "protocol/commands/history.h"
#include "protocol/commands/map.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/recipe.h"
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

template <class V>
void fur_members(V& v, Visited<V, FirstGroom>& c) {
  v.number("length", c.length, {0, 10, "sizes"}, "Length of the first fur.");
  v.number("inclination", c.inclination, share,
           "How far fur leans: 0 upright, 1 lying. It stands up where its flow begins, ends or parts.");
  v.name("form", c.form, json_names::groom_forms,
         "How lengths differ over the body. animal: shorter on face and paws, longer on chest and tail, estimated from "
         "where they lie in the model's box.");
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
  v.type("BuiltinModel", "A model that the server generates.");
  v.name("builtin", c.shape, json_names::builtins, "Name of the model.");
  v.integer("triangles", c.triangles, {2, static_cast<double>(limits::builtin_triangles)},
            "Approximate number of triangles.");
}

template <class V>
void members(V& v, Visited<V, NewScene>& c) {
  v.type("NewScene", "A scene to make. What is not given takes its default.");
  v.label("name", c.name, "Name of the scene: at most 200 bytes of UTF-8, no control characters.");
  v.object("model", c.model, "Built-in model that the scene begins with.");
  v.object("fur", c.fur, "The first fur.");
  fur_patches_member(v, c.fur_patches);
  v.boolean("ground", c.ground,
            "Whether the ground below the model is visible at first, as `set_ground` would make it.");
}

template <class V>
void members(V& v, Visited<V, SceneName>& c) {
  v.type("SceneName", "A new name for a scene.");
  v.label(required("name"), c.name, "New name: at most 200 bytes of UTF-8, no control characters.");
}

template <class V>
void members(V& v, Visited<V, Subdivide>& c) {
  v.type("Subdivide", "How a model is subdivided.");
  v.integer("levels", c.levels, {1, limits::subdivide_levels}, "Number of times that triangles are split.");
  v.boolean("masked", c.masked,
            "Splits only triangles with a corner whose mask is above 0.5, and neighbours so that no crack opens.");
}

template <class V>
void members(V& v, Visited<V, TurnModel>& c) {
  v.type("TurnModel", "How a model is turned; axes are those of the model as it stands now.");
  v.name("up", c.up, json_names::axes, "The axis that is to point up.");
  v.name("front", c.front, json_names::axes, "The axis that is to point forward, not parallel to `up`.");
}

template <class V>
void members(V& v, Visited<V, StepsBody>& c) {
  v.type("Steps", "A number of steps of the undo log.");
  v.integer("steps", c.steps, {1, 1000000}, "Number of steps.");
}

template <class V>
void members(V& v, Visited<V, RevisionBody>& c) {
  v.type("RevisionBody", "A revision of the scene.");
  v.counter(required("revision"), c.revision, "Revision to go back to.");
}

template <class V>
void members(V& v, Visited<V, BranchRequest>& c) {
  v.type("BranchRequest", "State that a new scene begins with.");
  v.label("name", c.name, "Name of the new scene: at most 200 bytes of UTF-8, no control characters.");
  v.counter("revision", c.revision, "Revision that it begins with, one of this model; default: the present one.");
}

template <class V>
void members(V& v, Visited<V, AmendRequest>& c) {
  v.type("AmendRequest", "New commands for an earlier step.");
  v.counter(required("revision"), c.revision,
            "Revision that made, joined or replayed the step, as in the log, or the number of the step.");
  v.objects(required("commands"), c.commands, {0, limits::commands_per_batch},
            "Commands that replace it, with whole strokes. An empty list removes the step.");
}

template <class V>
void members(V& v, Visited<V, RecipeRequest>& c) {
  v.type("RecipeRequest", "A recipe and the files that it includes. docs/recipes.md explains recipes.");
  v.text("file", c.file, "Name of the recipe; included files are relative to its folder.", limits::file_name_bytes);
  v.json(required("recipe"), c.recipe, "The recipe's document.");
  v.json(sparse("files"), c.files, "Documents of the included recipes, by name.");
  v.json(sparse("variables"), c.variables, "Values that replace the recipe's variables, by name.");
  v.json(sparse("places"), c.places,
         "Positions, as shares of the model's box, and sizes, by name; they replace variables and picks.");
}

template <class V>
void members(V& v, Visited<V, PickRay>& c) {
  v.type("PickRay", "A ray; picks its first hit on the surface, from either side.");
  v.position(required("origin"), c.origin, "Origin of the ray.");
  v.direction(required("direction"), c.direction, "Direction of the ray.");
}

template <class V>
void members(V& v, Visited<V, PickFarthest>& c) {
  v.type("PickFarthest", "Picks the point of the surface farthest along a direction, inside a box: the tip of an ear.");
  v.direction(required("direction"), c.direction, "Direction along which the point lies farthest.");
  v.position("min", c.min, "Lowest corner of the box; default: the whole model.");
  v.position("max", c.max, "Highest corner of the box; required with `min`, and nowhere below it.");
}

template <class V>
void members(V& v, Visited<V, PickRequest>& c) {
  v.type("PickRequest",
         "What to pick: the point under a pixel of a view, the first hit of a ray, the farthest point along a "
         "direction, or the one nearest to a position.");
  if (v.has("ray", c.ray.has_value())) return v.object(required("ray"), c.ray, "Ray whose first hit is picked.");
  if (v.has("farthest", c.farthest.has_value()))
    return v.object(required("farthest"), c.farthest, "Direction along which the point lies farthest.");
  if (v.has("nearest", c.nearest.has_value()))
    return v.position(required("nearest"), c.nearest, "Position to which the nearest point is picked.");
  v.object("view", c.view, "The view that the pixel belongs to.");
  v.pixel(required("pixel"), c.pixel, c.view, "Pixel from the top left, y down, within the view.");
  v.name("reach", c.reach, json_names::reaches,
         "fur: also returns the strand that an interactive frame shows at the pixel; the frame is drawn for it. skin: "
         "returns the skin alone, at once.");
}

template <class V>
void members(V& v, Visited<V, ImportOptions>& c) {
  v.type("ImportOptions", "How a model file is read.");
  v.name(required("format"), c.format, json_names::model_formats, "Format of the file.");
  v.name("up", c.up, json_names::axes, "The file's axis that points up. Default: z for stl and 3ds, else y.");
  v.name("front", c.front, json_names::axes,
         "The file's axis that the model faces, not parallel to `up`. Default: found from joints named left and right; "
         "without them, -y if z is up, else z.");
  v.text("pose", c.pose,
         "Pose from an animation of a glTF, as NAME@SECONDS, at most 200 bytes. Default: the pose of the file.");
  v.number("crease_degrees", c.crease_degrees, {0, 180, "degrees"},
           "Edges whose triangles' normals differ by more are sharp: skin and fur on each side are lit by that side's "
           "normals alone. 180: none is sharp.");
  v.integers("flip", c.flip, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Numbers of parts to turn inside out, from `doubtful_parts` of the answer.");
  v.integers("two_sided", c.two_sided, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Numbers of open parts that get a back, so that fur grows on both sides, from `sheets` of the answer; the "
             "only part of a model is 1.");
  fur_members(v, c.fur);
  fur_patches_member(v, c.fur_patches);
  v.boolean("ground", c.ground,
            "Whether the ground below the model is visible at first, as `set_ground` would make it.");
}

template <class V>
void members(V& v, Visited<V, MeshRequest>& c) {
  v.type("MeshRequest", "Resolution and contents of a mesh.");
  v.integer("triangles", c.triangles, {100, limits::proxy_triangles},
            "Largest number of triangles; more if the model cannot be simplified so far.");
  v.boolean(
      "fur", c.fur,
      "Adds attributes to each vertex: _FUR_MIDDLE and _FUR_TIP lead from it to the middle and the tip of the strand "
      "that grows there, of the coat with the longest fur, and are 0 on bald skin; _MASK is the mask there.");
}

template <class V>
void members(V& v, Visited<V, ExportRequest>& c) {
  v.type("ExportRequest", "What is exported, and how much of it.");
  v.name(required("format"), c.format, json_names::export_formats, "Format of the file, as the operation describes.");
  v.text(
      sparse("coat"), c.coat,
      "Name of the only coat to export; default: all that are not muted. `fields` holds those of one coat; name it if "
      "there are more.");
  v.integer("every", c.every, {1, 1e6},
            "Exports about one strand in this many, chosen at random. Above 1, `usda` marks them as guides unless "
            "`widen` is true.");
  v.boolean("widen", c.widen, "Makes strands `every` times as wide, to keep their coverage.");
  v.boolean("curves", c.curves, "Whether whiskers, lashes and brows are included.");
  v.name("basis", c.basis, json_names::curve_bases,
         "Straight between points, or Catmull-Rom curves through them; for format `usda` only.");
  v.boolean("skin", c.skin, "Whether the model's mesh is included; for format `usda` only.");
  v.integer("shells", c.shells, {1, 32}, "Number of shells; for format `shells` only.");
  v.integer("cards", c.cards, {100, 200000},
            "Approximate number of cards of the finest level; for format `cards` only.");
  v.name("frame", c.frame, json_names::asset_frames,
         "Axes of positions. source: those of the model's file, so that the fur fits it. pelage: up +y, front +z.");
  v.number(bare("metres_per_unit"), c.metres_per_unit, metres,
           "Metres per unit of the model's file; default 1. `usda` states it, GLBs are scaled by it.");
}

template <class V>
void members(V& v, Visited<V, Revisions>& c) {
  v.type("Revisions", "Two revisions to compare.");
  v.counter(required("from"), c.from, "First revision, of this model.");
  v.counter(required("to"), c.to, "Second revision, of this model.");
}

template <class V>
void members(V& v, Visited<V, AtRevision>& c) {
  v.type("AtRevision", "A revision of the scene.");
  v.counter("revision", c.revision, "Revision to read, one of this model; default: the present one.");
}

template <class V>
void members(V& v, Visited<V, Batch>& c) {
  v.type("Batch", "Several commands as one undo step, all or nothing.");
  v.objects(required("commands"), c.commands, {1, limits::commands_per_batch}, "Commands that run one after another.");
}

template <class V>
void members(V& v, Visited<V, EnvironmentUpload>& c) {
  v.type("EnvironmentUpload", "How a picture lights the scene.");
  intensity_member(v, c.environment), turn_member(v, c.environment);
  v.text(sparse("colour_space"), c.colour_space,
         "Linear colour space of the picture: a name, an alias or a role of the OpenColorIO configuration that $OCIO "
         "names for the server. Default: linear with Rec. 709 primaries.");
}

/// Visits the members that map requests and map uploads have in common.
template <class V, class Map>
void map_members(V& v, Map& c, const char* scale_words) {
  v.name(required("field"), c.field, json_names::fields, "Field that is drawn or read.");
  v.text(sparse("coat"), c.coat, "Name of the coat whose field it is. Default: draws the first, or changes all.");
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units, scale_words);
  v.name("units", c.units, json_names::units, "Unit of `scale` if it is a length.");
}

template <class V>
void members(V& v, Visited<V, MapRequest>& c) {
  v.type("MapRequest", "How a field is drawn as a picture.");
  map_members(v, c,
              "Value of 1 in the picture, in the field's unit; for fast_fur of the width, for vector of the length. "
              "Default: for PNG of length, stretch, width or stiffness the largest value, else 1.");
  v.name("format", c.format, json_names::map_formats,
         "Format of the file. png, png16: 8 or 16 bits. exr, exr_half: floats or halfs. npy: a NumPy array of floats, "
         "[size, size] or [size, size, channels], rows from the top; for `vertices`, [vertices] or [vertices, "
         "channels], without size and dilate.");
  v.integer("size", c.size, {1, limits::map_pixels, "pixels"},
            "Width and height. Above 4096 one map is made at a time.");
  v.integer("dilate", c.dilate, {0, limits::map_dilation, "pixels"}, "How far islands grow over their seams.");
  v.integer("tile", c.tile, {0, last_udim}, "UDIM tile to draw, from 1001; 0: all of them over one another.");
}

template <class V>
void members(V& v, Visited<V, MapUpload>& c) {
  v.type("MapUpload", "How a picture is read as a field.");
  map_members(v, c, "Value of 1 in the picture. Default: the scale that the file states, lengths in sizes, else 1.");
  v.number("strength", c.strength, share, "Blend from the field to the picture: 0 none, 1 full.");
  v.integer("tile", c.tile, {0, last_udim},
            "UDIM tile of the picture, from 1001: only vertices in it change. 0: the picture repeats, and all vertices "
            "change.");
}

template <class V>
void members(V& v, Visited<V, GuideUpload>& c) {
  v.type("GuideUpload", "How guide curves are read, and how far fur follows them.");
  v.name(required("format"), c.format, json_names::guide_formats, "Format of the file.");
  v.text(sparse("coat"), c.coat, "Name of the coat that follows them; default: all.");
  v.integer("keys", c.keys, {1, limits::keys},
            "Largest number of curves to use, chosen evenly by their order; fewer if the model has too many vertices "
            "for them.");
  v.number("sigma", c.sigma, {1e-6, 1e6, "sizes"},
           "Width of the Gaussians that spread them; default: from the distance between roots.");
  v.number("strength", c.strength, share, "Strength of the effect: 0 none, 1 full.");
  v.name(bare("frame"), c.frame, json_names::asset_frames,
         "Axes of the file, as for an export. Default: source for `usda` and `hair`, pelage for `json`. A `usda` with "
         "another upAxis is turned.");
  v.number(
      bare("metres_per_unit"), c.metres_per_unit, metres,
      "Metres per unit of the model's file; default 1 for glTF. If known, a `usda` is scaled by its metersPerUnit.");
}

}  // namespace pelage::json_parts
