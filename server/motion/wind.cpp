#include "server/motion/wind.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/random.h"

namespace pelage {

namespace {

constexpr double two_pi = glm::two_pi<double>();
constexpr int gust_waves = 12, turbulence_waves = 28;
constexpr double shortest_gust = 4, longest_gust = 16;  // wavelengths, in scales of the turbulence
constexpr double shortest_eddy = 0.25;                  // wavelength, relative to the largest
constexpr double gust_spread = 0.45;                    // maximum angle between gust and wind, radians
constexpr double gust_speed_deviation = 0.1;            // maximum deviation of the phase speed, over the wind's
constexpr double eddy_speed_deviation = 0.4;

/// Returns a unit vector, uniformly distributed over the sphere.
glm::dvec3 random_direction(Random& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, two_pi), orthogonal_part = std::sqrt(1 - z * z);
  return {orthogonal_part * std::cos(angle), orthogonal_part * std::sin(angle), z};
}

/// Returns the component of a vector orthogonal to a unit vector, normalised; any orthogonal unit vector if it
/// vanishes.
glm::dvec3 orthogonal_part(glm::dvec3 vector, glm::dvec3 along) {
  const glm::dvec3 left = vector - glm::dot(vector, along) * along;
  const double length = glm::length(left);
  if (length > 1e-6) return left / length;
  return orthogonal_part(std::abs(along.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), along);
}

/// Returns wavelength i of count: a random one in its band. Bands of equal ratios run from the longest to the shortest.
double wavelength(int i, int count, double longest, double shortest, Random& random) {
  return longest * std::pow(shortest / longest, (i + random.uniform()) / count);
}

WindWave wave_along(glm::dvec3 direction, double length, double speed_deviation, glm::dvec3 mean, double speed,
                    Random& random) {
  WindWave wave;
  const double number = two_pi / length;
  wave.number = number * direction;
  wave.rate = glm::dot(wave.number, mean) + speed_deviation * number * speed * random.uniform(-1, 1);
  wave.phase = random.uniform(0, two_pi);
  return wave;
}

/// Adds gusts with a total root mean square of `strength`.
void add_gusts(WindField& field, const Wind& wind, glm::dvec3 along, double strength) {
  Random random(wind.seed, 1);
  for (int i = 0; i < gust_waves; ++i) {
    const double length =
        wavelength(i, gust_waves, longest_gust * wind.turbulence_scale, shortest_gust * wind.turbulence_scale, random);
    const double angle = gust_spread * random.uniform(-1, 1);
    const glm::dvec3 direction =
        std::cos(angle) * along + std::sin(angle) * orthogonal_part(random_direction(random), along);
    WindWave wave = wave_along(direction, length, gust_speed_deviation, field.mean, wind.speed, random);
    wave.amplitude = strength * std::sqrt(2.0 / gust_waves) * along;
    field.waves.push_back(wave);
  }
}

/// Adds eddies with a total root mean square of `strength`. The energy in bands of equal ratios falls as k^(-2/3).
void add_turbulence(WindField& field, const Wind& wind, double strength) {
  Random random(wind.seed, 2);
  const std::size_t first = field.waves.size();
  double energy = 0;
  for (int i = 0; i < turbulence_waves; ++i) {
    const double length =
        wavelength(i, turbulence_waves, wind.turbulence_scale, shortest_eddy * wind.turbulence_scale, random);
    const glm::dvec3 direction = random_direction(random);
    WindWave wave = wave_along(direction, length, eddy_speed_deviation, field.mean, wind.speed, random);
    const double amplitude = std::cbrt(length / wind.turbulence_scale);
    wave.amplitude = amplitude * orthogonal_part(random_direction(random), direction);
    energy += 0.5 * amplitude * amplitude;
    field.waves.push_back(wave);
  }
  const double factor = strength / std::sqrt(energy);
  for (std::size_t i = first; i < field.waves.size(); ++i) field.waves[i].amplitude *= factor;
}

}  // namespace

glm::dvec3 WindField::velocity(glm::dvec3 position, double time) const {
  glm::dvec3 sum = mean;
  for (const WindWave& wave : waves)
    sum += wave.amplitude * std::cos(wave.rate * time - (glm::dot(wave.number, position) + wave.phase));
  return sum;
}

WindField make_wind(const Wind& wind) {
  WindField field;
  if (!(wind.speed > 0)) return field;
  const glm::dvec3 along = glm::normalize(wind.direction);
  field.mean = wind.speed * along;
  if (wind.gusts > 0) add_gusts(field, wind, along, wind.speed * wind.gusts);
  if (wind.turbulence > 0) add_turbulence(field, wind, wind.speed * wind.turbulence);
  return field;
}

}  // namespace pelage
