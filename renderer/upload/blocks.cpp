#include "renderer/upload/blocks.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/colour_space.h"
#include "base/limits.h"
#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/light/environment.h"
#include "renderer/shaders/constants.h"

namespace pelage {

static_assert(max_lights == limits::lights && max_eyes == limits::eyes && max_skin_regions == limits::skin_regions);

namespace {

constexpr float near_plane_of_camera = 1e-4f;  // sizes

glm::mat4 projection(const FurFrame& frame) {
  const float y = 1 / frame.camera.tan_half_fov;
  const float x = y * static_cast<float>(frame.height) / static_cast<float>(frame.width);
  glm::mat4 matrix(0);
  matrix[0][0] = x;
  matrix[1][1] = y;
  matrix[2][3] = -1;                    // w = -z
  matrix[3][2] = near_plane_of_camera;  // z / w = near / distance
  return matrix;
}

glm::mat4 view(const FurCamera& camera) {
  const glm::mat3 rotation(camera.right, camera.up, -camera.forward);
  glm::mat4 matrix(glm::transpose(rotation));
  matrix[3] = glm::vec4(-(glm::transpose(rotation) * camera.position), 1);
  return matrix;
}

LightBlock light_block(const FurLight& light) {
  const bool spot = light.kind == LightKind::spot || light.kind == LightKind::area;
  return {{light.direction, light.kind == LightKind::directional ? 0.0f : 1.0f},
          {light.position, spot ? light.cone : -2.0f},
          {light.radiance, spot ? light.soft_cone : -1.0f}};
}

/// Returns the mean number of upright strands that a horizontal ray crosses within one strand width.
double crowding_of(const Coat& coat) {
  const double width = (coat.width_root + coat.width_tip) / 2;
  return std::min(expected_strands(width * width, coat), 1.0);
}

}  // namespace

double finest_texel(const FurFrame& frame, int pixels) {
  const double enlarged = std::max(1.0, static_cast<double>(frame.height) / pixels);
  return frame.coat().tile / slice_texels * std::sqrt(enlarged);
}

glm::mat4 world_to_clip(const FurFrame& frame) { return projection(frame) * view(frame.camera); }

FrameBlock make_frame_block(const FurFrame& frame, const Slices& slices, bool model_has_colours, int pixels) {
  assert(frame.lights.size() <= 8);
  const Look look = wet_look(frame.wetness(), frame.look);
  const Coat& coat = frame.coat();
  FrameBlock block;
  block.world_to_clip = world_to_clip(frame);
  block.viewpoint = {frame.camera.position, 2 * frame.camera.tan_half_fov / static_cast<float>(pixels)};
  block.half_picture =
      0.5f * glm::vec4(pixels * static_cast<float>(frame.width) / static_cast<float>(frame.height), -pixels, 0, 0);
  block.weights = glm::vec4(look.ambient, look.diffuse, look.specular, look.ambient_floor);
  block.exponents = glm::vec4(look.diffuse_exponent, look.specular_exponent, look.back_attenuation,
                              frame.knobs.shells.self_shadow ? look.self_shadow : 0.0);
  block.skin = {look.skin, takes_model_colours(look, model_has_colours) ? 1.0f : 0.0f};
  block.counts = glm::vec4(frame.knobs.shells.count, crowding_of(coat), frame.lights.size(), coat.root_share);
  block.tile = glm::vec4(1 / coat.tile, finest_texel(frame, pixels), coat.lean_curve == LeanCurve::root ? 1 : 0,
                         largest_luminance(coat));
  for (std::size_t i = 0; i < slices.levels.size(); ++i) {
    const std::array<double, 4>& scale = slices.levels[i].depth_scale;
    block.depth_scale[i] = glm::vec4(scale[0], scale[1], scale[2], scale[3]);
  }
  const std::array<glm::vec3, slice_count> above = colour_above(coat);
  for (std::size_t i = 0; i < slice_count; ++i) {
    block.depth_above[i / 4][static_cast<int>(i % 4)] = slices.depth_above[i];
    block.colour_above[i] = glm::vec4(above[i], 0);
  }
  block.ramp_root = {ramp_colour(coat, 0), 1};
  std::transform(frame.lights.begin(), frame.lights.end(), block.lights.begin(), light_block);
  const SphericalHarmonics light = irradiance_of(harmonics_of(frame.environment));
  for (std::size_t i = 0; i < light.size(); ++i) block.environment[i] = glm::vec4(glm::vec3(light[i]), 0);
  return block;
}

namespace {

constexpr float far_away = 16;  // sizes; distance of a directional light's viewpoint

struct Axes {
  glm::vec3 right, up, forward;
};

Axes axes_along(glm::vec3 forward) {
  const glm::vec3 hint = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 right = glm::normalize(glm::cross(forward, hint));
  return {right, glm::cross(right, forward), forward};
}

glm::mat4 view_matrix(const Axes& axes, glm::vec3 viewpoint) {
  const glm::mat3 rotation = glm::transpose(glm::mat3(axes.right, axes.up, -axes.forward));
  glm::mat4 matrix(rotation);
  matrix[3] = glm::vec4(-(rotation * viewpoint), 1);
  return matrix;
}

LightView directional_view(glm::vec3 direction, float radius, int resolution) {
  const Axes axes = axes_along(direction);
  const glm::vec3 viewpoint = -direction * far_away;
  glm::mat4 projection(0);  // depth is 1 at the front of the sphere, 0 at its back
  projection[0][0] = projection[1][1] = 1 / radius;
  projection[2][2] = 1 / (2 * radius);
  projection[3][2] = (far_away + radius) / (2 * radius);
  projection[3][3] = 1;
  return {projection * view_matrix(axes, viewpoint),
          viewpoint,
          {direction, radius},
          2 * radius / (static_cast<float>(resolution) * far_away)};
}

LightView point_view(glm::vec3 position, float radius, int resolution) {
  const float distance = glm::length(position);
  const glm::vec3 forward = -position / distance;
  const float tangent = radius / std::sqrt(distance * distance - radius * radius);
  const float near_plane = 0.5f * (distance - radius);
  glm::mat4 projection(0);
  projection[0][0] = projection[1][1] = 1 / tangent;
  projection[2][3] = -1;
  projection[3][2] = near_plane;
  return {projection * view_matrix(axes_along(forward), position),
          position,
          {forward, -glm::dot(forward, position)},
          2 * tangent / static_cast<float>(resolution)};
}

}  // namespace

float spread_of(const FurLight& light) {
  constexpr float widest = 2;
  switch (light.kind) {
    case LightKind::directional: return light.angle < std::atan(widest) ? std::tan(light.angle) : widest;
    case LightKind::point:
    case LightKind::spot: return light.radius;
    case LightKind::area: return (light.extent.x + light.extent.y) / 4;
  }
  assert(false);
  return 0;
}

std::optional<LightView> view_of_light(const FurLight& light, float radius, int resolution) {
  if (light.kind == LightKind::directional) return directional_view(light.direction, radius, resolution);
  if (!(glm::length(light.position) > 1.1f * radius)) return {};
  return point_view(light.position, radius, resolution);
}

namespace {

SkinEntry make_entry(const FurSkinRegion& region) {
  const glm::dmat3 rows = glm::transpose(region.to_unit);
  const double steepest = std::max({glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])});
  SkinEntry entry;
  entry.across = glm::vec4(rows[0], region.softness);
  entry.up = glm::vec4(rows[1], steepest);
  entry.along = glm::vec4(rows[2], region.cosine_full);
  entry.centre = glm::vec4(region.centre, region.scatter);
  entry.facing = glm::vec4(region.facing, std::min(region.cosine_none, region.cosine_full - 1e-6));
  entry.colour = glm::vec4(region.colour, region.shine);
  entry.finish = glm::vec4(region.roughness, region.wetness, region.bumps.height, region.bumps.size);
  return entry;
}

/// Returns the bounding sphere of a region's colour: twice its largest radius, or more if the colour extends beyond
/// that; slightly enlarged for rounding.
glm::vec4 ball_around(const FurSkinRegion& region) {
  const glm::dmat3 rows = glm::transpose(region.to_unit);
  const double flattest = std::min({glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2])});
  const double radius = 1.001 * (1 + std::max(1.0, 0.5 * region.softness)) / flattest;
  return glm::vec4(region.centre, radius * radius);
}

}  // namespace

SkinBlock make_skin_block(std::span<const FurSkinRegion> regions) {
  assert(regions.size() <= limits::skin_regions);
  SkinBlock block;
  block.count.x = static_cast<glm::uint>(regions.size());
  std::transform(regions.begin(), regions.end(), block.regions.begin(), make_entry);
  std::transform(regions.begin(), regions.end(), block.balls.begin(), ball_around);
  return block;
}

}  // namespace pelage
