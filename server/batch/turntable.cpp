#include "server/batch/turntable.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "server/groom/evaluate.h"

namespace pelage {

namespace {

glm::dmat3 turn_about_y(double degrees) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(std::remainder(degrees, 360.0)), glm::dvec3(0, 1, 0)));
}

/// Returns the camera with an explicit position in place of an automatic view.
Camera placed(const Camera& camera, double aspect, const Mesh& mesh) {
  if (camera.automatic == AutoView::none) return camera;
  const PlacedCamera at = place_camera(camera, aspect, mesh);
  const double distance = glm::length(at.position);  // the target is the centre of the model's box, which is 0
  return {.automatic = AutoView::none,
          .position = mesh.to_model(at.position),
          .target = mesh.to_model(at.position + at.forward * distance),
          .up = at.up,
          .fov_degrees = glm::degrees(2 * std::atan(at.tan_half_fov))};
}

}  // namespace

Camera turned_camera(const Camera& camera, double aspect, const Mesh& mesh, double degrees) {
  Camera turned = placed(camera, aspect, mesh);
  const glm::dmat3 turn = turn_about_y(degrees);
  turned.position = turned.target + turn * (turned.position - turned.target);
  turned.up = turn * turned.up;
  return turned;
}

std::vector<Light> turned_lights(const std::vector<Light>& lights, glm::dvec3 pivot, double degrees) {
  const glm::dmat3 turn = turn_about_y(degrees);
  std::vector<Light> turned = lights;
  for (Light& light : turned) {
    light.direction = turn * light.direction;
    light.position = pivot + turn * (light.position - pivot);
  }
  return turned;
}

Environment turned_environment(Environment environment, double degrees) {
  if (environment.harmonics) environment.turn_degrees = std::remainder(environment.turn_degrees + degrees, 360.0);
  return environment;
}

}  // namespace pelage
