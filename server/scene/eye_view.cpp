#include "server/scene/eye_view.h"

#include <cmath>

namespace pelage {

glm::dmat3 upright_frame(glm::dvec3 forward) {
  forward = glm::normalize(forward);
  const glm::dvec3 guide = std::abs(forward.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -forward.y);
  const glm::dvec3 right = glm::normalize(glm::cross(guide, forward));
  return {right, glm::cross(forward, right), forward};
}

glm::dmat3 tilted(const glm::dmat3& frame, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {frame[0] * c + frame[1] * s, frame[1] * c - frame[0] * s, frame[2]};
}

FurEye make_eye(const Eye& eye, const Mesh& mesh) {
  const glm::dvec3 gaze = eye.look_at ? *eye.look_at - eye.position : eye.gaze;
  FurEye made;
  made.position = glm::vec3(mesh.to_internal(eye.position));
  made.radius = static_cast<float>(eye.radius);
  made.frame = glm::mat3(upright_frame(gaze));
  made.iris = eye.iris;
  made.pupil = eye.pupil;
  if (eye.lids) {
    const glm::dmat3 frame = upright_frame(eye.lids->facing.value_or(gaze));
    made.lids = FurLids{
        glm::mat3(tilted(frame, glm::radians(eye.lids->tilt_degrees))),
        glm::vec3(glm::radians(glm::dvec3(eye.lids->width_degrees, eye.lids->upper_degrees, eye.lids->lower_degrees))),
        eye.lids->colour};
  }
  made.sclera = eye.sclera;
  made.bulge = eye.bulge, made.refraction = eye.refraction, made.wetness = eye.wetness;
  return made;
}

}  // namespace pelage
