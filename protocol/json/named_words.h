// Enumerations that have a schema of their own in the contract. Members that take their words refer to it.
#pragma once

#include "protocol/commands/frame.h"
#include "protocol/commands/map.h"
#include "protocol/commands/scene.h"

namespace pelage::json_parts {

struct NamedWords {
  const char *name = nullptr, *meaning = "";  // null: members list the words themselves
};

template <class E>
inline constexpr NamedWords named_words{};

template <>
inline constexpr NamedWords named_words<Units>{
    "Units",
    "What lengths are in. relative: sizes, fractions of the diagonal of the model's box. world: the model's unit."};

template <>
inline constexpr NamedWords named_words<Tier>{
    "Tier",
    "How well a frame is drawn. draft, interactive and detailed rasterize more and more of the strands that reference "
    "traces."};

template <>
inline constexpr NamedWords named_words<AutoView>{
    "AutoView",
    "A camera that the server places. `front` looks from +Z, `left` from +X: it shows the animal's left. Each frames "
    "the bare model, never the fur."};

template <>
inline constexpr NamedWords named_words<FurPatches>{
    "FurPatches",
    "How the sample tile of fur is laid on the surface, once: patches with soft overlaps; the same with hard borders, "
    "where nothing is drawn twice; or by the model's own texture coordinates, which of the built-in models "
    "torus, knot, plane and cloth have."};

template <>
inline constexpr NamedWords named_words<MapEncoding>{
    "MapEncoding",
    "What the pixels hold. value: a number, or a colour and its cover. uv_tangent: direction along +u and +v in red "
    "and green, .5 is 0. fast_fur: the same, with width in blue and density in alpha. vector: direction and length as "
    "one vector of floats, along +u, +v and the normal. automatic: uv_tangent of direction, else value."};

template <>
inline constexpr NamedWords named_words<CoatRegion>{
    "CoatRegion",
    "Where a new coat grows. all: wherever the other coat does. none: nowhere yet; paint its density. mask: as far as "
    "the mask allows, with its soft borders."};

template <>
inline constexpr NamedWords named_words<Field>{
    "Field",
    "A field on the surface. direction: where fur leans, its length is the inclination. length: sizes. density, bare "
    "and mask: shares. width: of the coat's, at most 4. curl, clump and wetness: added to the coat's. root_colour and "
    "tip_colour: linear colour and how much it covers."};

template <>
inline constexpr NamedWords named_words<Aov>{
    "Aov",
    "An AOV (arbitrary output variable) of a frame. All but beauty and alpha leave out the ground.\n"
    "Beauty, albedo and direct are multiplied by alpha; position, normal, tangent and shadow are means over what "
    "covers the pixel.\n"
    "depth: distance along the view of what first brings the opacity over half (skin, fur, eyes, hairs and curves), in "
    "the model's unit; infinity where there is none.\n"
    "position: the model's own coordinates. normal: of the skin below, of an eye's ball and cornea. tangent: of fur, "
    "hairs and curves, from root to tip; 0 on bare skin and eyes.\n"
    "direct: what lights add, without the ambient part. shadow: share of that light that shadows leave, 1 where none "
    "comes and on eyes, which take no shadow.\n"
    "sample_count: segments of strands that were blended in the pixel; of traced strands the samples that were "
    "taken.\n"
    "strand: the one that covers most of the pixel: its number from 1 on, the same in all frames of a revision; where "
    "on it, from 0 at its root to 1 at its tip; and the number of its coat plus 1, or 9 for curves such as whiskers. 0 "
    "where skin, eyes or nothing shows more. root: where that strand stands, in the model's own coordinates. Both of "
    "rasterized strands only.\n"};

}  // namespace pelage::json_parts
