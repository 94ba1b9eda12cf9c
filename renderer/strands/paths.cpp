#include "renderer/strands/paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "renderer/shading/fibre_paths.h"
#include "renderer/strands/choice.h"
#include "renderer/strands/fibre_frame.h"

namespace pelage {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float leave_skin = 1e-5f;   // sizes from which rays start
constexpr int first_bounces = 1;      // after them dark paths are ended by chance
constexpr float worth_a_ray = 0.01f;  // share of TraceScene::brightest below which light is asked for by chance

/// A place that scatters: a strand or matt skin.
class Scatterer {
 public:
  Scatterer(const TraceScene& scene, const Hit& hit, glm::vec3 place, glm::vec3 to_eye)
      : scene_(scene), hit_(hit), place_(place), to_eye_(to_eye) {
    if (hit.met == Met::strand) {
      frame_.emplace(hit.tangent, to_eye);
      const StrandShading& shading = scene.shading();
      absorption_ = shading.absorption(hit.colour);
      fibre_.emplace(shading.lobes(), frame_->local(to_eye), hit.offset, absorption_);
    } else {
      hit_.colour = glm::clamp(hit.colour, 0.0f, 1.0f);
      place_ += hit.normal * leave_skin;
    }
  }

  Ray ray(glm::vec3 direction, float reach = 1e30f) const {
    return {.origin = place_, .direction = direction, .reach = reach, .without = hit_.strand};
  }
  glm::vec3 place() const { return place_; }

  /// Radiance scattered to the eye for light of radiance 1 from a unit of solid angle there.
  glm::vec3 value(glm::vec3 to_light) const {
    if (fibre_) return fibre_->value(frame_->local(to_light));
    return hit_.colour * std::max(glm::dot(hit_.normal, to_light), 0.0f) / pi;
  }
  /// The same for a lamp. Paths meet a strand at any offset alike, so that its mean over the offsets, which the table
  /// has, is as true as the value at this one, and far less noisy.
  glm::vec3 mean_value(glm::vec3 to_light) const {
    return fibre_ ? scene_.shading().scatter_averaged(hit_, absorption_, to_light, to_eye_) / pi : value(to_light);
  }
  float density(glm::vec3 to_light) const {
    if (fibre_) return fibre_->density(frame_->local(to_light));
    return std::max(glm::dot(hit_.normal, to_light), 0.0f) / pi;
  }
  /// A direction in space.
  FibreSample sample(Sampler& sampler) const {
    const glm::vec2 u = sampler.next2(), v = sampler.next2();
    if (!fibre_) {
      const glm::vec3 way = cosine_direction(hit_.normal, u);
      return {way, hit_.colour, density(way)};
    }
    FibreSample sample = fibre_->sample(u, v);
    sample.direction = glm::normalize(frame_->world(sample.direction));
    return sample;
  }

 private:
  const TraceScene& scene_;
  Hit hit_;
  glm::vec3 place_, to_eye_, absorption_{0};
  std::optional<FibreFrame> frame_;
  std::optional<FibrePaths> fibre_;
};

/// Light that comes straight to a place and is scattered on. A lamp's part is kept apart.
struct Direct {
  glm::vec3 lamps{0}, unshadowed_lamps{0}, environment{0};
};

/// A ray to a lamp, or where there is none into the environment. The environment is also met by paths that go on: then
/// both are weighted by their densities (balance heuristic, Veach 1997). Beside lamps paths do: harmonics of two bands
/// are so even that a ray spent on a lamp is worth more. `carried` is what the path has kept so far: after its first
/// place, what little a lamp could add is asked for by chance.
Direct direct_light(const TraceScene& scene, const World& world, const Scatterer& at, glm::vec3 carried, bool first,
                    Sampler& sampler) {
  const StrandLights& lights = scene.lights();
  Chances chances;
  float lamps = 0;
  for (int i = 0; i < lights.count(); ++i) {
    const float importance = lights.importance(i, at.place());
    chances.add(importance);
    lamps += importance;
  }
  if (lights.has_environment() && !(lamps > 0)) chances.add(1);
  const glm::vec2 pick = sampler.next2(), u = sampler.next2();
  const Choice choice = chances.choose(pick.x);
  if (choice.index < 0) return {};
  if (choice.index == lights.count()) {
    const EnvironmentSample sky = lights.sample_environment(u);
    if (!(sky.density > 0)) return {};
    const float density = sky.density * choice.probability;
    const glm::vec3 light = at.value(sky.direction) * sky.radiance / (density + at.density(sky.direction));
    if (luminance(light) <= 0 || world.blocked(at.ray(sky.direction))) return {};
    return {.environment = light};
  }
  const LightSample lamp = lights.sample(choice.index, at.place(), u);
  glm::vec3 light = at.mean_value(lamp.to_light) * lamp.radiance * (pi / choice.probability);
  if (luminance(light) <= 0) return {};
  const float asked = first ? 1 : luminance(carried * light) / (worth_a_ray * scene.brightest());
  if (asked < 1) {
    if (!(pick.y < asked)) return {};
    light /= asked;
  }
  if (world.blocked(at.ray(lamp.to_light, lamp.distance))) return {.unshadowed_lamps = light};
  return {.lamps = light, .unshadowed_lamps = light};
}

/// Whether direct_light leaves the environment at a place to the paths.
bool lamps_shine(const StrandLights& lights, glm::vec3 place) {
  for (int i = 0; i < lights.count(); ++i) {
    if (lights.importance(i, place) > 0) return true;
  }
  return false;
}

/// What a path that leaves the scene brings, over the weight that direct_light has for it.
glm::vec3 met_environment(const TraceScene& scene, const FibreSample& way, glm::vec3 from) {
  const StrandLights& lights = scene.lights();
  if (!lights.has_environment()) return glm::vec3(0);
  const glm::vec3 light = lights.environment(way.direction);
  if (lamps_shine(lights, from)) return light;
  return light * (way.density / (way.density + lights.environment_density(way.direction)));
}

glm::vec3 bounded(glm::vec3 light, float brightest) {
  const float bright = luminance(light);
  if (!std::isfinite(bright)) return glm::vec3(0);
  return bright > brightest ? light * (brightest / bright) : light;
}

/// Follows a path from where it was first met.
void follow(const TraceScene& scene, const World& world, const Seen& seen, Sampler& sampler, FilmSample& sample) {
  Hit hit = seen.hit;
  if (hit.met == Met::skin && seen.base.there) hit.colour = seen.base.albedo, hit.normal = seen.base.normal;
  glm::vec3 place = sample.position, to_eye = -seen.ray.direction, carried(1);
  for (int bounce = 0; bounce < scene.frame().knobs.trace.bounces; ++bounce) {
    const Scatterer at(scene, hit, place, to_eye);
    const Direct direct = direct_light(scene, world, at, carried, bounce == 0, sampler);
    sample.radiance += bounded(carried * (direct.lamps + direct.environment), scene.brightest());
    if (bounce == 0) {
      sample.direct = bounded(direct.lamps, scene.brightest());
      sample.light = {luminance(direct.lamps), luminance(direct.unshadowed_lamps)};
    }
    const FibreSample way = at.sample(sampler);
    if (!(way.density > 0)) return;
    carried *= way.weight;
    const float ending = sampler.next();
    if (bounce >= first_bounces) {
      const float goes_on = std::min(std::max({carried.r, carried.g, carried.b}), 1.0f);
      if (!(ending < goes_on)) return;
      carried /= goes_on;
    }
    const Ray ray = at.ray(way.direction);
    hit = world.meet(ray);
    if (hit.met == Met::nothing) {
      sample.radiance += bounded(carried * met_environment(scene, way, at.place()), scene.brightest());
      return;
    }
    place = ray.origin + ray.direction * hit.distance, to_eye = -ray.direction;
  }
}

}  // namespace

FilmSample path_sample(const TraceScene& scene, const World& world, glm::vec2 place, Sampler& sampler) {
  const Seen seen = look_at(scene, world, place);
  FilmSample sample = features_of(scene, seen);
  if (seen.hit.met == Met::nothing) {
    shade_ground(scene, world, seen.ray, sampler, sample);
  } else if (seen.eye || (seen.hit.met == Met::skin && seen.bare)) {
    light_base(scene, world, seen, sampler, sample);  // what shines and refracts is the base picture's
    sample.radiance = bounded(sample.radiance, scene.brightest());
  } else {
    follow(scene, world, seen, sampler, sample);
  }
  return sample;
}

}  // namespace pelage
