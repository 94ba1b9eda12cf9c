#include "renderer/strands/transmitted_light.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/colour_space.h"
#include "renderer/shading/fibre.h"
#include "renderer/skin/bare.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr float near_pixels = 1.5f;  // strand width from which scattering varies visibly across it, pixels

/// Returns true if the strand is so wide in the picture that scattering varies visibly across it.
bool is_near(const TraceScene& scene, const Hit& hit) {
  return scene.shading().model() == ShadingModel::energy_conserving &&
         2 * hit.radius >= near_pixels * scene.pixel_at(hit.distance);
}

glm::vec3 scattered(const TraceScene& scene, const Hit& hit, glm::vec3 to_light, glm::vec3 to_camera) {
  const StrandShading& shading = scene.shading();
  if (!is_near(scene, hit)) return shading.scatter(hit, to_light, to_camera);
  const FibreFrame frame(hit.tangent, to_camera);
  const FibrePaths fibre(shading.lobes(), frame.local(to_camera), hit.offset, shading.absorption(hit.colour));
  const glm::vec3 once = glm::pi<float>() * fibre.value(frame.local(to_light));
  return shading.scatter_bundle(hit, to_light, to_camera, once);
}

/// As ambient_share in lighting.glsl, with the traced transmittance in place of the estimate.
glm::vec3 ambient_share(const Look& look, glm::vec3 transmittance) {
  const float floor = static_cast<float>(look.ambient_floor);
  return floor + (1 - floor) * glm::pow(transmittance, glm::vec3(0.6f));
}

/// Lights a strand by one light or by the environment, chosen at random by importance.
void light_strand(const TraceScene& scene, const World& world, const CameraHit& seen, Sampler& sampler,
                  FilmSample& sample) {
  const StrandLights& lights = scene.lights();
  const Hit& hit = seen.hit;
  const glm::vec3 position = sample.position, to_camera = -seen.ray.direction;
  DiscreteDistribution distribution;
  for (int i = 0; i < lights.count(); ++i) distribution.add(lights.importance(i, position));
  distribution.add(lights.mean_environment());
  const DiscreteSample chosen = distribution.sample(sampler.next());
  const glm::vec2 u = sampler.next2();
  if (chosen.index < 0) return;
  if (chosen.index == lights.count()) {
    const glm::vec3 direction = cosine_direction(hit.normal, u);
    const glm::vec3 transmittance =
        world.transmittance({.origin = position, .direction = direction, .ignored = hit.strand, .time = seen.ray.time},
                            scene.self_shadow());
    sample.radiance += hit.colour * lights.environment(direction) * ambient_share(scene.frame().look, transmittance) /
                       chosen.probability;
    return;
  }
  const LightSample light = lights.sample(chosen.index, position, u);
  const glm::vec3 unshadowed = light.radiance / chosen.probability * scattered(scene, hit, light.to_light, to_camera);
  if (luminance(unshadowed) <= 0) return;
  const glm::vec3 transmittance = world.transmittance({.origin = position,
                                                       .direction = light.to_light,
                                                       .t_max = light.distance,
                                                       .ignored = hit.strand,
                                                       .time = seen.ray.time},
                                                      scene.self_shadow());
  sample.radiance += unshadowed * transmittance, sample.direct += unshadowed * transmittance;
  sample.light += glm::vec2(luminance(unshadowed * transmittance), luminance(unshadowed));
}

void bound(const TraceScene& scene, FilmSample& sample) {
  const float bright = luminance(sample.radiance);
  if (!(bright > scene.brightest())) return;
  const float share = std::isfinite(bright) ? scene.brightest() / bright : 0.0f;
  sample.radiance *= share, sample.direct *= share;
  if (share == 0) sample.radiance = sample.direct = glm::vec3(0);
}

}  // namespace

CameraHit trace_camera_ray(const TraceScene& scene, const World& world, glm::vec2 position, float time) {
  CameraHit seen{.ray = scene.ray_at(position), .hit = {}, .base = {}};
  seen.ray.time = time;
  seen.hit = world.intersect(seen.ray);
  const bool strand = seen.hit.kind == HitKind::strand;
  const bool eye = scene.near_eye(seen.ray);
  if (!eye && seen.hit.kind != HitKind::skin) return seen;
  seen.base = scene.backplate_at(position);
  if (seen.hit.kind == HitKind::skin) {
    const glm::dvec3 skin_position(seen.ray.origin + seen.ray.direction * seen.hit.distance);
    seen.bare = fur_share(scene.frame().skin, skin_position, glm::dvec3(seen.base.normal)) < 0.5;
  }
  if (!eye) return seen;
  // Lids and cornea, which only the backplate has, lie in front of the eyeball that rays hit.
  const float along = glm::dot(seen.ray.direction, scene.frame().camera.forward);
  const float distance = seen.base.distance / std::max(along, 1e-6f);
  const bool before = seen.base.there && (seen.hit.kind == HitKind::none || distance < seen.hit.distance);
  if (strand && !before) return seen;
  seen.eye = before || seen.hit.kind == HitKind::skin;
  if (before) seen.hit = {.kind = HitKind::skin, .distance = distance, .normal = seen.base.normal};
  return seen;
}

FilmSample features_of(const TraceScene& scene, const CameraHit& seen) {
  FilmSample sample;
  if (seen.hit.kind == HitKind::none) return sample;
  const bool strand = seen.hit.kind == HitKind::strand;
  sample.alpha = sample.body = 1;
  const float along = glm::dot(seen.ray.direction, scene.frame().camera.forward);
  sample.over_depth = 1 / std::max(seen.hit.distance * along, 1e-9f);
  sample.position = seen.ray.origin + seen.ray.direction * seen.hit.distance;
  sample.normal = strand || !seen.base.there ? seen.hit.normal : seen.base.normal;
  sample.tangent = strand ? seen.hit.tangent : glm::vec3(0);
  sample.albedo = strand || !seen.base.there ? seen.hit.colour : seen.base.albedo;
  sample.object = strand ? seen.hit.object : seen.eye ? eyes_object : skin_object;
  return sample;
}

void light_backplate(const TraceScene& scene, const World& world, const CameraHit& seen, Sampler& sampler,
                     FilmSample& sample) {
  const StrandLights& lights = scene.lights();
  // At edges a ray may hit skin where the backplate has none.
  const BackplatePixel lone{.ambient = seen.hit.colour * lights.mean_environment(), .normal = seen.hit.normal};
  const BackplatePixel base = seen.base.there ? seen.base : lone;
  const glm::vec3 position = sample.position + base.normal * ray_offset;
  const float ambient = luminance(base.ambient), direct = luminance(base.direct);
  const float pick = sampler.next(), total = ambient + direct;
  const float which = sampler.next();
  const glm::vec2 u = sampler.next2();
  if (!(total > 0) || !std::isfinite(total)) return;
  if (pick * total < ambient) {
    const glm::vec3 direction = cosine_direction(base.normal, u);
    const glm::vec3 transmittance =
        world.transmittance({.origin = position, .direction = direction, .time = seen.ray.time}, scene.self_shadow());
    sample.radiance += base.ambient * ambient_share(scene.frame().look, transmittance) * (total / ambient);
    return;
  }
  DiscreteDistribution distribution;
  for (int i = 0; i < lights.count(); ++i) {
    const LightSample middle = lights.sample(i, position, glm::vec2(0.5f));
    const float facing = glm::dot(middle.to_light, base.normal);
    distribution.add(lights.importance(i, position) * std::max(facing + (seen.eye ? 0.3f : 0.0f), 0.0f));
  }
  const DiscreteSample chosen = distribution.sample(which);
  const glm::vec3 unshadowed = base.direct * (total / direct);
  glm::vec3 transmittance(1);  // if no light explains the light of the backplate, nothing occludes it
  if (chosen.index >= 0) {
    const LightSample light = lights.sample(chosen.index, position, u);
    transmittance = world.transmittance(
        {.origin = position, .direction = light.to_light, .t_max = light.distance, .time = seen.ray.time},
        scene.self_shadow());
  }
  sample.radiance += unshadowed * transmittance, sample.direct += unshadowed * transmittance;
  sample.light += glm::vec2(luminance(unshadowed * transmittance), luminance(unshadowed));
}

void shade_ground(const TraceScene& scene, const World& world, const Ray& ray, Sampler& sampler, FilmSample& sample) {
  const std::optional<FurGround>& ground = scene.frame().ground;
  if (!ground || !(ray.direction.y < 0) || !(ray.origin.y > ground->height)) return;
  const float distance = (ray.origin.y - ground->height) / -ray.direction.y;
  const glm::vec3 position = ray.origin + ray.direction * distance + glm::vec3(0, ray_offset, 0);
  const float from_middle = glm::length(glm::vec2(position.x, position.z));
  if (!(from_middle < 3.5f)) return;
  const StrandLights& lights = scene.lights();
  const Look& look = scene.frame().look;
  DiscreteDistribution distribution;
  for (int i = 0; i < lights.count(); ++i) {
    const LightSample middle = lights.sample(i, position, glm::vec2(0.5f));
    distribution.add(static_cast<float>(look.diffuse) * lights.importance(i, position) *
                     std::max(middle.to_light.y, 0.0f));
  }
  distribution.add(static_cast<float>(look.ambient));
  const DiscreteSample chosen = distribution.sample(sampler.next());
  const glm::vec2 u = sampler.next2();
  if (chosen.index < 0) return;
  Ray towards{.origin = position, .direction = cosine_direction({0, 1, 0}, u), .time = ray.time};
  float strength = ground->contact;
  if (chosen.index < lights.count()) {
    const LightSample light = lights.sample(chosen.index, position, u);
    towards.direction = light.to_light, towards.t_max = light.distance;
    strength = ground->shadow;
  }
  const float lit = towards.direction.y > 0 ? luminance(world.transmittance(towards, scene.self_shadow())) : 1.0f;
  const float edge = 1 - glm::smoothstep(1.0f, 3.5f, from_middle);
  sample.alpha = strength * (1 - lit) * edge;
}

FilmSample transmitted_sample(const TraceScene& scene, const World& world, glm::vec2 position, float time,
                              Sampler& sampler) {
  const CameraHit seen = trace_camera_ray(scene, world, position, time);
  FilmSample sample = features_of(scene, seen);
  switch (seen.hit.kind) {
    case HitKind::none: shade_ground(scene, world, seen.ray, sampler, sample); break;
    case HitKind::strand: light_strand(scene, world, seen, sampler, sample); break;
    case HitKind::skin: light_backplate(scene, world, seen, sampler, sample); break;
  }
  bound(scene, sample);
  return sample;
}

}  // namespace pelage
