#include "renderer/strands/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

#include "base/colour_space.h"
#include "renderer/strands/filter.h"

namespace pelage {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t judged_samples = 4;  // samples of a pixel before its variance is used

/// Returns linear light as renderer/finish/encode.cpp displays it.
double displayed(double linear) {
  const double x = 0.72 * std::clamp(linear, 0.0, 1e4);
  return srgb_from_linear(std::min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1.0));
}

}  // namespace

std::array<bool, Film::part_count> Film::parts_of(std::span<const Aov> aovs, bool filter) {
  std::array<bool, part_count> parts{};
  const auto need = [&](std::initializer_list<Part> needed) {
    for (const Part part : needed) parts[part] = true;
  };
  for (const Aov aov : aovs) {
    switch (aov) {
      case Aov::beauty: need({beauty, spread}); break;
      case Aov::alpha: need({beauty}); break;
      case Aov::depth: need({body, depth}); break;
      case Aov::position: need({body, position}); break;
      case Aov::normal: need({body, normal}); break;
      case Aov::tangent: need({body, tangent}); break;
      case Aov::albedo: need({body, albedo}); break;
      case Aov::direct: need({body, direct}); break;
      case Aov::shadow: need({body, light}); break;
      case Aov::sample_count: need({body}); break;
      case Aov::objects_1:
      case Aov::objects_2:
      case Aov::objects_3:
      case Aov::objects_4: need({body, objects}); break;
      case Aov::strand:
      case Aov::root:                        // not traced: samples of a pixel hit many strands
      case Aov::cryptomatte: assert(false);  // requested as its parts, objects_1 to objects_4
    }
  }
  if (filter && parts[beauty]) need({body, depth, normal, tangent, albedo});
  return parts;
}

std::size_t Film::bytes(int width, int height, std::span<const Aov> aovs, bool filter) {
  const std::array<bool, part_count> parts = parts_of(aovs, filter);
  std::size_t each = sizeof(std::uint32_t);
  for (std::size_t part = 0; part < part_count; ++part) each += parts[part] ? widths[part] * sizeof(float) : 0;
  return each * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::size_t Film::bytes() const {
  std::size_t numbers = samples_.size();
  for (const std::vector<float>& part : means_) numbers += part.size();
  return numbers * sizeof(float);
}

Film::Film(int width, int height, std::span<const Aov> aovs, bool filter, const std::optional<Crop>& crop)
    : width_(width), height_(height) {
  const Crop wanted = crop.value_or(Crop{0, 0, width, height});
  const int beside = filter ? filter_margin : 0;  // pixels that the filter reads around the crop
  const int tile_count = tiles_across() * ((height + tile - 1) / tile);
  for (int number = 0; number < tile_count; ++number) {
    const TileBox box = box_of(number);
    if (box.right > wanted.left - beside && box.left < wanted.left + wanted.width + beside &&
        box.bottom > wanted.top - beside && box.top < wanted.top + wanted.height + beside)
      tiles_.push_back(number);
  }
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::array<bool, part_count> parts = parts_of(aovs, filter);
  samples_.resize(pixels);
  for (std::size_t part = 0; part < part_count; ++part) means_[part].resize(parts[part] ? pixels * widths[part] : 0);
}

void Film::add(int x, int y, const FilmSample& s) {
  const std::size_t pixel = index(x, y);
  const float share = 1 / static_cast<float>(++samples_[pixel]);
  const auto keep = [&](Part part, std::initializer_list<float> values) {
    if (means_[part].empty()) return;
    float* mean = &means_[part][pixel * widths[part]];
    for (const float value : values) *mean += (value - *mean) * share, ++mean;
  };
  const auto keep_colour = [&](Part part, glm::vec3 c) { keep(part, {c.x, c.y, c.z}); };
  // Welford 1962: the deviation from the mean before, times the deviation from the mean after.
  const auto off_mean = [&] { return means_[spread].empty() ? 0 : luminance(s.radiance - colour(beauty, pixel)); };
  const float before = off_mean();
  keep(beauty, {s.radiance.r, s.radiance.g, s.radiance.b, s.alpha});
  keep(spread, {before * off_mean()});
  keep(body, {s.body});
  keep(depth, {s.over_depth, s.over_depth > 0 ? 1.0f : 0.0f});
  keep_colour(position, s.position * s.body);
  keep_colour(normal, s.normal * s.body);
  keep_colour(tangent, s.tangent * s.body);
  keep_colour(albedo, s.albedo * s.body);
  keep_colour(direct, s.direct);
  keep(light, {s.light.x, s.light.y});
  if (means_[objects].empty()) return;
  float* shares = &means_[objects][pixel * max_objects];
  for (std::size_t k = 0; k < max_objects; ++k) shares[k] += ((k == s.object ? s.body : 0) - shares[k]) * share;
}

int Film::samples(int x, int y) const { return static_cast<int>(samples_[index(x, y)]); }

double Film::mean_samples() const {
  double sum = 0, pixels = 0;
  for (const int number : tiles_) {
    const TileBox box = box_of(number);
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) sum += samples_[index(x, y)];
    }
    pixels += static_cast<double>(box.right - box.left) * (box.bottom - box.top);
  }
  return pixels > 0 ? sum / pixels : 0;
}

Film::TileBox Film::box_of(int number) const {
  const int left = number % tiles_across() * tile, top = number / tiles_across() * tile;
  return {left, top, std::min(left + tile, width_), std::min(top + tile, height_)};
}

glm::vec3 Film::colour(Part part, std::size_t pixel) const {
  const float* mean = at(part, pixel);
  return {mean[0], mean[1], mean[2]};
}

/// Returns the error of the displayed value: half the difference between mean + standard error and mean - standard
/// error as displayed, times the mean of |x| of a normal distribution. Alpha divides mean and error before tone mapping
/// and multiplies the displayed value after it.
double Film::displayed_error(std::size_t pixel, double exposure) const {
  const double count = samples_[pixel], alpha = double(at(beauty, pixel)[3]);
  if (!(alpha > 0)) return 0;
  const double factor = std::exp2(exposure) / alpha;
  const double mean = factor * double(luminance(colour(beauty, pixel)));
  const double error = factor * std::sqrt(std::max(double(*at(spread, pixel)), 0.0) / (count - 1));
  return std::min(alpha, 1.0) * (displayed(mean + error) - displayed(mean - error)) / 2 *
         std::sqrt(2 / std::numbers::pi);
}

Film::Noise Film::estimate_noise(int number, double exposure) const {
  const auto [left, top, right, bottom] = box_of(number);
  Noise noise{0, (right - left) * (bottom - top), false};
  if (means_[spread].empty()) noise.sum = infinity;
  for (int y = top; y < bottom && noise.sum < infinity; ++y) {
    for (int x = left; x < right; ++x) {
      const std::size_t pixel = index(x, y);
      noise.sum += samples_[pixel] < judged_samples ? infinity : displayed_error(pixel, exposure);
      noise.seen = noise.seen || at(beauty, pixel)[3] > 0;
    }
  }
  return noise;
}

double Film::noise(int number, double exposure) const {
  const Noise noise = estimate_noise(number, exposure);
  return noise.sum / noise.pixels;
}

double Film::noise(double exposure) const {
  Noise all;
  for (const int number : tiles_) {
    const Noise noise = estimate_noise(number, exposure);
    if (!noise.seen && noise.sum < infinity) continue;
    all.sum += noise.sum;
    all.pixels += noise.pixels;
  }
  return all.pixels > 0 ? all.sum / all.pixels : 0;
}

/// Returns an AOV of a pixel in the conventions of Renderer::draw_aovs.
glm::vec4 Film::aov_at(Aov aov, std::size_t pixel) const {
  const float covered = means_[body].empty() ? 0 : std::clamp(*at(body, pixel), 0.0f, 1.0f);
  const auto with_coverage = [&](Part part) { return glm::vec4(colour(part, pixel), covered); };
  const auto unit = [&](Part part) {
    const glm::vec3 sum = colour(part, pixel);
    return glm::vec4(glm::dot(sum, sum) > 1e-12f ? glm::normalize(sum) : glm::vec3(0), covered);
  };
  switch (aov) {
    case Aov::beauty:
    case Aov::alpha: return {colour(beauty, pixel), at(beauty, pixel)[3]};
    case Aov::depth: {
      const float *mean = at(depth, pixel), nearness = mean[1] >= 0.5f ? mean[0] / mean[1] : 0;
      return {nearness, 0, 0, covered};
    }
    case Aov::position: return {covered > 0 ? colour(position, pixel) / covered : glm::vec3(0), covered};
    case Aov::normal: return unit(normal);
    case Aov::tangent: return unit(tangent);
    case Aov::albedo: return with_coverage(albedo);
    case Aov::direct: return with_coverage(direct);
    case Aov::shadow: {
      const float* mean = at(light, pixel);
      return {glm::vec3(mean[1] > 0 ? std::clamp(mean[0] / mean[1], 0.0f, 1.0f) : 1.0f), covered};
    }
    case Aov::sample_count: return {glm::vec3(static_cast<float>(samples_[pixel])), covered};
    case Aov::objects_1:
    case Aov::objects_2:
    case Aov::objects_3:
    case Aov::objects_4: {
      glm::vec4 shares(0, 0, 0, covered);
      const std::size_t first = first_object(aov), end = std::min(first + 3, max_objects);
      for (std::size_t k = first; k < end; ++k) shares[static_cast<int>(k - first)] = at(objects, pixel)[k];
      return shares;
    }
    case Aov::strand:
    case Aov::root:
    case Aov::cryptomatte: break;
  }
  assert(false);
  return {};
}

bool Film::can_filter() const {
  return !means_[beauty].empty() && !means_[depth].empty() && !means_[normal].empty() && !means_[tangent].empty() &&
         !means_[albedo].empty();
}

FloatImage Film::filtered_beauty() const {
  return filter_beauty({.width = width_,
                        .height = height_,
                        .samples = samples_,
                        .beauty = means_[beauty],
                        .body = means_[body],
                        .depth = means_[depth],
                        .normal = means_[normal],
                        .tangent = means_[tangent],
                        .albedo = means_[albedo]});
}

FloatImage Film::aov(Aov aov, bool filtered) const {
  const bool shows_light = aov == Aov::beauty || aov == Aov::alpha;
  if (filtered && shows_light && can_filter()) return filtered_beauty();
  FloatImage image{width_, height_, {}};
  image.rgba.reserve(samples_.size() * 4);
  for (std::size_t pixel = 0; pixel < samples_.size(); ++pixel) {
    const glm::vec4 value = aov_at(aov, pixel);
    image.rgba.insert(image.rgba.end(), {value.r, value.g, value.b, value.a});
  }
  return image;
}

}  // namespace pelage
