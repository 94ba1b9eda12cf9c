#include "renderer/eye/optics.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/colour_space.h"
#include "renderer/shading/fibre.h"

namespace pelage {

std::optional<glm::dvec3> refract_into(glm::dvec3 along, glm::dvec3 normal, double index) {
  assert(index > 0);
  const double cosine = -glm::dot(along, normal), eta = 1 / index;
  const double squared = 1 - eta * eta * (1 - cosine * cosine);
  if (!(squared >= 0)) return std::nullopt;
  return eta * along + (eta * cosine - std::sqrt(squared)) * normal;
}

double fresnel(double cosine, double index) {
  return index == 1 ? 0 : fresnel_dielectric(std::clamp(cosine, 0.0, 1.0), index);  // index 1 reflects nothing
}

double pupil_size(double luminance) {
  constexpr double iris_millimetres = 11.8;
  const double magnitude = std::log10(std::clamp(luminance, 1e-12, 1e12));
  return (4.9 - 3 * std::tanh(0.4 * magnitude)) / iris_millimetres;
}

namespace {

constexpr double white_light = 1000;  // candela per square metre; a bright room

/// Returns the irradiance of a light on a surface at the eye's position whose normal is the eye's view direction.
double luminance_from(const FurLight& light, const FurEye& eye) {
  glm::dvec3 to_light = -glm::dvec3(light.direction);
  double share = 1;
  if (light.kind != LightKind::directional) {
    const glm::dvec3 apart = glm::dvec3(light.position) - glm::dvec3(eye.position);
    const double square = std::max(glm::dot(apart, apart), 1e-8);
    to_light = apart / std::sqrt(square);
    share = 1 / square;
    if (light.kind != LightKind::point) {
      const double inside = -glm::dot(to_light, glm::dvec3(light.direction));
      share *= std::clamp((inside - light.cone) / std::max<double>(light.soft_cone - light.cone, 1e-6), 0.0, 1.0);
    }
  }
  return share * luminance(glm::dvec3(light.radiance)) * std::max(0.0, glm::dot(to_light, glm::dvec3(eye.frame[2])));
}

}  // namespace

EyeShape shape_of(const FurEye& eye) {
  EyeShape shape;
  shape.iris_radius = eye.iris.size;
  shape.limbus = std::sqrt(1 - eye.iris.size * eye.iris.size);
  shape.cornea_radius = 1 / glm::mix(1.0, 1 / eye.iris.size, eye.bulge);
  const double square = shape.cornea_radius * shape.cornea_radius - eye.iris.size * eye.iris.size;
  shape.cornea_centre = shape.limbus - std::sqrt(std::max(square, 0.0));
  shape.iris_plane = shape.limbus - eye.iris.depth;
  shape.relief = std::min(eye.iris.relief, eye.iris.depth);  // fibres do not extend beyond the limbus
  shape.refraction = eye.refraction;
  return shape;
}

PupilAxes pupil_axes(PupilShape shape, double size) {
  if (shape == PupilShape::round) return {size, size};
  // In bright light a slit is narrow and a little more than half as high as the iris; it is round once it is dilated.
  const double narrow = std::clamp(1.6 * size - 0.12, 0.0, 1.0);
  const double width = glm::mix(narrow, size, size), height = glm::mix(0.50 * std::min(1.0, 12 * size), 1.0, size);
  return {width, height};
}

double luminance_at(const FurEye& eye, const FurFrame& frame) {
  double sum = frame.look.ambient;
  for (const FurLight& light : frame.lights) sum += luminance_from(light, eye);
  return white_light * sum;
}

namespace {

constexpr int rays_across = 160;  // rays along a side of the light's beam

/// Splats a ray's flux onto the four texels around a position; x and y in [0, caustic_texels].
void splat(float* map, double x, double y, double flux) {
  constexpr double last = caustic_texels - 1;
  x = std::clamp(x - 0.5, 0.0, last), y = std::clamp(y - 0.5, 0.0, last);
  const int i = std::min(static_cast<int>(x), caustic_texels - 2);
  const int j = std::min(static_cast<int>(y), caustic_texels - 2);
  const double u = x - i, v = y - j;
  float* texel = map + j * caustic_texels + i;
  texel[0] += static_cast<float>(flux * (1 - u) * (1 - v));
  texel[1] += static_cast<float>(flux * u * (1 - v));
  texel[caustic_texels] += static_cast<float>(flux * (1 - u) * v);
  texel[caustic_texels + 1] += static_cast<float>(flux * u * v);
}

/// Traces a beam of parallel light through the cornea and adds its flux to the map.
void gather(const EyeShape& shape, double angle, float* map) {
  const glm::dvec3 to_light(std::sin(angle), 0, std::cos(angle)), across(std::cos(angle), 0, -std::sin(angle));
  const glm::dvec3 centre(0, 0, shape.cornea_centre);
  const double step = 2 * shape.cornea_radius / rays_across, texel = 2 * shape.iris_radius / caustic_texels;
  for (int j = 0; j < rays_across; ++j) {
    for (int i = 0; i < rays_across; ++i) {
      const glm::dvec2 at = (glm::dvec2(i, j) + 0.5) * step - shape.cornea_radius;
      const double height = shape.cornea_radius * shape.cornea_radius - glm::dot(at, at);
      if (height <= 0) continue;
      const glm::dvec3 away = at.x * across + glm::dvec3(0, at.y, 0) + std::sqrt(height) * to_light;
      if (centre.z + away.z < shape.limbus) continue;  // beside the cornea
      const glm::dvec3 normal = away / shape.cornea_radius;
      const auto inside = refract_into(-to_light, normal, shape.refraction);
      if (!inside || inside->z > -1e-6) continue;
      const glm::dvec3 hit = centre + away + *inside * ((centre.z + away.z - shape.iris_plane) / -inside->z);
      if (std::hypot(hit.x, hit.y) > shape.iris_radius) continue;  // on the wall of the chamber
      const double flux = step * step * (1 - fresnel(glm::dot(normal, to_light), shape.refraction));
      splat(map, hit.x / texel + 0.5 * caustic_texels, hit.y / texel + 0.5 * caustic_texels, flux / (texel * texel));
    }
  }
}

}  // namespace

std::vector<float> gather_caustics(const EyeShape& shape) {
  constexpr std::size_t texels = caustic_texels * caustic_texels;
  std::vector<float> maps(texels * caustic_angles);
  for (int k = 0; k < caustic_angles; ++k) {
    gather(shape, caustic_reach * k / (caustic_angles - 1), maps.data() + texels * static_cast<std::size_t>(k));
  }
  return maps;
}

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
