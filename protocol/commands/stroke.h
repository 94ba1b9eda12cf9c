// Where tools work: strokes and the brush that all tools share.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/commands/frame.h"
#include "protocol/commands/symmetry.h"

namespace pelage {

enum class Units { relative, world };                // fractions of the model's size, or the model's unit
enum class RadiusUnits { relative, world, pixels };  // pixels: of the stroke's view, at the depth of the sample

/// How the distance of a vertex from a dab is measured: through space, along the surface (so that parts of the model
/// that are near only in space are not reached), or in the picture plane of the stroke's view.
enum class FalloffShape { volume, surface, screen };
/// What a brush reaches. skin: the skin within its radius, with the fur on it. fur: fur that itself comes within its
/// radius.
enum class Reach { skin, fur };
enum class Falloff { constant, linear, smooth, sharp, sphere };

/// Forms of a position on a stroke: a point in the model's coordinates, a pixel of the stroke's view (origin top left,
/// y down, centres at .5), or a point on a triangle.
struct PositionSample {
  glm::dvec3 position{0};
};
struct ScreenSample {
  glm::dvec2 screen{0};
};
struct SurfaceSample {
  std::uint32_t triangle = 0;
  glm::dvec3 barycentric{1.0 / 3};  // each in [0, 1], sum 1 within 1e-3
};

struct StrokeSample {
  std::variant<PositionSample, ScreenSample, SurfaceSample> position;
  double pressure = 1;  // [0, 1]
  double time = 0;      // seconds, [0, 1e6], never decreasing
};

/// A whole stroke, or a part of one that is still being drawn. Parts with the same `id` join one undo step, and give
/// the same result as the whole stroke.
struct Stroke {
  std::string id;          // "" for a stroke sent whole; at most 200 bytes
  std::uint32_t part = 0;  // 0, 1, 2 ... within an id
  bool last = true;
  std::vector<StrokeSample> samples;  // 1 to 10,000
  std::optional<View> view;           // required by pixel samples, radii in pixels and the screen shape
};

/// The brush settings that all tools share.
struct Brush {
  double radius = 0.05;  // in `units`, [0, 1e6 sizes]
  RadiusUnits units = RadiusUnits::relative;
  FalloffShape falloff_shape = FalloffShape::volume;
  std::optional<Reach> reach = {};  // absent: fur if samples are pixels and the shape is volume, else skin
  Falloff falloff = Falloff::smooth;
  std::vector<double> falloff_points = {};  // 2 to 64 weights [0, 1], middle to rim, that replace `falloff`; or empty
  double strength = 0.8;                    // [0, 1]
  double spacing = 0.25;                    // distance between dabs, in radii, [0.01, 10]
  double pressure_to_radius = 0;            // share of the radius that pressure scales, [0, 1]
  double pressure_to_strength = 1;          // share of the strength that pressure scales, [0, 1]
  bool front_faces_only = true;  // leaves out back faces, as the view or, without one, the dab's normal has it
  double cut_off_degrees = 90;   // angle to the front beyond which faces are back-facing, [0, 180]
  bool invert = false;           // the tool's opposite, where it has one
  double strand_from = 0,
         strand_to = 1;                   // part of the strand that changes, 0 root, 1 tip; for colours only
  std::string alpha = {};                 // name of an uploaded picture that each dab prints; "" for none
  std::optional<Symmetry> symmetry = {};  // absent: the scene's symmetry
};

}  // namespace pelage
