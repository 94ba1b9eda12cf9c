// The scene's lights for sampling by traced rays: lights with a size, and the environment.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// A direction to a light, and its radiance. `radiance` is in the units of lighting.glsl's light_at: a light of 1 makes
/// a white matt surface that faces it look 1, so this is irradiance over pi; finite and not negative for every
/// position.
struct LightSample {
  glm::vec3 to_light{0, 1, 0};  // unit
  float distance = 0;           // sizes; infinity for a directional light
  glm::vec3 radiance{0};
};

/// A direction into the environment, importance-sampled by luminance.
struct EnvironmentSample {
  glm::vec3 direction{0, 1, 0};  // unit
  glm::vec3 radiance{0};         // true radiance
  float pdf = 0;                 // of the direction, 1 / steradian; above 0
};

class StrandLights {
 public:
  /// `ambient` scales the environment (Look::ambient).
  StrandLights(std::span<const FurLight> lights, const Environment& environment, double ambient);

  int count() const { return static_cast<int>(lights_.size()); }
  /// Samples light i as seen from `position`; u in [0, 1)^2. The mean over u is the light of its whole extent: a
  /// directional light is a disc of directions, a point or spot light a sphere (its centre alone for a `position`
  /// inside it), an area light a one-sided rectangle. The cone of a spot light is evaluated at its centre.
  LightSample sample(int i, glm::vec3 position, glm::vec2 u) const;
  /// Returns the luminance that light i, treated as a point, brings to `position`; for choosing among lights.
  float importance(int i, glm::vec3 position) const;

  bool has_environment() const { return environment_bright_; }
  glm::vec3 environment(glm::vec3 direction) const;  // radiance, >= 0
  EnvironmentSample sample_environment(glm::vec2 u) const;
  float environment_pdf(glm::vec3 direction) const;
  float mean_environment() const { return mean_environment_; }  // mean luminance over all directions

 private:
  static constexpr int columns = 64, rows = 32;  // size of the table over directions; rows are evenly spaced in y

  void tabulate();
  float cell_share(int row, int column) const;

  std::vector<FurLight> lights_;
  SphericalHarmonics harmonics_{};
  std::vector<float> row_sums_, cell_sums_;  // CDFs over rows and over the cells of each row, from 0 to 1
  bool environment_bright_ = false;
  float mean_environment_ = 0;
};

}  // namespace pelage
