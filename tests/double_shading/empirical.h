// The models that are formulas and not fibres: GPU fur eq 1, Kajiya-Kay 1989 and Scheuermann 2004 (science.md 4).
// Directions are unit and point away from the strand, the tangent from root to tip.
#pragma once

#include <glm/glm.hpp>

#include "protocol/commands/look.h"

namespace pelage {

/// Directions at a shaded point of a strand; all of unit length.
struct ScatterGeometry {
  glm::dvec3 tangent;
  glm::dvec3 normal;  // of the surface under the fur
  glm::dvec3 to_light;
  glm::dvec3 to_camera;
};

/// Returns (1 - d^2)^(n/2): the sine of the angle whose cosine is `d`, to the power `n` >= 0. Computed as the
/// exponential of a log1p, since pow(sqrt(1 - d^2), n) is off by 4e-2 in float at n = 1e6. |d| >= 1 counts as 1; 0^0 is
/// 1.
double sine_power(double d, double n);
float sine_power(float d, float n);

/// Half way between light and view, unit; zero where they are opposite.
glm::dvec3 halfway(const ScatterGeometry& geometry);

/// GPU fur eq 1 without ambient, t and B: kd C (1-(T.L)^2)^(pd/2) + ks (1-(T.H)^2)^(ps/2).
glm::dvec3 scatter_kajiya(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour);

/// Kajiya and Kay 1989: kd C sin(T,L) + ks max(0, sin(T,L) sin(T,E) - T.L T.E)^ps.
glm::dvec3 scatter_kajiya_kay(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour);

/// One lobe of Scheuermann 2004 at `along` = T'.H: smoothstep(-1, 0, along) (1 - along^2)^(n/2).
double scheuermann_lobe(double along, double n);

/// Scheuermann 2004: kd C saturate(lerp(.25, 1, N.L)), a white lobe about T shifted by `primary_shift` and one of
/// colour C shifted by `secondary_shift`. `strand` in [0, 1] is the strand's random number; it shifts both lobes by up
/// to `shift_spread`.
glm::dvec3 scatter_scheuermann(const Look& look, const ScatterGeometry& geometry, const glm::dvec3& colour,
                               double strand);

/// B of GPU fur eq 1 for a light whose direction has the cosine `facing` to the normal: 1 in front, falling to 0 over
/// `reach` in (0, 1] behind. Always 1 for models that handle light from behind themselves.
double backlight_fade(ShadingModel model, double facing, double reach);

}  // namespace pelage
