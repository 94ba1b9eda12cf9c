// JSON members of commands that change settings, and of the settings of a scene.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/commands/settings.h"
#include "protocol/json/members_answers.h"
#include "protocol/json/members_look.h"
#include "protocol/json/members_tools.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, SetCoat>& c) {
  v.type("SetCoat", "Sets how the strands of a coat are made: their form, colours and markings.");
  v.object(required("coat"), c.coat, "The new coat.");
  v.text(sparse("name"), c.name, "Name of the coat; the first one of the scene unless given.");
}

template <class V>
void members(V& v, Visited<V, CoatBeginning>& c) {
  v.type("CoatBeginning", "First fields of a new coat, copied from another coat.");
  v.text(sparse("from"), c.from, "Name of the other coat; the first of the scene unless given.");
  v.name("region", c.region, json_names::coat_regions);
  v.number("length", c.length, {0.01, 100, "factor"}, "Factor on the other coat's lengths.");
}

template <class V>
void members(V& v, Visited<V, CoatEntry>& c) {
  v.type("CoatEntry",
         "A coat in `set_coats`. It is new if the scene has none with its id or, without an id, with its name.");
  v.label(required("name"), c.name, "Name of the coat. Names differ.");
  v.counter("id", c.id, "Permanent number of the coat, 0 to 7. A new coat gets the lowest free one unless given.");
  v.boolean("muted", c.muted, "Whether the coat is left out: not drawn, exported or changed by tools.");
  v.object(
      "coat", c.coat,
      "How its strands are made; unchanged unless given, and for a new coat those of the coat that it begins from.");
  v.object("begins", c.begins, "First fields of a new coat; refused for one that exists.");
}

template <class V>
void members(V& v, Visited<V, SetCoats>& c) {
  v.type("SetCoats",
         "Sets all coats of the scene in their order: makes, renames, mutes and orders them, and removes those that "
         "are left out, with their fields. Each has its own strands and fields; `bare` and `mask` are shared. A coat's "
         "region is where its density is above 0. At least one is not muted.");
  v.objects(required("coats"), c.coats, {1, limits::coats}, "All coats of the scene.");
}

template <class V>
void members(V& v, Visited<V, NamedCoat>& c) {
  v.answer("NamedCoat", "A coat of the scene.");
  v.text("name", c.name, "Name of the coat.");
  v.counter("id", c.id, "Permanent number of the coat.");
  v.boolean("muted", c.muted, "Whether the coat is left out.");
  v.object("coat", c.coat, "How its strands are made.");
}

template <class V>
void members(V& v, Visited<V, SetLook>& c) {
  v.type("SetLook", "Sets how fur is shaded.");
  v.object(required("look"), c.look, "The new look.");
}

template <class V>
void members(V& v, Visited<V, SetLights>& c) {
  v.type("SetLights", "Sets all lights of the scene; with an empty list only the environment lights it.");
  v.objects(required("lights"), c.lights, {0, limits::lights}, "All lights of the scene.");
}

template <class V>
void members(V& v, Visited<V, SetEnvironment>& c) {
  v.type("SetEnvironment", "Sets the light from all around.");
  v.object(required("environment"), c.environment, "The new light from all around.");
}

template <class V>
void members(V& v, Visited<V, SetGround>& c) {
  v.type("SetGround", "Sets a ground that catches shadows.");
  v.object(required("ground"), c.ground, "The new ground.");
}

template <class V>
void members(V& v, Visited<V, SetWind>& c) {
  v.type("SetWind", "Sets the wind that moves the fur, and the time of the scene.");
  v.object(required("wind"), c.wind, "The new wind.");
}

template <class V>
void members(V& v, Visited<V, SetEyes>& c) {
  v.type("SetEyes", "Sets all eyes of the scene; an empty list removes them. A new creature has two.");
  v.objects(required("eyes"), c.eyes, {0, limits::eyes}, "All eyes of the scene.");
}

template <class V>
void members(V& v, Visited<V, SetCurves>& c) {
  v.type("SetCurves",
         "Sets all whiskers, lashes and brows of the scene; an empty list removes them. At most 4096 curves, including "
         "filled ones. A new creature has some.");
  v.objects(required("groups"), c.groups, {0, limits::curve_groups}, "All groups of curves of the scene.");
}

template <class V>
void members(V& v, Visited<V, SetSkin>& c) {
  v.type("SetSkin",
         "Sets all regions of bare skin; an empty list removes them. A new creature has a nose, lips, ears and pads.");
  v.objects(required("regions"), c.regions, {0, limits::skin_regions}, "All regions of bare skin.");
}

template <class V>
void members(V& v, Visited<V, SetSkinTexture>& c) {
  v.type("SetSkinTexture",
         "Lays a picture on the model by its texture coordinates, in place of the model's own colours. `picture` is "
         "the name that an upload to `skin_texture` writes to the log, made from the pixels alone; a picture that no "
         "scene of this server has used is refused. `own` removes it.");
  v.picture(required("picture"), c.picture, "Name of an uploaded picture, or `own` for the model's own colours.",
            "own");
}

template <class V>
void members(V& v, Visited<V, NamedBlower>& c) {
  v.type("NamedBlower", "A blower: a wind that the scene keeps under a name.");
  v.label(required("name"), c.name, "Name by which `blow` uses it.");
  wind_members(v, c.blow, "source");
}

template <class V>
void members(V& v, Visited<V, NamedAttractor>& c) {
  v.type("NamedAttractor", "An attractor: a stick that the scene keeps under a name.");
  v.label(required("name"), c.name, "Name by which `attract` uses it.");
  stick_members(v, c.attract, "point");
}

template <class V>
void members(V& v, Visited<V, SetBlowers>& c) {
  v.type("SetBlowers", "Sets all blowers, which `blow` uses by their names; names differ.");
  v.objects(required("blowers"), c.blowers, {0, limits::blowers}, "All blowers of the scene.");
}

template <class V>
void members(V& v, Visited<V, SetAttractors>& c) {
  v.type("SetAttractors", "Sets all attractors, which `attract` uses by their names; names differ.");
  v.objects(required("attractors"), c.attractors, {0, limits::blowers}, "All attractors of the scene.");
}

template <class V>
void members(V& v, Visited<V, SetSymmetry>& c) {
  v.type("SetSymmetry",
         "From now on each tool with a position also works at its images, as one undo step. Images move to the nearest "
         "point of the surface, so a roughly symmetric model will do. Floods have no images.");
  v.object(required("symmetry"), c.symmetry, "The new symmetry; none with empty `planes` and a `count` of 1.");
}

template <class V>
void members(V& v, Visited<V, Checkpoint>& c) {
  v.type("Checkpoint", "Names this revision or an earlier one; an existing name moves.");
  v.label(required("name"), c.name, "Name of the checkpoint.");
  v.counter("revision", c.revision, "Revision that gets the name; the one that this command makes unless given.");
}

template <class V>
void members(V& v, Visited<V, ChangeEditLayer>& c) {
  v.type("ChangeEditLayer",
         "Makes, sets, moves, merges or removes an edit layer. The visible fields are the groom below plus, from the "
         "lowest layer up, weight times each layer's edits, clamped to the field's range. At most 14. merge_down needs "
         "layers that are not muted; the layer that is merged into gets weight 1.");
  v.name("action", c.action, json_names::edit_layer_actions, "What is done with the edit layer.");
  v.label(required("name"), c.name, "Name of the edit layer.");
  const bool add = c.action == EditLayerAction::add, set = c.action == EditLayerAction::set;
  if (v.takes(add || set)) {
    v.number("weight", c.weight, edit_layer_weight,
             "Weight of the edit layer, for add and set; for add 1 unless given. Below 0 its edits act in reverse. "
             "Tools change only edit layers of at least .05 or at most -.05.");
    v.boolean("muted", c.muted, "Whether the edit layer is left out, for add and set.");
  }
  if (v.takes(add)) v.text("coat", c.coat, "The only coat whose edits it holds, for add; all unless given.");
  if (v.takes(set)) v.text(sparse("rename"), c.rename, "The new name, for set.");
  if (v.takes(add || c.action == EditLayerAction::move)) {
    v.text("above", c.above,
           "Edit layer right below it, or \"\" for none. For add, where it is on top unless given, and move, where it "
           "is required.");
  }
}

template <class V>
void members(V& v, Visited<V, NamedRevision>& c) {
  v.answer("NamedRevision", "A revision that has a name.");
  v.text("name", c.name, "Name of the checkpoint.");
  v.counter("revision", c.revision, "Revision that has the name.");
}

template <class V>
void members(V& v, Visited<V, SettingsAnswer>& c) {
  v.answer(
      "Settings",
      "What a scene holds beside its fields and its log. Each member is as the command that sets it takes it, with "
      "all defaults; a member that is optional there is absent where it is not set.");
  v.counter("revision", c.revision, "Revision whose settings these are.");
  v.objects("coats", c.settings.coats, {1, limits::coats}, "Set by set_coats and set_coat.");
  v.object("look", c.settings.look, "Set by set_look.");
  v.objects("lights", c.settings.lights, {0, limits::lights}, "Set by set_lights.");
  v.object("environment", c.settings.environment, "Set by set_environment.");
  v.object("ground", c.settings.ground, "Set by set_ground.");
  v.object("wind", c.settings.wind, "Set by set_wind.");
  v.objects("eyes", c.settings.eyes, {0, limits::eyes}, "Set by set_eyes.");
  v.objects("curves", c.settings.curves, {0, limits::curve_groups}, "Set by set_curves as `groups`.");
  v.objects("skin", c.settings.skin, {0, limits::skin_regions}, "Set by set_skin as `regions`.");
  v.picture("skin_texture", c.settings.skin_texture, "Set by set_skin_texture as `picture`.", "own");
  v.objects("blowers", c.settings.blowers, {0, limits::blowers}, "Set by set_blowers.");
  v.objects("attractors", c.settings.attractors, {0, limits::blowers}, "Set by set_attractors.");
  v.object("symmetry", c.settings.symmetry, "Set by set_symmetry.");
  v.objects("checkpoints", c.settings.checkpoints, any_count, "Made by checkpoint.");
  v.objects("edit_layers", c.settings.layers, {0, limits::edit_layers}, "Changed by edit_layer, from the lowest.");
}

}  // namespace pelage::json_parts
