// Commands that set what is about a model, on the wire.
#pragma once

#include "protocol/commands/command.h"
#include "protocol/json/members_body.h"
#include "protocol/json/members_coat.h"
#include "protocol/json/members_look.h"
#include "protocol/json/members_tools.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, SetCoat>& c) {
  v.type("SetCoat");
  v.object(required("coat"), c.coat);
}

template <class V>
void members(V& v, Visited<V, SetLook>& c) {
  v.type("SetLook");
  v.object(required("look"), c.look);
}

template <class V>
void members(V& v, Visited<V, SetLights>& c) {
  v.type("SetLights");
  v.objects(required("lights"), c.lights, {0, limits::lights});
}

template <class V>
void members(V& v, Visited<V, SetEnvironment>& c) {
  v.type("SetEnvironment");
  v.object(required("environment"), c.environment);
}

template <class V>
void members(V& v, Visited<V, SetGround>& c) {
  v.type("SetGround");
  v.object(required("ground"), c.ground);
}

template <class V>
void members(V& v, Visited<V, SetEyes>& c) {
  v.type("SetEyes", "Places all eyes of the scene; an empty list takes them away. A new creature has two.");
  v.objects(required("eyes"), c.eyes, {0, limits::eyes});
}

template <class V>
void members(V& v, Visited<V, SetCurves>& c) {
  v.type(
      "SetCurves",
      "Places all whiskers, lashes and brows of the scene; an empty list takes them away. At most 4096 curves in all, "
      "filled ones too. A new creature has some.");
  v.objects(required("groups"), c.groups, {0, limits::curve_groups});
}

template <class V>
void members(V& v, Visited<V, SetSkin>& c) {
  v.type("SetSkin",
         "Places all regions of bare skin; an empty list takes them away. A new creature has a nose, lips, ears and "
         "pads.");
  v.objects(required("regions"), c.regions, {0, limits::skin_regions});
}

template <class V>
void members(V& v, Visited<V, SetSkinTexture>& c) {
  v.type("SetSkinTexture",
         "Lays a picture on the model by its texture coordinates, in place of all colours of its own. `picture` is the "
         "name that the log has after an upload to `skin_texture`, made from the pixels alone; a picture that no scene "
         "of this server has used is refused. `own` takes it off again.");
  v.picture(required("picture"), c.picture, "", "own");
}

}  // namespace pelage::json_parts
