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
  v.type("Tracing",
         "How strands are traced. The same seed and number of passes give the same picture. Tracing ends at the first "
         "of `passes`, `noise` and `seconds`. Refused with 413 where strands and picture need more memory than the "
         "server allows.");
  v.integer("passes", c.passes, {1, limits::trace_passes},
            "Largest number of passes. A pass adds a sample to each pixel that still needs some.");
  v.name("transport", c.transport, json_names::transports,
         "How light travels through fur. transmittance: attenuated by the strands in its path. paths: path tracing, "
         "from strand to strand.");
  v.name("scattering", c.scattering, json_names::strand_scatterings,
         "Shading model of strands: that of the look, or energy_conserving whatever the look says. With `paths` only "
         "energy_conserving.");
  if (v.shows(c.transport == Transport::paths))
    v.integer("bounces", c.bounces, {1, 4096}, "Largest number of bounces of a path; with `paths` only.");
  v.integer("strands", c.strands, {1, limits::strands},
            "Largest number of strands; fewer are drawn wider, so that they cover as much.");
  v.number("noise", c.noise, share,
           "Ends when the estimated mean error of a displayed channel is below this; tiles below it get no more "
           "samples. 0: never.");
  v.number("seconds", c.seconds, {0, 3600, "seconds"}, "Ends after this time; 0: never.");
  v.number("shutter", c.shutter, {0, 10, "seconds"},
           "Exposure time, centred on the frame's time: fur that the wind moves is blurred. Strands move straight from "
           "their first position to their last. 0: no blur.");
  v.boolean("filter", c.filter, "Whether pictures of few passes are denoised, guided by direction, depth and colour.");
  v.seed("seed", c.seed, "Other seeds give other noise.");
}

template <class V>
void members(V& v, Visited<V, Rasterizing>& c) {
  v.type("Rasterizing", "The choice of strands that are rasterized, and how they are lit.");
  v.number("strands", c.strands, {0.01, 1000, "strands"},
           "Strands to draw for each pixel of skin seen from above. Fewer are drawn wider to cover as much, up to 1.5 "
           "pixels (below .67: up to 2). 1000 draws all. All coats together grow at most about 2000000, fewer and "
           "wider ones if they have more; at .5 or less only a third of them where that is enough.");
  v.integer("light_of", c.light_of, {1, 8},
            "Number of neighbouring strands that share the light of one. More is faster and smoother.");
}

template <class V>
void members(V& v, Visited<V, Layering>& c) {
  v.type("Layering", "How fur is drawn as shells, after the papers on GPU fur.");
  v.integer("count", c.count, {1, limits::shells}, "Number of shells where the view needs the most.");
  v.name("policy", c.policy, json_names::shell_policies,
         "How shells are chosen. adaptive: fewer where fur is seen from above or is small in the picture.");
  v.boolean("self_shadow", c.self_shadow, "Whether fur shades itself.");
  v.boolean("shadow_maps", c.shadow_maps, "Whether shadows that lights ask for are drawn from maps.");
  v.integer("shadow_resolution", c.shadow_resolution, {1, 4096, "texels"}, "Texels along the side of a shadow map.");
  v.name("order", c.order, json_names::fragment_orders,
         "Order in which fur is blended. four_pass: skin, depth of dense fur, back-facing fur, front-facing fur. "
         "sorted: all fragments of a pixel by depth; exact and slow, for reference pictures of at most 1073741824 "
         "drawn pixels x shells.");
}

template <class V>
void members(V& v, Visited<V, Knobs>& c) {
  v.type("Knobs", "Settings that a frame is drawn with. Defaults are those of the tier interactive.");
  v.name("method", c.method, json_names::methods,
         "How fur is drawn. raster: the coat's strands, or an even share of them, rasterized. strands: all of them, as "
         "far as `trace` allows, ray traced. shells: fur as shells over the skin, with a GL (422 where the server has "
         "none), without eyes, curves, ground and overlays; its AOVs are beauty and alpha.");
  if (v.shows(c.method != Method::strands))
    v.number("scale", c.scale, {0.25, 2, "factor"},
             "Rendered size over requested size. Times width and height at most 8192; the tier detailed has 2.");
  if (v.shows(c.method != Method::shells))
    v.integer(
        "eye_steps", c.eye_steps, {0, 64},
        "How the iris is drawn. 0: a flat disc. 1: refracted, at its depth. More: steps of a ray march through it.");
  if (v.shows(c.method == Method::raster))
    v.object("raster", c.raster, "How strands are rasterized; with method raster only.");
  if (v.shows(c.method == Method::strands))
    v.object("trace", c.trace, "How strands are traced; with method strands only.");
  if (v.shows(c.method == Method::shells))
    v.object("shells", c.shells, "How shells are drawn; with method shells only.");
}

template <class V>
void members(V& v, Visited<V, Crop>& c) {
  v.type("Crop", "A part of a frame.");
  v.integer("left", c.left, {0, limits::frame_pixels - 1, "pixels"},
            "Pixels between the frame's left edge and the part.");
  v.integer("top", c.top, {0, limits::frame_pixels - 1, "pixels"}, "Pixels between the frame's top edge and the part.");
  v.integer(required("width"), c.width, pixels, "Width of the part, which ends inside the frame.");
  v.integer(required("height"), c.height, pixels, "Height of the part, which ends inside the frame.");
}

/// Visits the members that say in what file the picture comes.
template <class V>
void file_members(V& v, Visited<V, FrameRequest>& c) {
  v.name("format", c.format, json_names::frame_formats,
         "Format of the picture. png and png16: 8 and 16 bit sRGB. jpeg: without alpha. webp: lossy like jpeg, half as "
         "large, ten times slower to make, with alpha. exr: linear light without exposure, tone map and background, "
         "premultiplied by alpha. npy: the pixels of png as a NumPy array of bytes [height, width, 4]. npy_linear: the "
         "channels of a float exr as a NumPy array [height, width, channels].");
  v.integer("lossy_quality", c.lossy_quality, {0, 100},
            "Quality of jpeg and webp, 1 to 100. 0 follows the frame's quality: 80 for a draft, 88 for an interactive "
            "frame, 94 for better ones.");
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
}

template <class V>
void members(V& v, Visited<V, FrameRequest>& c) {
  v.type("FrameRequest", "A picture to draw. What is not given takes its default.");
  v.integer("width", c.width, pixels, "Width of the picture.");
  v.integer("height", c.height, pixels, "Height of the picture.");
  v.object("crop", c.crop,
           "Draws only this part of the frame, with the same pixels as in the whole frame. The picture has the part's "
           "size; an EXR's display window is the whole frame. `budget_ms` is for the whole frame.");
  v.object("camera", c.camera, "Camera of the frame.");
  if (v.shows(!c.plans())) v.special("quality", c.knobs, "A tier, or single knobs.");
  v.number("budget_ms", c.budget_ms, budget_ms,
           "Drawing time, in place of `quality`: takes the knobs with the least estimated error (that 95% of frames "
           "keep) within the budget; 95% of frames take at most 1.25 times it. It is the time that passes on this "
           "machine while the frame is drawn, without waiting for other frames, reading, encoding, and growing strands "
           "after their coat or model has changed. AOVs other than beauty, and overlays, come on top.");
  v.number("max_error", c.max_error, max_error,
           "Error, in place of `quality`: takes the cheapest knobs with at most this error in 95% of frames. It is the "
           "mean FLIP where there is fur, against the same strands, traced.");
  v.number(
      "max_seconds", c.max_seconds, {1, limits::frame_seconds, "seconds"},
      "Refuses the frame if drawing is expected to take longer (a dry run says), and stops an untraced one that does.");
  v.number("time", c.time, moment,
           "Time of the wind in this frame; the scene's own time unless given. The same time gives the same picture, "
           "whatever was drawn before.");
  v.special("background", Backdrop<V::reads>{c.background, c.background_colour},
            "What is behind the fur. `studio` is a soft gradient with darker corners.");
  v.number("exposure", c.exposure, {-20, 20, "stops"}, "How much brighter the picture is made.");
  v.name("tone_map", c.tone_map, json_names::tone_maps, "How bright light is mapped to the picture's range.");
  v.object("look", c.look, "Look for this frame, in place of the scene's.");
  v.text(sparse("view"), c.view,
         "Name of the viewer, at most 200 bytes. Of several requests with one name only the newest is drawn; the "
         "others get 409.");
  file_members(v, c);
  v.name(
      "overlay", c.overlay, json_names::overlays,
      "Shows a field on the fur; not with exr and npy_linear. density, wetness and mask go from dark violet for 0 to "
      "yellow for 1. difference: change since `overlay_from` in the same colours, of the field that changed most, "
      "relative to 1 for direction and colours, to the longest fur for length, to the field's range for others; grey "
      "where nothing changed. bald: only the skin, in plain grey. wire: the same with the edges of its triangles.");
  v.boolean("masked", c.masked,
            "Draws only triangles with a corner whose mask is above 0.5, and the fur, whiskers and eyes on them. The "
            "rest casts no shadow. The scene stays as it is.");
  v.special("progressive", c.progressive,
            "Answers with rasterized strands at once, then traces the same revision: send the same request again with "
            "`after` and `after_pass` for better pictures, which may skip passes. true takes the defaults of Tracing. "
            "Name the `view`: the traced picture is dropped when the scene changes, the view requests something else, "
            "or no request comes for 30 seconds (2 while other pictures wait). 503 while 16 pictures wait.");
  v.text(sparse("overlay_coat"), c.overlay_coat,
         "Name of the coat whose field an overlay shows; the first that is not muted unless given.");
  v.counter("overlay_from", c.overlay_from,
            "Revision of this model that the overlay `difference` compares with. Only with it.");
  v.counter("revision", c.revision,
            "Revision of the scene to draw, with its model, fields and settings; the present one unless given. Neither "
            "with `progressive` nor with `after`.");
}

}  // namespace pelage::json_parts
