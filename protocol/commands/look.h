// How a groomed model is lit and shaded: part of the scene, set by commands and logged.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pelage {

/// Where the fur takes its colour from. `model` uses the model's texture or vertex colours for hue and the ramp for
/// lightness along the strand; `coat` uses the ramp alone; `automatic` is `model` where the model has colours.
enum class ColourSource { automatic, model, coat };

/// How a strand answers light (science.md 4; renderer/shading). `lengyel` is GPU fur eq 1 by vertex and `kajiya` the
/// same by pixel; `energy_conserving` is d'Eon 2011 with Chiang 2016's parameters; `scheuermann` has a wrapped diffuse
/// term and two shifted lobes; `kajiya_kay` is the model of 1989; `marschner` has R, TT and TRT as in 2003.
enum class ShadingModel { lengyel, kajiya, energy_conserving, scheuermann, kajiya_kay, marschner };

/// Where a fibre's absorption comes from: from the coat's colour, or from the pigments of `FibreOptics`.
enum class Absorption { colour, melanin };

/// What the scattering models need to know about a fibre. `kajiya` and `lengyel` use none of it.
struct FibreOptics {
  double longitudinal_roughness = 0.3;  // beta_m, [0, 1]; energy_conserving
  double azimuthal_roughness = 0.3;     // beta_n, [0, 1]; energy_conserving
  double cuticle_tilt = 2;         // alpha, degrees, [-15, 15]; turns reflected light to the root; both fibre models
  double refractive_index = 1.55;  // eta, [1, 3]; energy_conserving, marschner
  Absorption absorption = Absorption::colour;
  double eumelanin = 0.3;        // concentration, [0, 1e4]; brown and black; with Absorption::melanin
  double pheomelanin = 0;        // concentration, [0, 1e4]; red
  double highlight_width = 7.5;  // beta_R, degrees, [0, 90]; marschner
  double caustic_width = 10;     // spread of TT and TRT around the strand, degrees, [1, 60]; marschner
  double primary_shift = 0.1;    // of the tangent along the normal, [-2, 2]; > 0: highlight nearer the tip; scheuermann
  double secondary_shift = -0.15;   // [-2, 2]; scheuermann
  double shift_spread = 0.1;        // from strand to strand, [0, 2]; scheuermann
  double secondary_specular = 0.3;  // weight of the coloured lobe, [0, 4]; scheuermann
  double secondary_exponent = 12;   // [0, 1e6]; scheuermann

  bool operator==(const FibreOptics&) const = default;
};

/// Weights of GPU fur eq 1 and what goes with them.
struct Look {
  ShadingModel shading = ShadingModel::energy_conserving;
  FibreOptics fibre;
  ColourSource colour_source = ColourSource::automatic;
  double ambient = 0.38;                 // ka, [0, 4]
  double diffuse = 0.8;                  // kd, [0, 4]
  double specular = 0.25;                // ks, [0, 4]
  double diffuse_exponent = 1.2;         // pd, [0, 1e6]
  double specular_exponent = 40;         // ps, [0, 1e6]
  double back_attenuation = 0.5;         // r of B, (0, 1]
  double ambient_floor = 0.3;            // e of g = (1-e) s + e, [0, 1]
  double self_shadow = 1;                // scales the optical depth to the light, [0, 4]
  glm::vec3 skin{0.10f, 0.065f, 0.05f};  // linear; colour under the fur where the model has none

  bool operator==(const Look&) const = default;
};

enum class LightKind { directional, point, spot, area };

/// Shadow of one part of the body on another. hard: from a depth map alone. soft: softened by the shadow width (GPU fur
/// 4). penumbra: blurred by the light's size, as traced strands see it (Fernando 2005, percentage-closer soft shadows).
enum class CastShadow { none, hard, soft, penumbra };

/// Directional: `direction` is where the light goes, in the model's coordinates. Point: `position`, falling with the
/// square of distance so that intensity 1 gives white at distance `size`. Spot: a point light inside a cone. Area: a
/// rectangle about `position` that shines along `direction` by the cosine, as bright from afar as a point light. Traced
/// strands see the lights' sizes, rasterized ones soften the shadow of the body by them; shells see points, and a
/// rectangle from its middle. The last three are for shells, whose knobs have to ask for maps.
struct Light {
  LightKind kind = LightKind::directional;
  glm::dvec3 direction{0, -1, 0};
  glm::dvec3 position{0};
  glm::vec3 colour{1};            // linear
  double intensity = 1;           // [0, 1e8]
  double cone_degrees = 30;       // half angle of a spot, (0, 90]
  double cone_softness = 0.25;    // share of the cone over which the edge fades, [0, 1]
  double angle_degrees = 3;       // half angle that a directional light spans, [0, 90]
  double radius = 0.05;           // of the ball that a point or spot light is, sizes, [0, 10]
  double width = 0.5;             // of an area light, sizes, [1e-3, 100]; level
  double height = 0.5;            // sizes, [1e-3, 100]
  bool self_shadow_maps = false;  // shadow maps of the shells (GPU fur 3.1) in place of the estimate
  CastShadow cast_shadow = CastShadow::none;
  double shadow_scale = 10;  // of a soft one, Cscale of GPU fur 4: larger is a narrower edge, [0, 1000]
};

/// Radiance from all directions in the nine real spherical harmonics of bands 0 to 2, in the order of Ramamoorthi and
/// Hanrahan 2001, eq 3: 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2, each times its constant. One vector of linear red,
/// green and blue for each.
using SphericalHarmonics = std::array<glm::dvec3, 9>;

/// Light from all around, in one of two forms: colours of a gradient (straight above, at the horizon, straight below),
/// or spherical harmonics, in whose place the gradient is not looked at. White everywhere is the constant ambient light
/// of GPU fur eq 1. It scales the look's `ambient`.
struct Environment {
  glm::vec3 sky{1}, horizon{1}, ground{1};      // linear
  std::optional<SphericalHarmonics> harmonics;  // radiance; each number finite, in [-1e6, 1e6]
  double turn_degrees = 0;  // of the harmonics about +y, counter-clockwise seen from above, [-360, 360]
  double intensity = 1;     // [0, 100]

  bool operator==(const Environment&) const = default;
};

/// How a picture of all directions lights a scene.
struct EnvironmentUpload {
  Environment environment;
  std::string colour_space = {};  // of the picture, as OpenColorIO knows it; "" for linear Rec. 709
};

/// A level ground that catches the shadow of the model. It shows nothing else: the background stays what it is.
struct Ground {
  bool visible = false;
  std::optional<double> height;  // model's y; the lowest point of the model when absent
  double shadow = 0.7;           // share of the occluded light that is missing, [0, 1]
  double contact = 0.7;          // how much it darkens where the model is near, [0, 1]
};

/// Key, fill and rim: what a new scene is lit by.
std::vector<Light> default_lights();

/// Returns whether the fur takes the colours of a model that has some, or has none.
inline bool takes_model_colours(const Look& look, bool model_has_colours) {
  return look.colour_source == ColourSource::model ||
         (look.colour_source == ColourSource::automatic && model_has_colours);
}

}  // namespace pelage
