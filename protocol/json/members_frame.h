// JSON members of a frame request.
#pragma once

#include "protocol/commands/frame.h"
#include "protocol/json/members.h"
#include "protocol/json/members_look.h"
#include "protocol/json/members_stroke.h"

namespace pelage::json_parts {

/// The background: a word or a colour.
template <bool reads>
struct Backdrop {
  std::conditional_t<reads, const Background, Background>& kind;
  std::conditional_t<reads, const glm::vec3, glm::vec3>& colour;
};

template <class V>
void members(V& v, Visited<V, Tracing>& c) {
  v.type(
      "Tracing",
      "How strands are traced. The same picture comes from the same seed and the same count of passes. It ends at the "
      "first of `passes`, `noise` and `seconds`. Refused with 413 where the strands and the picture need more memory "
      "than the server gives them.");
  v.integer("passes", c.passes, {1, limits::trace_passes},
            "Largest count of passes. A pass adds a sample to each pixel that still needs some.");
  v.name("transport", c.transport, json_names::transports,
         "How light goes through fur. transmittance: through the strands that it crosses, by their colour and count. "
         "paths: from strand to strand.");
  v.name("scattering", c.scattering, json_names::strand_scatterings,
         "What a strand scatters by: the look's shading, or energy_conserving whatever the look says. Paths scatter "
         "by energy_conserving and refuse `look`.");
  if (v.shows(c.transport == Transport::paths))
    v.integer("bounces", c.bounces, {1, 4096}, "Largest count of bounces of a path; with `paths` only.");
  v.integer("strands", c.strands, {1, limits::strands},
            "Largest count of strands; fewer are drawn wider, so that they cover as much.");
  v.number("noise", c.noise, share,
           "Ends when the estimated mean error of a shown channel is below this, and leaves parts that are; 0 never.");
  v.number("seconds", c.seconds, {0, 3600, "seconds"}, "Ends after as many seconds; 0 never.");
  v.number("shutter", c.shutter, {0, 10, "seconds"},
           "How long the shutter is open, half before the frame's time and half after: fur that the wind moves is "
           "blurred. Strands go straight from where they are first to where they are last; 0 for none.");
  v.boolean("filter", c.filter, "Whether direction, depth and colour guide a filter over pictures of few passes.");
  v.seed("seed", c.seed, "Other seeds give other noise.");
}

template <class V>
void members(V& v, Visited<V, Rasterizing>& c) {
  v.type("Rasterizing", "The choice of strands that are rasterized, and how they are lit.");
  v.number("strands", c.strands, {0.01, 1000, "strands"},
           "Strands that are kept of those that stand on a pixel of skin seen from above; the kept ones are as much "
           "wider, up to 1.5 pixels (of less than .67 up to 2), so that they cover as much. 1000 keeps all. Of a coat "
           "of more "
           "than 2000000 strands as many are drawn. Up to .5 a quarter of the coat grows where no more of it is kept.");
  v.integer("light_of", c.light_of, {1, 8},
            "Neighbouring strands that share the light of one of them. More is faster and smoother.");
}

template <class V>
void members(V& v, Visited<V, Layering>& c) {
  v.type("Layering", "How fur is drawn in layers, as the papers on GPU fur have it.");
  v.integer("count", c.count, {1, limits::shells}, "Number of shells where the view needs most.");
  v.name("policy", c.policy, json_names::shell_policies,
         "How shells are chosen. adaptive: fewer where fur is seen from above or is small on the picture.");
  v.boolean("self_shadow", c.self_shadow, "Whether fur shades itself.");
  v.boolean("shadow_maps", c.shadow_maps, "Whether shadows that lights ask for are drawn from maps.");
  v.integer("shadow_resolution", c.shadow_resolution, {1, 4096, "texels"}, "Texels along the side of a shadow map.");
  v.name(
      "order", c.order, json_names::fragment_orders,
      "Order in which fur is blended. four_pass: the skin, the depth of dense fur, fur that faces away, fur that faces "
      "the camera. `sorted` keeps all fragments of a pixel and sorts them by depth: exact and "
      "slow, for pictures to compare with. It takes at most 1073741824 drawn pixels x shells.");
}

template <class V>
void members(V& v, Visited<V, Knobs>& c) {
  v.type("Knobs", "What a frame is drawn with. What is not given is as in the interactive tier.");
  v.name("method", c.method, json_names::methods,
         "How fur is drawn. raster: the strands of the coat, or an even share of them, rasterized. strands: "
         "every strand of the coat, ray traced. shells: skin and fur alone in layers, by a GL; refused with 422 where "
         "the server has none. It draws no eyes, curves, ground, overlays, and of AOVs beauty and alpha.");
  if (v.shows(c.method != Method::strands))
    v.number("scale", c.scale, {0.25, 2, "factor"},
             "Rendered size over asked size. Times width and height at most 8192; the tier detailed has 2.");
  if (v.shows(c.method != Method::shells))
    v.integer("eye_steps", c.eye_steps, {0, 64},
              "Steps into the iris of each eye: 0 a flat disc, 1 refracted and seen at its depth, more: steps of ray "
              "marching through the iris.");
  if (v.shows(c.method == Method::raster))
    v.object("raster", c.raster, "The choice of strands that are rasterized; with method raster only.");
  if (v.shows(c.method == Method::strands))
    v.object("trace", c.trace, "How strands are traced; with method strands only.");
  if (v.shows(c.method == Method::shells))
    v.object("shells", c.shells, "How fur is drawn in layers; with method shells only.");
}

template <class V>
void members(V& v, Visited<V, Crop>& c) {
  v.type("Crop", "A part of a frame.");
  v.integer("left", c.left, {0, limits::frame_pixels - 1, "pixels"}, "Where the part begins, from the frame's left.");
  v.integer("top", c.top, {0, limits::frame_pixels - 1, "pixels"}, "Where the part begins, from the frame's top.");
  v.integer(required("width"), c.width, pixels, "Width of the part, which ends inside the frame.");
  v.integer(required("height"), c.height, pixels, "Height of the part, which ends inside the frame.");
}

template <class V>
void members(V& v, Visited<V, FrameRequest>& c) {
  v.type("FrameRequest", "A picture to draw. What is not given takes its default.");
  v.integer("width", c.width, pixels, "Width of the picture.");
  v.integer("height", c.height, pixels, "Height of the picture.");
  v.object(
      "crop", c.crop,
      "Part of the frame that is drawn alone. The picture has the part's size, and the pixels that the whole frame "
      "has there; an EXR's display window is the whole frame. `budget_ms` is of the whole frame.");
  v.object("camera", c.camera, "Where the scene is seen from.");
  if (v.shows(!c.plans())) v.special("quality", c.knobs, "A tier, or single knobs.");
  v.number(
      "budget_ms", c.budget_ms, budget_ms,
      "Drawing time, in place of `quality`: takes the knobs whose drawing time keeps to the budget and whose error, as "
      "95% of frames keep it, is estimated least; 95% of frames take at most 1.25 times it. Drawing time is the "
      "milliseconds that pass on this machine while the frame is drawn; waiting for other frames, reading and encoding "
      "are not in it, nor is growing strands after their coat or their model has changed. AOVs of an EXR beside "
      "beauty, and overlays, come on top.");
  v.number("max_error", c.max_error, max_error,
           "Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames: mean FLIP "
           "where there is fur, against the same strands, traced.");
  v.number("max_seconds", c.max_seconds, {1, limits::frame_seconds, "seconds"},
           "Refuses the frame where drawing is expected to take longer; a dry run says how long.");
  v.number("time", c.time, moment,
           "Time that the frame shows: the fur as the scene's wind has moved it by then. The scene's own time unless "
           "given. The same time gives the same picture, whatever was drawn before.");
  v.special("background", Backdrop<V::reads>{c.background, c.background_colour},
            "What is behind the fur. `studio` is a soft gradient with darker corners.");
  v.number("exposure", c.exposure, {-20, 20, "stops"}, "How much brighter the picture is made.");
  v.name("tone_map", c.tone_map, json_names::tone_maps, "How bright light is brought into the picture's range.");
  v.object("look", c.look, "Look for this frame, in place of the scene's.");
  v.text(
      sparse("view"), c.view,
      "Name of the viewer: of several frames asked for one view only the newest is drawn, the others get 409. At most "
      "200 bytes.");
  v.name("format", c.format, json_names::frame_formats,
         "Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy as jpeg, half as "
         "large, ten times slower to make, with alpha. exr: linear light without "
         "exposure, tone map and background, multiplied by alpha. npy: the pixels of png as a NumPy array of bytes "
         "[height, width, 4]. npy_linear: what an exr of floats holds as a NumPy array of floats [height, width, "
         "channels].");
  v.integer(
      "lossy_quality", c.lossy_quality, {0, 100},
      "How much jpeg and webp keep of the picture, from 1 on; of these formats only. 0: as the frame's quality asks, "
      "80 of a draft, 88 of an interactive frame, 94 beyond.");
  v.name("exr_type", c.exr_type, json_names::exr_types,
         "Type of the channels of an EXR. Depth, position, strand, root and cryptomatte are always float.");
  if (v.shows(is_linear(c.format)))
    v.names(
        bare("aovs"), c.aovs, json_names::aovs, 1, "AOV",
        "AOVs (arbitrary output variables) that the file holds, for exr and npy_linear; `[beauty]` when absent. Drawn "
        "pixels times AOVs are at most 67108864, where cryptomatte counts as four. Channels: R, G, B, A of beauty; A "
        "of alpha; Z of depth; AOV.X, .Y, .Z "
        "of position, normal, tangent and root; AOV.R, .G, .B of albedo and direct; AOV.Y of shadow and sample_count; "
        "strand.id, .along and .coat; CryptoObject00 to 02 of cryptomatte, whose manifest names skin, eyes, curves and "
        "coat/NAME of each coat.");
  if (v.shows(is_linear(c.format)))
    v.text(sparse("colour_space"), c.colour_space,
           "Colour space of beauty, albedo and direct, for exr and npy_linear: a name, an alias or a role of the "
           "OpenColorIO configuration that $OCIO names for the server. Linear with the primaries of Rec. 709 when "
           "absent.");
  v.name("overlay", c.overlay, json_names::overlays,
         "Shows a field on the fur. Not in linear light. density, wetness and "
         "mask go from dark violet for 0 to yellow for 1. difference: how much the fields have changed since "
         "`overlay_from`, with the same colours: of the field that changed most, the change over what counts as much "
         "(direction and colours: 1; length: the longest fur; others: the field's range). Grey where nothing changed. "
         "bald and wire hide the frame: the skin in plain grey without its fur, to find places "
         "on it, and the same with the edges of its triangles.");
  v.boolean("masked", c.masked,
            "Draws only triangles with a corner whose mask is above 0.5, their fur, and the whiskers and eyes on them: "
            "what tools may change. The rest casts no shadow. The scene stays as it is.");
  v.special("progressive", c.progressive,
            "Draws rasterized strands at once; all strands of the same revision are then traced while somebody waits "
            "for them with "
            "`after` and `after_pass`. true takes the defaults of Tracing. Pictures may skip passes; answers are to "
            "this same request, sent again. Name the `view`: what is traced is dropped as soon as the scene changes, "
            "the same view asks for something else, or nobody has asked for 30 seconds. Refused with 503 while 16 "
            "pictures wait to be traced.");
  v.text(sparse("overlay_coat"), c.overlay_coat,
         "Name of the coat whose field an overlay shows; the first that is seen unless given.");
  v.counter("overlay_from", c.overlay_from,
            "Revision that the overlay `difference` compares what is drawn with: one of this model. Only with it.");
  v.counter("revision", c.revision,
            "Revision to draw the scene as: its model, fields and settings as they were; the present one when it is "
            "not given. Neither with `progressive` nor with `after`.");
}

}  // namespace pelage::json_parts
