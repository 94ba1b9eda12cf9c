#include "server/scene/eye_view.h"

#include "server/scene/upright_frame.h"

namespace pelage {

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
    made.lids = FurLids{glm::mat3(tilted(frame, glm::radians(eye.lids->tilt_degrees))),
                        glm::vec3(glm::radians(glm::dvec3(eye.lids->width_degrees, eye.lids->upper_degrees,
                                                          eye.lids->lower_degrees))),
                        eye.lids->colour};
  }
  made.sclera = eye.sclera;
  made.bulge = eye.bulge, made.refraction = eye.refraction, made.wetness = eye.wetness;
  return made;
}

}  // namespace pelage
