#include "renderer/strands/lights.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "base/clamped_index.h"
#include "base/colour_space.h"
#include "renderer/light/environment.h"
#include "renderer/shaders/constants.h"

namespace pelage {

namespace {

constexpr auto min_square = static_cast<float>(min_light_square), max_falloff = static_cast<float>(max_light_falloff);

struct Axes {
  glm::vec3 right, up;
};

/// Returns two axes orthogonal to a unit direction. The first is horizontal; it is x for a vertical direction.
Axes axes_across(glm::vec3 direction) {
  const glm::vec3 level(direction.z, 0, -direction.x);  // up x direction
  const float length = glm::length(level);
  const glm::vec3 right = length > 1e-6f ? level / length : glm::vec3(1, 0, 0);
  return {right, glm::cross(direction, right)};
}

/// Returns the direction at the cosine 1 - `missing` to a unit middle and at the azimuth `around`, radians.
glm::vec3 turned_off(glm::vec3 middle, float missing, float around) {
  const float sine = std::sqrt(std::max(0.0f, missing * (2 - missing)));
  const Axes axes = axes_across(middle);
  const glm::vec3 aside = std::cos(around) * axes.right + std::sin(around) * axes.up;
  return glm::normalize((1 - missing) * middle + sine * aside);
}

/// Returns the cone falloff of a spot light, the cosine of an area light, and 1 for other lights.
float cone_share(const FurLight& light, glm::vec3 to_light) {
  if (light.kind == LightKind::directional || light.kind == LightKind::point) return 1;
  const float inside = -glm::dot(to_light, light.direction);
  if (light.kind == LightKind::area) return std::clamp(inside, 0.0f, 1.0f);
  return std::clamp((inside - light.cone) / std::max(light.soft_cone - light.cone, 1e-6f), 0.0f, 1.0f);
}

/// As light_at in lighting.glsl, for light from a position.
LightSample from_point(const FurLight& light, glm::vec3 from, glm::vec3 position) {
  const glm::vec3 apart = from - position;
  const float square = std::max(glm::dot(apart, apart), min_square);
  const float distance = std::sqrt(square);
  const glm::vec3 towards = apart / distance;
  const glm::vec3 radiance = light.radiance * std::min(1 / square, max_falloff) * cone_share(light, towards);
  const float length = glm::length(towards);  // below 1 only where `square` was clamped
  return {length > 0 ? towards / length : -light.direction, distance, radiance};
}

LightSample from_disc(const FurLight& light, glm::vec2 u) {
  const float half = std::sin(light.angle / 2);
  const glm::vec3 to_light = turned_off(-light.direction, u.x * 2 * half * half, 2 * glm::pi<float>() * u.y);
  return {light.angle > 0 ? to_light : -light.direction, std::numeric_limits<float>::infinity(), light.radiance};
}

/// Samples the sphere uniformly by solid angle. Its radiance is that of the point light over radius^2, times the solid
/// angle 2 pi (1 - cos a) over pi: 2 / (distance^2 (1 + cos a)), without cancellation. A spot's cone is evaluated at
/// the centre.
LightSample from_ball(const FurLight& light, glm::vec3 position, glm::vec2 u) {
  LightSample centre = from_point(light, light.position, position);
  const float share = light.radius / centre.distance;  // sin a
  if (!(share > 0) || share >= 1) return centre;
  const float cosine = std::sqrt((1 - share) * (1 + share));
  const float missing = u.x * share * share / (1 + cosine);  // 1 - cosine to the centre
  const float sine = std::sqrt(missing * (2 - missing)) / share;
  const float half_chord = std::sqrt(std::max(0.0f, 1 - sine * sine));
  return {turned_off(centre.to_light, missing, 2 * glm::pi<float>() * u.y),
          centre.distance * std::max(1 - missing - share * half_chord, 0.0f), centre.radiance * (2 / (1 + cosine))};
}

LightSample from_rectangle(const FurLight& light, glm::vec3 position, glm::vec2 u) {
  const Axes axes = axes_across(light.direction);
  const glm::vec2 off = (u - 0.5f) * light.extent;
  return from_point(light, light.position + off.x * axes.right + off.y * axes.up, position);
}

}  // namespace

StrandLights::StrandLights(std::span<const FurLight> lights, const Environment& environment, double ambient)
    : lights_(lights.begin(), lights.end()), harmonics_(harmonics_of(environment)) {
  for (glm::dvec3& coefficient : harmonics_) coefficient *= ambient;
  tabulate();
}

LightSample StrandLights::sample(int i, glm::vec3 position, glm::vec2 u) const {
  const FurLight& light = lights_[static_cast<std::size_t>(i)];
  switch (light.kind) {
    case LightKind::directional: return from_disc(light, u);
    case LightKind::area: return from_rectangle(light, position, u);
    case LightKind::point:
    case LightKind::spot: break;
  }
  return from_ball(light, position, u);
}

float StrandLights::importance(int i, glm::vec3 position) const {
  const FurLight& light = lights_[static_cast<std::size_t>(i)];
  const bool far = light.kind == LightKind::directional;
  return luminance(far ? light.radiance : from_point(light, light.position, position).radiance);
}

glm::vec3 StrandLights::environment(glm::vec3 direction) const {
  return glm::vec3(glm::max(evaluate(harmonics_, glm::dvec3(direction)), 0.0));
}

namespace {

/// Returns a direction from its azimuth about +y and its height in y, both mapped to [0, 1]: uniform numbers give
/// uniform directions.
glm::vec3 direction_at(float across, float up) {
  const float y = 2 * up - 1, level = 2 * std::sqrt(std::max(0.0f, up * (1 - up)));
  const float around = 2 * glm::pi<float>() * across;
  return {level * std::cos(around), y, level * std::sin(around)};
}

struct Found {
  int index = 0;
  float within = 0;  // [0, 1)
};

/// Finds the interval of a CDF that contains u in [0, 1); never an empty one.
Found find_step(std::span<const float> sums, float u) {
  const auto above = std::upper_bound(sums.begin() + 1, sums.end() - 1, u);
  const float low = *(above - 1), high = *above;
  const float within = high > low ? (u - low) / (high - low) : 0;
  return {static_cast<int>(above - sums.begin()) - 1, std::clamp(within, 0.0f, 0x1.fffffep-1f)};
}

void cumulate(std::span<const double> parts, std::span<float> sums) {
  double total = 0, sum = 0;
  for (const double part : parts) total += part;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    sums[i] = static_cast<float>(sum / total);
    sum += parts[i];
  }
  sums[parts.size()] = 1;
}

}  // namespace

/// Builds the sampling table. A cell's weight is its light plus a small constant, so that no direction with light has a
/// pdf of 0.
void StrandLights::tabulate() {
  constexpr int finer = 4;
  std::vector<double> cells(std::size_t{rows} * columns), by_row(rows);
  double sum = 0;
  for (int row = 0; row < rows * finer; ++row) {
    for (int column = 0; column < columns * finer; ++column) {
      const glm::vec3 direction =
          direction_at((float(column) + 0.5f) / (columns * finer), (float(row) + 0.5f) / (rows * finer));
      const double shines = double(luminance(environment(direction))) / (finer * finer);
      cells[std::size_t(row / finer) * columns + std::size_t(column / finer)] += shines;
      sum += shines;
    }
  }
  const double mean = sum / double(cells.size());
  environment_bright_ = mean > 0;
  mean_environment_ = static_cast<float>(mean);
  row_sums_.resize(rows + 1), cell_sums_.resize(std::size_t{rows} * (columns + 1));
  for (std::size_t row = 0; row < rows; ++row) {
    const std::span<double> of_row = std::span(cells).subspan(row * columns, columns);
    for (double& cell : of_row) by_row[row] += cell = environment_bright_ ? cell + 0.01 * mean : 1;
    cumulate(of_row, std::span(cell_sums_).subspan(row * (columns + 1), columns + 1));
  }
  cumulate(by_row, row_sums_);
}

float StrandLights::cell_share(int row, int column) const {
  const auto r = static_cast<std::size_t>(row), c = r * (columns + 1) + static_cast<std::size_t>(column);
  return (row_sums_[r + 1] - row_sums_[r]) * (cell_sums_[c + 1] - cell_sums_[c]);
}

EnvironmentSample StrandLights::sample_environment(glm::vec2 u) const {
  const Found row = find_step(row_sums_, u.y);
  const auto first = static_cast<std::size_t>(row.index) * (columns + 1);
  const Found column = find_step(std::span(cell_sums_).subspan(first, columns + 1), u.x);
  const glm::vec3 direction =
      direction_at((float(column.index) + column.within) / columns, (float(row.index) + row.within) / rows);
  return {direction, environment(direction),
          cell_share(row.index, column.index) * (rows * columns / (4 * glm::pi<float>()))};
}

float StrandLights::environment_pdf(glm::vec3 direction) const {
  const float turn = std::atan2(direction.z, direction.x) / (2 * glm::pi<float>());
  const float across = turn < 0 ? turn + 1 : turn, up = (direction.y + 1) / 2;
  const int column = clamped_index(across * columns, 0, columns - 1);
  const int row = clamped_index(up * rows, 0, rows - 1);
  return cell_share(row, column) * (rows * columns / (4 * glm::pi<float>()));
}

}  // namespace pelage
