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

/// The shading model of strands (science.md 4; renderer/shading). `lengyel` is GPU fur eq 1 per vertex and `kajiya` the
/// same per pixel; `energy_conserving` is d'Eon 2011 with Chiang 2016's parameters; `scheuermann` has a wrapped diffuse
/// term and two shifted lobes; `kajiya_kay` is the model of 1989; `marschner` has R, TT and TRT as in 2003.
enum class ShadingModel { lengyel, kajiya, energy_conserving, scheuermann, kajiya_kay, marschner };

/// What a fibre's absorption follows from: the coat's colour, or the pigments of `FibreOptics`.
enum class Absorption { colour, melanin };

/// Parameters of a fibre for the scattering models. `kajiya` and `lengyel` use none of them.
struct FibreOptics {
  double longitudinal_roughness = 0.3;  // beta_m, [0, 1]; energy_conserving
  double azimuthal_roughness = 0.3;     // beta_n, [0, 1]; energy_conserving
  double cuticle_tilt = 2;         // alpha, degrees, [-15, 15]; turns light to the root; energy_conserving, marschner
  double refractive_index = 1.55;  // eta, [1, 3]; energy_conserving, marschner
  Absorption absorption = Absorption::colour;
  double eumelanin = 0.3;           // concentration, [0, 1e4]; brown and black; with Absorption::melanin
  double pheomelanin = 0;           // concentration, [0, 1e4]; red
  double highlight_width = 7.5;     // beta_R, degrees, [0, 90]; marschner
  double caustic_width = 10;        // spread of TT and TRT around the strand, degrees, [1, 60]; marschner
  double primary_shift = 0.1;       // shift of the tangent along the normal, [-2, 2]; > 0: nearer the tip; scheuermann
  double secondary_shift = -0.15;   // [-2, 2]; scheuermann
  double shift_spread = 0.1;        // variation of the shifts between strands, [0, 2]; scheuermann
  double secondary_specular = 0.3;  // weight of the coloured lobe, [0, 4]; scheuermann
  double secondary_exponent = 12;   // [0, 1e6]; scheuermann

  bool operator==(const FibreOptics&) const = default;
};

/// How fur is shaded: the weights of GPU fur eq 1 and related settings.
struct Look {
  ShadingModel shading = ShadingModel::energy_conserving;
  FibreOptics fibre;
  ColourSource colour_source = ColourSource::automatic;
  double ambient = 0.38;                 // ka, [0, 4]
  double diffuse = 0.8;                  // kd, [0, 4]
  double specular = 0.25;                // ks, [0, 4]
  double diffuse_exponent = 1.2;         // pd, [0, 1e6]
  double specular_exponent = 40;         // ps, [0, 1e6]
  double back_attenuation = 0.5;         // r of B: sine of the angle behind the skin at which light is gone, (0, 1]
  double ambient_floor = 0.3;            // e of g = (1-e) s + e: share of ambient light at the roots, [0, 1]
  double self_shadow = 1;                // scales the optical depth to the light, [0, 4]
  glm::vec3 skin{0.10f, 0.065f, 0.05f};  // linear; colour under the fur if the model has none

  bool operator==(const Look&) const = default;
};

enum class LightKind { directional, point, spot, area };

/// Shadow of one part of the body on another. hard: from a depth map alone. soft: softened by the shadow width (GPU fur
/// 4). penumbra: blurred by the light's size, as traced strands see it (Fernando 2005, percentage-closer soft shadows).
enum class CastShadow { none, hard, soft, penumbra };

/// Directional: `direction` is where the light goes, in model coordinates. Point: at `position`, falling with the
/// square of the distance; intensity 1 gives white at a distance of one size. Spot: a point light inside a cone. Area:
/// a rectangle about `position` that shines along `direction` with the cosine, as bright from afar as a point light.
/// Traced strands see the sizes of lights, and rasterized ones soften the shadow of the body by them; shells see
/// points, and the centre of a rectangle. The last three members are for shells with Layering::shadow_maps.
struct Light {
  LightKind kind = LightKind::directional;
  glm::dvec3 direction{0, -1, 0};
  glm::dvec3 position{0};
  glm::vec3 colour{1};            // linear
  double intensity = 1;           // [0, 1e8]
  double cone_degrees = 30;       // half angle of a spot, (0, 90]
  double cone_softness = 0.25;    // share of the cone over which the edge fades, [0, 1]
  double angle_degrees = 3;       // half angle that a directional light spans, [0, 90]
  double radius = 0.05;           // radius of the ball of a point or spot light, sizes, [0, 10]
  double width = 0.5;             // horizontal width of an area light, sizes, [1e-3, 100]
  double height = 0.5;            // height of an area light, sizes, [1e-3, 100]
  bool self_shadow_maps = false;  // shadow maps of the shells (GPU fur 3.1) replace the estimate
  CastShadow cast_shadow = CastShadow::none;
  double shadow_scale = 10;  // for a soft shadow: Cscale of GPU fur 4, larger is narrower, [0, 1000]
};

/// Radiance from all directions in the nine real spherical harmonics of bands 0 to 2, in the order of Ramamoorthi and
/// Hanrahan 2001, eq 3: 1, y, z, x, xy, yz, 3z^2 - 1, xz, x^2 - y^2, each times its constant. One vector of linear red,
/// green and blue for each.
using SphericalHarmonics = std::array<glm::dvec3, 9>;

/// Light from all around: a gradient of three colours (straight above, at the horizon, straight below) or, where given,
/// spherical harmonics instead. White everywhere is the constant ambient light of GPU fur eq 1. It scales the look's
/// `ambient`.
struct Environment {
  glm::vec3 sky{1}, horizon{1}, ground{1};      // linear
  std::optional<SphericalHarmonics> harmonics;  // radiance; each number finite, in [-1e6, 1e6]
  double turn_degrees = 0;  // rotation of the harmonics about +y, counter-clockwise seen from above, [-360, 360]
  double intensity = 1;     // [0, 100]

  bool operator==(const Environment&) const = default;
};

/// The parameters of an uploaded environment picture.
struct EnvironmentUpload {
  Environment environment;
  std::string colour_space = {};  // OpenColorIO name; "" for linear Rec. 709
};

/// A horizontal ground that catches the shadow of the model and is invisible otherwise.
struct Ground {
  bool visible = false;
  std::optional<double> height;  // y in model coordinates; absent: the lowest point of the model
  double shadow = 0.7;           // darkness of cast shadows, [0, 1]
  double contact = 0.7;          // how much the ground darkens near the model, [0, 1]
};

/// Returns the lights of a new scene: key, fill and rim.
std::vector<Light> default_lights();

/// Returns whether fur takes the colours of the model, given whether the model has any.
inline bool takes_model_colours(const Look& look, bool model_has_colours) {
  return look.colour_source == ColourSource::model ||
         (look.colour_source == ColourSource::automatic && model_has_colours);
}

}  // namespace pelage
