#include "renderer/strands/paths.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>

#include "base/colour_space.h"
#include "renderer/shading/fibre.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr int first_bounces = 1;  // bounces before Russian roulette may end a path
constexpr float worth_a_ray =
    0.01f;  // share of TraceScene::brightest below which Russian roulette decides on a shadow ray

/// The scattering at a hit on a fibre or on matt skin. The interface follows pbrt's BSDF, with the cosine included.
class Bsdf {
 public:
  Bsdf(const TraceScene& scene, const Hit& hit, glm::vec3 position, const Ray& from)
      : scene_(scene), hit_(hit), position_(position), to_camera_(-from.direction), time_(from.time) {
    if (hit.kind == HitKind::strand) {
      frame_.emplace(hit.tangent, to_camera_);
      const StrandShading& shading = scene.shading();
      fibre_.emplace(shading.lobes(), frame_->local(to_camera_), hit.offset, shading.absorption(hit.colour));
    } else {
      hit_.colour = glm::clamp(hit.colour, 0.0f, 1.0f);
      position_ += hit.normal * ray_offset;
    }
  }

  /// Returns a ray that leaves the hit.
  Ray spawn_ray(glm::vec3 direction, float t_max = 1e30f) const {
    return {.origin = position_, .direction = direction, .t_max = t_max, .ignored = hit_.strand, .time = time_};
  }
  glm::vec3 position() const { return position_; }

  /// Returns BSDF times cosine for light from a unit direction, 1 / steradian.
  glm::vec3 f(glm::vec3 to_light) const {
    if (fibre_) return fibre_->value(frame_->local(to_light));
    return hit_.colour * std::max(glm::dot(hit_.normal, to_light), 0.0f) / glm::pi<float>();
  }
  /// Returns f for direct light. For a fibre this is the mean over the offset h, from the table: paths hit a strand at
  /// any offset with the same probability, so the mean is unbiased and far less noisy than the value at this offset.
  glm::vec3 mean_f(glm::vec3 to_light) const {
    return fibre_ ? scene_.shading().scatter_once(hit_, to_light, to_camera_) / glm::pi<float>() : f(to_light);
  }
  float pdf(glm::vec3 to_light) const {
    if (fibre_) return fibre_->pdf(frame_->local(to_light));
    return std::max(glm::dot(hit_.normal, to_light), 0.0f) / glm::pi<float>();
  }
  /// Samples a direction in world space; its weight is f / pdf.
  FibreSample sample_f(Sampler& sampler) const {
    const glm::vec2 u = sampler.next2(), v = sampler.next2();
    if (!fibre_) {
      const glm::vec3 direction = cosine_direction(hit_.normal, u);
      return {direction, hit_.colour, pdf(direction)};
    }
    FibreSample sample = fibre_->sample(u, v);
    sample.direction = glm::normalize(frame_->world(sample.direction));
    return sample;
  }

 private:
  const TraceScene& scene_;
  Hit hit_;
  glm::vec3 position_, to_camera_;
  float time_;
  std::optional<FibreFrame> frame_;
  std::optional<FibrePaths> fibre_;
};

/// Direct light at a hit, scattered back along the path.
struct DirectLight {
  glm::vec3 lights{0}, unshadowed_lights{0}, environment{0};
};

/// Next event estimation with one shadow ray: to a light or, if no light reaches the point, into the environment. In
/// the latter case, paths that leave the scene sample the environment too, and both are weighted by their pdfs (balance
/// heuristic, Veach 1997). If a light reaches the point, paths alone sample the environment: harmonics of two bands are
/// so smooth that a shadow ray to a light is worth more. After the first hit, Russian roulette skips shadow rays that
/// can add little after `throughput`.
DirectLight sample_direct(const TraceScene& scene, const World& world, const Bsdf& bsdf, glm::vec3 throughput,
                          bool first, Sampler& sampler) {
  const StrandLights& lights = scene.lights();
  DiscreteDistribution distribution;
  float importances = 0;
  for (int i = 0; i < lights.count(); ++i) {
    const float importance = lights.importance(i, bsdf.position());
    distribution.add(importance);
    importances += importance;
  }
  if (lights.has_environment() && !(importances > 0)) distribution.add(1);
  const glm::vec2 pick = sampler.next2(), u = sampler.next2();
  const DiscreteSample chosen = distribution.sample(pick.x);
  if (chosen.index < 0) return {};
  if (chosen.index == lights.count()) {
    const EnvironmentSample sky = lights.sample_environment(u);
    if (!(sky.pdf > 0)) return {};
    const float pdf = sky.pdf * chosen.probability;
    const glm::vec3 radiance = bsdf.f(sky.direction) * sky.radiance / (pdf + bsdf.pdf(sky.direction));
    if (luminance(radiance) <= 0 || world.occluded(bsdf.spawn_ray(sky.direction))) return {};
    return {.environment = radiance};
  }
  const LightSample light = lights.sample(chosen.index, bsdf.position(), u);
  glm::vec3 radiance = bsdf.mean_f(light.to_light) * light.radiance * (glm::pi<float>() / chosen.probability);
  if (luminance(radiance) <= 0) return {};
  const float survival_probability = first ? 1 : luminance(throughput * radiance) / (worth_a_ray * scene.brightest());
  if (survival_probability < 1) {
    if (!(pick.y < survival_probability)) return {};
    radiance /= survival_probability;
  }
  if (world.occluded(bsdf.spawn_ray(light.to_light, light.distance))) return {.unshadowed_lights = radiance};
  return {.lights = radiance, .unshadowed_lights = radiance};
}

/// Returns true if sample_direct leaves the environment at a position to the paths.
bool any_light_reaches(const StrandLights& lights, glm::vec3 position) {
  for (int i = 0; i < lights.count(); ++i) {
    if (lights.importance(i, position) > 0) return true;
  }
  return false;
}

/// Returns the environment's radiance for a path that leaves the scene, times its MIS weight against sample_direct.
glm::vec3 escaped_radiance(const TraceScene& scene, const FibreSample& sample, glm::vec3 from) {
  const StrandLights& lights = scene.lights();
  if (!lights.has_environment()) return glm::vec3(0);
  const glm::vec3 radiance = lights.environment(sample.direction);
  if (any_light_reaches(lights, from)) return radiance;
  return radiance * (sample.pdf / (sample.pdf + lights.environment_pdf(sample.direction)));
}

glm::vec3 bounded(glm::vec3 radiance, float brightest) {
  const float bright = luminance(radiance);
  if (!std::isfinite(bright)) return glm::vec3(0);
  return bright > brightest ? radiance * (brightest / bright) : radiance;
}

/// Follows a path from its first hit, as pbrt's PathIntegrator does: direct light, a new direction, Russian roulette,
/// the next hit.
void follow(const TraceScene& scene, const World& world, const CameraHit& seen, Sampler& sampler,
            FilmSample& film_sample) {
  Hit hit = seen.hit;
  if (hit.kind == HitKind::skin && seen.base.there) hit.colour = seen.base.albedo, hit.normal = seen.base.normal;
  glm::vec3 position = film_sample.position, throughput(1);
  Ray ray = seen.ray;
  for (int bounce = 0; bounce < scene.frame().knobs.trace.bounces; ++bounce) {
    const Bsdf bsdf(scene, hit, position, ray);
    const DirectLight direct = sample_direct(scene, world, bsdf, throughput, bounce == 0, sampler);
    film_sample.radiance += bounded(throughput * (direct.lights + direct.environment), scene.brightest());
    if (bounce == 0) {
      film_sample.direct = bounded(direct.lights, scene.brightest());
      film_sample.light = {luminance(direct.lights), luminance(direct.unshadowed_lights)};
    }
    const FibreSample sample = bsdf.sample_f(sampler);
    if (!(sample.pdf > 0)) return;
    throughput *= sample.weight;
    const float u = sampler.next();
    if (bounce >= first_bounces) {
      const float survival_probability = std::min(std::max({throughput.r, throughput.g, throughput.b}), 1.0f);
      if (!(u < survival_probability)) return;
      throughput /= survival_probability;
    }
    ray = bsdf.spawn_ray(sample.direction);
    hit = world.intersect(ray);
    if (hit.kind == HitKind::none) {
      film_sample.radiance += bounded(throughput * escaped_radiance(scene, sample, bsdf.position()), scene.brightest());
      return;
    }
    position = ray.origin + ray.direction * hit.distance;
  }
}

}  // namespace

FilmSample path_sample(const TraceScene& scene, const World& world, glm::vec2 position, float time, Sampler& sampler) {
  const CameraHit seen = trace_camera_ray(scene, world, position, time);
  FilmSample sample = features_of(scene, seen);
  if (seen.hit.kind == HitKind::none) {
    shade_ground(scene, world, seen.ray, sampler, sample);
  } else if (seen.eye || (seen.hit.kind == HitKind::skin && seen.bare)) {
    light_backplate(scene, world, seen, sampler, sample);  // shiny and refracting surfaces are rasterized, not traced
    sample.radiance = bounded(sample.radiance, scene.brightest());
  } else {
    follow(scene, world, seen, sampler, sample);
  }
  return sample;
}

}  // namespace pelage
