// How a groomed model is lit and shaded: part of the scene, set by commands and logged.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace pelage {

/// Where the fur takes its colour from. `model` uses the model's texture or vertex colours for hue and the ramp for
/// lightness along the strand; `coat` uses the ramp alone; `automatic` is `model` where the model has colours.
enum class ColourSource { automatic, model, coat };

/// Weights of GPU fur eq 1 and what goes with them.
struct Look {
  ColourSource colour_source = ColourSource::automatic;
  double ambient = 0.38;             // ka, [0, 4]
  double diffuse = 0.8;              // kd, [0, 4]
  double specular = 0.25;            // ks, [0, 4]
  double diffuse_exponent = 1.2;     // pd, [0, 1e6]
  double specular_exponent = 40;     // ps, [0, 1e6]
  double back_attenuation = 0.5;     // r of B, (0, 1]
  double ambient_floor = 0.3;        // e of g = (1-e) s + e, [0, 1]
  double self_shadow = 1;            // scales the optical depth to the light, [0, 4]
  glm::vec3 skin{0.10f, 0.065f, 0.05f};  // linear; colour under the fur where the model has none
};

enum class LightKind { directional, point };

/// Directional: `direction` is where the light goes, in the model's coordinates. Point: `position`, falling with the
/// square of distance so that intensity 1 gives white at distance `size`.
struct Light {
  LightKind kind = LightKind::directional;
  glm::dvec3 direction{0, -1, 0};
  glm::dvec3 position{0};
  glm::vec3 colour{1};   // linear
  double intensity = 1;  // [0, 1e8]
};

/// Key, fill and rim: what a new scene is lit by.
std::vector<Light> default_lights();

}  // namespace pelage
