#include "renderer/eye/eye_block.h"

#include "renderer/eye/optics.h"

namespace pelage {

namespace {

void add_lids(const FurLids& lids, const glm::mat3& to_camera, EyeEntry& entry) {
  const glm::mat3 frame = to_camera * lids.frame;
  entry.lid_right = {frame[0], lids.opening.x};
  entry.lid_up = {frame[1], lids.opening.y};
  entry.lid_facing = {frame[2], lids.opening.z};
  entry.lid = {lids.colour, 0};
}

}  // namespace

EyeEntry make_eye_entry(const FurEye& eye, const FurFrame& frame, int first_caustic) {
  const EyeShape shape = shape_of(eye);
  const double size = eye.pupil.size ? *eye.pupil.size : pupil_size(luminance_at(eye, frame));
  const PupilAxes pupil = pupil_axes(eye.pupil.shape, size);
  EyeEntry entry;
  entry.right = {eye.frame[0], eye.radius};
  entry.up = {eye.frame[1], shape.iris_radius};
  entry.forward = {eye.frame[2], shape.limbus};
  entry.position = {eye.position, shape.refraction};
  entry.cornea = glm::vec4(shape.cornea_centre, shape.cornea_radius, shape.iris_plane, shape.relief);
  entry.iris = {eye.iris.colour, eye.iris.limbal_ring};
  entry.inner = {eye.iris.inner_colour, eye.iris.turn_degrees / 360};
  entry.pupil = glm::vec4(pupil.width, pupil.height, eye.pupil.shape == PupilShape::slit ? 1 : 0, first_caustic);
  entry.sclera = {eye.sclera, eye.wetness};
  if (eye.lids) add_lids(*eye.lids, glm::transpose(eye.frame), entry);
  return entry;
}

}  // namespace pelage
