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
           "How far fur leans: 0 upright, 1 lying. Where fur begins, ends and parts it stands up.");
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
  v.type("BuiltinModel", "A model that the server makes.");
  v.name("builtin", c.shape, json_names::builtins, "Name of the model.");
  v.integer("triangles", c.triangles, {2, static_cast<double>(limits::builtin_triangles)},
            "About how many triangles it has.");
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
  v.type("SceneName", "Another name for a scene.");
  v.label(required("name"), c.name, "Its name: at most 200 bytes of UTF-8, no control characters.");
}

template <class V>
void members(V& v, Visited<V, Subdivide>& c) {
  v.type("Subdivide", "How a model is made finer.");
  v.integer("levels", c.levels, {1, limits::subdivide_levels}, "How often triangles are split.");
  v.boolean("masked", c.masked,
            "Only triangles with a corner whose mask is above 0.5, and their neighbours so that no crack opens.");
}

template <class V>
void members(V& v, Visited<V, TurnModel>& c) {
  v.type("TurnModel", "How a model is turned, by its axes as it stands now.");
  v.name("up", c.up, json_names::axes, "The axis that is to point up.");
  v.name("front", c.front, json_names::axes, "The axis that is to point forward, on another line than `up`.");
}

template <class V>
void members(V& v, Visited<V, StepsBody>& c) {
  v.type("Steps", "How many steps of the undo log.");
  v.integer("steps", c.steps, {1, 1000000}, "How many steps.");
}

template <class V>
void members(V& v, Visited<V, RevisionBody>& c) {
  v.type("RevisionBody", "A revision of the scene.");
  v.counter(required("revision"), c.revision, "Revision to go back to.");
}

template <class V>
void members(V& v, Visited<V, BranchRequest>& c) {
  v.type("BranchRequest", "Where another scene begins.");
  v.label("name", c.name, "Name of the new scene: at most 200 bytes of UTF-8, no control characters.");
  v.counter("revision", c.revision,
            "Revision that it begins as, one of this model; the present one when it is not given.");
}

template <class V>
void members(V& v, Visited<V, AmendRequest>& c) {
  v.type("AmendRequest", "Other commands for an earlier step.");
  v.counter(required("revision"), c.revision,
            "Revision that made, joined or replayed the step, as in the log, or the number of the step.");
  v.objects(required("commands"), c.commands, {0, limits::commands_per_batch},
            "Commands that take its place; strokes are whole. An empty list leaves the step out.");
}

template <class V>
void members(V& v, Visited<V, RecipeRequest>& c) {
  v.type("RecipeRequest", "A recipe with all that it is made of. docs/recipes.md says what a recipe is.");
  v.text("file", c.file, "Name of the recipe; what it includes is named from its folder.", limits::file_name_bytes);
  v.json(required("recipe"), c.recipe, "The recipe's document.");
  v.json(sparse("files"), c.files, "Documents of the recipes that are included, by name.");
  v.json(sparse("variables"), c.variables, "Values in place of the recipe's, by name.");
  v.json(sparse("places"), c.places,
         "Places, as shares of the model's box, and sizes, by name; they take the place of variables and picks.");
}

template <class V>
void members(V& v, Visited<V, PickRay>& c) {
  v.type("PickRay", "A ray; the first place of the surface that it hits, from either side, is meant.");
  v.position(required("origin"), c.origin, "Point that it begins at.");
  v.direction(required("direction"), c.direction, "Direction that it goes in.");
}

template <class V>
void members(V& v, Visited<V, PickFarthest>& c) {
  v.type("PickFarthest",
         "The place of the surface that lies farthest along a direction, of what lies in a box: the tip of an ear.");
  v.direction(required("direction"), c.direction, "Direction along which the place lies farthest.");
  v.position("min", c.min, "Lowest corner of the box; the whole model unless given.");
  v.position("max", c.max, "Highest corner of the box. With `min`, and nowhere below it.");
}

template <class V>
void members(V& v, Visited<V, PickRequest>& c) {
  v.type(
      "PickRequest",
      "The place that is meant: what lies under a pixel of a view; or the first that a ray hits, the farthest along a "
      "direction, or the nearest to a point.");
  if (v.has("ray", c.ray.has_value())) return v.object(required("ray"), c.ray, "Ray that hits the place.");
  if (v.has("farthest", c.farthest.has_value()))
    return v.object(required("farthest"), c.farthest, "Direction along which the place lies farthest.");
  if (v.has("nearest", c.nearest.has_value()))
    return v.position(required("nearest"), c.nearest, "Point that the place is nearest to.");
  v.object("view", c.view, "The frame that the pixel belongs to.");
  v.pixel(required("pixel"), c.pixel, c.view, "Pixel from the top left, y down, within the view.");
  v.name("reach", c.reach, json_names::reaches,
         "fur: the answer also has the strand that an interactive frame of the view shows at the pixel, which is drawn "
         "for it. skin: it has the skin alone, at once.");
}

template <class V>
void members(V& v, Visited<V, ImportOptions>& c) {
  v.type("ImportOptions", "How a model file is read.");
  v.name(required("format"), c.format, json_names::model_formats, "Format of the file.");
  v.name("up", c.up, json_names::axes, "The file's axis that points up. Unless given: z of stl and 3ds, else y.");
  v.name(
      "front", c.front, json_names::axes,
      "The file's axis that the model faces, on another line than `up`. Unless given it follows from joints that are "
      "called left and right; without such -y where z is up, else z.");
  v.text("pose", c.pose,
         "Moment of an animation of a glTF as NAME@SECONDS, at most 200 bytes: the model stands as it shows it then. "
         "Unless given it stands as the file has it.");
  v.number("crease_degrees", c.crease_degrees, {0, 180, "degrees"},
           "An edge whose triangles' normals differ by more is seen as an edge, and skin and fur beside it are lit by "
           "their own side alone; 180: none is.");
  v.integers("flip", c.flip, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Parts that are turned inside out, by the numbers that `doubtful_parts` of the answer gives.");
  v.integers("two_sided", c.two_sided, {1, static_cast<double>(limits::model_triangles)}, {0, limits::numbered_parts},
             "Parts of one layer that get a back, so that fur grows on both sides, by the numbers that `sheets` of the "
             "answer gives; the only part of a model is 1.");
  fur_members(v, c.fur);
  fur_patches_member(v, c.fur_patches);
  v.boolean("ground", c.ground,
            "Whether the ground below the model is visible at first, as `set_ground` would make it.");
}

template <class V>
void members(V& v, Visited<V, MeshRequest>& c) {
  v.type("MeshRequest", "How fine a mesh is wanted.");
  v.integer("triangles", c.triangles, {100, limits::proxy_triangles},
            "Largest count of triangles; more come where the model cannot be made simpler.");
  v.boolean("fur", c.fur,
            "Whether each vertex also says where the strand on it stands now, by the fields and the coat's lean curve: "
            "the attributes _FUR_MIDDLE and _FUR_TIP lead from the vertex to half of the strand's length and to its "
            "tip, which is 0 where the skin is bald, and _MASK is the mask there.");
}

template <class V>
void members(V& v, Visited<V, ExportRequest>& c) {
  v.type("ExportRequest", "What is exported, and how much of it.");
  v.name(required("format"), c.format, json_names::export_formats, "What is written, as the operation says.");
  v.text(
      sparse("coat"), c.coat,
      "Name of the only coat that is in it; all that are not muted unless given. `shells`, `cards` and `fields` hold "
      "one, which is named where there are more.");
  v.integer("every", c.every, {1, 1e6},
            "Writes about one strand of so many, chosen by numbers of their own; above 1 they count as guides, unless "
            "they are widened.");
  v.boolean("widen", c.widen, "Makes strands `every` times as wide, which keeps what they cover.");
  v.boolean("curves", c.curves, "Whether whiskers, lashes and brows are in it.");
  v.name("basis", c.basis, json_names::curve_bases,
         "Straight between points, or Catmull-Rom curves through them; of format `usda` only.");
  v.boolean("skin", c.skin, "Whether the model's mesh lies under the strands; of format `usda` only.");
  v.integer("shells", c.shells, {1, 32}, "Number of layers; of format `shells` only.");
  v.integer("cards", c.cards, {100, 200000}, "Number of cards of the finest level, about; of format `cards` only.");
  v.name("frame", c.frame, json_names::asset_frames,
         "The axes of the places. source: those of the model's file, so that the fur lies on it. pelage: up +y, front "
         "+z.");
  v.number(bare("metres_per_unit"), c.metres_per_unit, metres,
           "Metres of a unit of the model's file, 1 unless given. `usda` says it, GLBs are scaled by it.");
}

template <class V>
void members(V& v, Visited<V, Revisions>& c) {
  v.type("Revisions", "Two revisions to compare.");
  v.counter(required("from"), c.from, "The one revision, of this model.");
  v.counter(required("to"), c.to, "The other revision, of this model.");
}

template <class V>
void members(V& v, Visited<V, AtRevision>& c) {
  v.type("AtRevision", "A revision of the scene.");
  v.counter("revision", c.revision, "Revision to look at, one of this model; the present one when it is not given.");
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
         "names for the server. Linear with the primaries of Rec. 709 when absent.");
}

/// Visits the members that map requests and map uploads have in common.
template <class V, class Map>
void map_members(V& v, Map& c, const char* scale_words) {
  v.name(required("field"), c.field, json_names::fields, "Field that is drawn or read.");
  v.text(sparse("coat"), c.coat,
         "Name of the coat whose field it is; unless given the first is drawn, or all are changed.");
  v.name("encoding", c.encoding, json_names::map_encodings);
  v.number("scale", c.scale, width_in_units, scale_words);
  v.name("units", c.units, json_names::units, "Unit of a scale of lengths.");
}

template <class V>
void members(V& v, Visited<V, MapRequest>& c) {
  v.type("MapRequest", "How a field is drawn as a picture.");
  map_members(
      v, c,
      "What 1 in the picture stands for, in the field's unit; of fast_fur the width, of vector the length. Unless "
      "given the field's largest value for PNG, else 1.");
  v.name(
      "format", c.format, json_names::map_formats,
      "Format of the file: 8 or 16 bits, an EXR of floats or halfs, or a NumPy array of floats: [size, size] or [size, "
      "size, channels], rows from the top; of `vertices` [vertices] or [vertices, channels], without size and dilate.");
  v.integer("size", c.size, {1, limits::map_pixels, "pixels"},
            "Width and height. Above 4096 one map is made at a time.");
  v.integer("dilate", c.dilate, {0, limits::map_dilation, "pixels"}, "How far islands grow over their seams.");
  v.integer("tile", c.tile, {0, last_udim}, "UDIM tile to draw, from 1001; 0: all of them over one another.");
}

template <class V>
void members(V& v, Visited<V, MapUpload>& c) {
  v.type("MapUpload", "How a picture is read as a field.");
  map_members(v, c,
              "What 1 in the picture stands for. With neither it nor `units`: what the file says of itself, else 1.");
  v.number("strength", c.strength, share, "How far the field goes to the picture's.");
  v.integer("tile", c.tile, {0, last_udim},
            "UDIM tile that the picture is of, from 1001: only vertices that lie in it change. 0: the picture repeats, "
            "and all do.");
}

template <class V>
void members(V& v, Visited<V, GuideUpload>& c) {
  v.type("GuideUpload", "How guide curves are read, and how far fur follows them.");
  v.name(required("format"), c.format, json_names::guide_formats, "Format of the file.");
  v.text(sparse("coat"), c.coat, "Name of the coat that follows them; all unless given.");
  v.integer(
      "keys", c.keys, {1, limits::keys},
      "Curves that are used at most, chosen evenly by their order; fewer where the model has so many vertices that "
      "they would be too much work.");
  v.number("sigma", c.sigma, {1e-6, 1e6, "sizes"},
           "Width of the Gaussians that spread them; from the distance between roots unless given.");
  v.number("strength", c.strength, share, "0 does nothing, 1 all.");
  v.name(
      bare("frame"), c.frame, json_names::asset_frames,
      "As of an export. Where it is not given: source for `usda` and `hair`, pelage for `json`. A `usda` with another "
      "upAxis is turned.");
  v.number(
      bare("metres_per_unit"), c.metres_per_unit, metres,
      "Metres of a unit of the model's file; 1 of glTF. Where it is known, a `usda` is scaled by its metersPerUnit.");
}

}  // namespace pelage::json_parts
