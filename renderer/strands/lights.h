// The scene's lights as what a traced ray samples: lights with a size, and the light from all around.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"

namespace pelage {

/// A direction to a light, and its radiance. `radiance` is in the units of lighting.glsl's light_at: 1 is what a white
/// matt surface that faces it returns as 1, so it is irradiance over pi; finite and not negative for every position.
struct LightSample {
  glm::vec3 to_light{0, 1, 0};  // unit
  float distance = 0;           // sizes; infinity for a directional light
  glm::vec3 radiance{0};
};

/// A direction of the environment, sampled by its luminance.
struct EnvironmentSample {
  glm::vec3 direction{0, 1, 0};  // unit
  glm::vec3 radiance{0};         // true radiance
  float pdf = 0;                 // of the direction, 1 / steradian, above 0
};

class StrandLights {
 public:
  /// `ambient` scales the environment (Look::ambient).
  StrandLights(std::span<const FurLight> lights, const Environment& environment, double ambient);

  int count() const { return static_cast<int>(lights_.size()); }
  /// Returns a random position on light i as seen from `place`; u in [0, 1)^2. The mean over u is the light of all of
  /// it: a directional light is a disc of directions, a point or spot light a ball (from within it, its middle), an
  /// area light a rectangle that shines to one side. A spot's cone is that of its middle.
  LightSample sample(int i, glm::vec3 place, glm::vec2 u) const;
  /// Returns the luminance that light i, seen as a point, brings to `place`: for choosing among lights.
  float importance(int i, glm::vec3 place) const;

  bool has_environment() const { return environment_bright_; }
  glm::vec3 environment(glm::vec3 direction) const;  // radiance, not negative
  EnvironmentSample sample_environment(glm::vec2 u) const;
  float environment_pdf(glm::vec3 direction) const;
  float mean_environment() const { return mean_environment_; }  // luminance, over all directions

 private:
  static constexpr int columns = 64, rows = 32;  // of the table over directions, rows even in height

  void tabulate();
  float cell_share(int row, int column) const;

  std::vector<FurLight> lights_;
  SphericalHarmonics harmonics_{};
  std::vector<float> row_sums_, cell_sums_;  // cumulated to 1, for sampling; of cells by row; each begins with 0
  bool environment_bright_ = false;
  float mean_environment_ = 0;
};

}  // namespace pelage
