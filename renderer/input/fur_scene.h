// The renderer's input: plain views of arrays, which it does not store, in internal coordinates (the box's diagonal is
// 1).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "base/limits.h"
#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/look.h"

namespace pelage {

/// A value for each coat of a frame, in the frame's order. A single value stands for a frame of one coat.
template <class T>
class EachCoat : public std::span<const T> {
 public:
  EachCoat(const T& only) : std::span<const T>(&only, 1) {}
  EachCoat(const std::vector<T>& all) : std::span<const T>(all) {}
};

struct ImageView {
  int width = 0, height = 0;
  std::span<const std::uint8_t> rgba;  // sRGB, straight alpha, rows from the top
};

/// The attributes of a corner of a fur triangle that its vertex does not have.
struct FurCorner {
  glm::vec2 tile_uv{0};    // position on the sample tile, sizes
  glm::vec3 tile_axis{0};  // the tile's u axis in space, unit
  glm::vec2 image_uv{0};   // v up
  glm::vec3 colour{1};     // linear
  int image = -1;          // index of the base-colour image, -1 for none
  glm::vec3 normal{0};     // shading normal, unit; 0 for the vertex's
  float weight = 1;        // [0, 1], share of the fur's optical depth; over all copies of a triangle they sum to 1
};

/// Constant for a model with its colours. `id` is the key of its GPU copy. `original` is common to all copies of a
/// model that differ in colours, and is used to drop all of them; 0 stands for `id`. A triangle of the
/// surface is listed once for each patch of fur that covers it.
struct FurModel {
  std::uint64_t id = 0;
  std::span<const glm::vec3> positions, normals, tangents;  // for each vertex
  std::span<const glm::uvec3> triangles;
  std::span<const std::array<FurCorner, 3>> corners;  // for each triangle
  std::span<const ImageView> images;
  bool has_colours = false;  // corners have colours or an image
  std::uint64_t original = 0;
  // For each vertex, its position and normal in the pose in which the coat was made: patterns, variation and tufts
  // depend on them. Empty: the current ones.
  std::span<const glm::vec3> rest_positions = {}, rest_normals = {};
};

/// Half-open range of vertices whose fields changed since the last call for this model.
struct DirtyRange {
  std::uint32_t begin = 0, end = 0;
};

/// A region of bare skin. Its look is defined by the command.
struct FurSkinRegion {
  glm::dvec3 centre{0};
  glm::dmat3 to_unit{1};       // from a position relative to the centre to the space where the region is the unit ball
  double softness = 0.5;       // distance beyond the region over which fur reaches its full length, radii
  glm::dvec3 facing{0, 0, 1};  // unit
  double cosine_full = -2, cosine_none = -3;  // to the normal: full above the first, none below the second
  glm::vec3 colour{1};                        // linear
  double shine = 0.5, roughness = 0.5, wetness = 0, scatter = 0;
  SkinBumps bumps;

  bool operator==(const FurSkinRegion&) const = default;
};

/// Painted fields at each vertex (protocol/commands/field.h). Empty where a field has its default everywhere.
struct FurPaint {
  std::span<const float> density, width, curl, clump, wetness, bare, mask;
  std::span<const glm::vec4> root_colour, tip_colour;  // linear colour, cover
};

/// The fields of a coat. Fields that all coats share are repeated in each.
struct FurFields {
  std::span<const glm::vec2> direction;  // for each vertex, in (tangent, bitangent); length is the inclination [0, 1]
  std::span<const float> length;         // sizes
  std::span<const DirtyRange> dirty;
  std::span<const FurSkinRegion> skin = {};  // at most 64 regions; fur is shorter there
  FurPaint paint = {};
  std::span<const glm::vec2> closing = {};  // `direction` when the shutter of traced strands closes; empty: the same
  std::span<const glm::vec2> still = {};    // `direction` before wind or body moved it; empty: nothing did
  CoatId coat = 0;
};

struct FurLight {
  LightKind kind = LightKind::directional;
  glm::vec3 direction{0, -1, 0};  // direction of travel, unit
  glm::vec3 position{0};
  glm::vec3 radiance{1};          // colour times intensity
  float cone = 0, soft_cone = 0;  // of a spot or area: cosines of the half angle and of where it begins to fade
  float angle = 0;                // half angle of a directional light, radians
  float radius = 0;               // radius of a point or spot light, sizes
  glm::vec2 extent{0};            // width and height of an area light, sizes
  bool self_shadow_maps = false;
  CastShadow cast_shadow = CastShadow::none;
  float shadow_scale = 10;

  bool operator==(const FurLight&) const = default;
};

/// Lids around an eye: a sphere with an almond-shaped opening (Lids in protocol/commands/creature.h).
struct FurLids {
  glm::mat3 frame{1};    // right, up and the direction to the middle of the opening; orthonormal
  glm::vec3 opening{1};  // angles to a corner, to the upper and to the lower lid, radians
  glm::vec3 colour{0};   // linear

  bool operator==(const FurLids&) const = default;
};

/// An eye. Iris and pupil are defined by the command; their lengths are in radii of the eye.
struct FurEye {
  glm::vec3 position{0};
  float radius = 0.02f;  // above 0
  glm::mat3 frame{1};    // right, up and view direction; orthonormal
  Iris iris;
  Pupil pupil;
  std::optional<FurLids> lids;
  glm::vec3 sclera{1};  // linear
  double bulge = 0.5, refraction = 1.376, wetness = 1;

  bool operator==(const FurEye&) const = default;
};

/// A guide curve.
struct FurGuide {
  std::vector<glm::dvec3> points;  // at least 2, root first
  glm::dvec3 normal{0, 1, 0};      // of the skin at the root, unit

  bool operator==(const FurGuide&) const = default;
};

/// Curves of one kind, as in CurveGroup (protocol/commands/creature.h).
struct FurCurves {
  std::vector<FurGuide> guides;
  double width_root = 0, width_tip = 0;     // sizes
  glm::vec3 root_colour{1}, tip_colour{1};  // linear
  int fill = 0;
  double spread = 0;
  std::uint32_t seed = 1;

  bool operator==(const FurCurves&) const = default;
};

struct FurCamera {
  glm::vec3 position{0, 0, 1}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};  // unit and orthogonal
  float tan_half_fov = 0.3f;                                                    // vertical

  bool operator==(const FurCamera&) const = default;
};

/// A horizontal plane that receives the shadow of the model, sizes.
struct FurGround {
  float height = 0;
  float shadow = 0, contact = 0;  // [0, 1]

  bool operator==(const FurGround&) const = default;
};

/// Object numbers in pictures: skin, eyes, curves, and the coats of a frame in their order.
inline constexpr std::size_t skin_object = 0, eyes_object = 1, curves_object = 2, first_coat_object = 3,
                             max_objects = first_coat_object + limits::coats;
/// Returns the first of the three objects that a part of cryptomatte shows as red, green and blue; 0 for other AOVs.
constexpr std::size_t first_object(Aov aov) {
  return aov > Aov::objects_1 ? 3 * (static_cast<std::size_t>(aov) - static_cast<std::size_t>(Aov::objects_1)) : 0;
}

/// All inputs of a frame besides the model. They are copied, so that the scene may change while the frame is drawn.
struct FurFrame {
  std::uint64_t model = 0;          // FurModel::id at the last sync
  std::vector<NamedCoat> coats{1};  // coats to draw, at least one
  Look look;
  std::vector<FurLight> lights;  // at most 8
  Environment environment;
  std::optional<FurGround> ground;
  std::vector<FurEye> eyes;         // at most 8
  std::vector<FurCurves> curves;    // at most 16, and 4096 curves in all
  std::vector<FurSkinRegion> skin;  // at most 64, those of the last sync
  FurCamera camera;
  int width = 0, height = 0;
  std::optional<Crop> crop = {};  // pixels to draw; the resulting picture has their size
  Knobs knobs;
  Background background = Background::colour;
  glm::vec3 background_colour{0};  // linear
  double exposure = 0;             // stops
  ToneMap tone_map = ToneMap::filmic;
  Overlay overlay = Overlay::none;
  std::size_t overlay_coat = 0;   // index of the coat whose field the overlay shows
  std::vector<float> difference;  // for each vertex, [0, 1], 0 for none; shown by Overlay::difference

  /// Returns the first coat.
  Coat& coat() { return coats.front().coat; }
  const Coat& coat() const { return coats.front().coat; }
  /// Returns the wetness of the driest coat, [0, 1], by which the look is changed. For wetter coats the rest is treated
  /// as painted wetness.
  double wetness() const {
    double min_wetness = 1;
    for (const NamedCoat& one : coats) min_wetness = std::min(min_wetness, one.coat.wetness);
    return min_wetness;
  }

  bool operator==(const FurFrame&) const = default;
};

}  // namespace pelage
