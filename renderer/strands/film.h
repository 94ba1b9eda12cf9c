// Accumulates the passes of a traced picture and estimates its remaining noise.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// The result of one camera ray. Everything except radiance and alpha belongs to the first hit and is 0 if there was
/// none.
struct FilmSample {
  glm::vec3 radiance{0};  // premultiplied by alpha
  float alpha = 0;        // [0, 1]; the ground's shadow is black with an alpha
  float body = 0;         // alpha without the ground, [0, 1]
  float over_depth = 0;   // 1 / distance along the view direction, 1 / sizes; 0 for none
  glm::vec3 position{0}, normal{0}, tangent{0}, albedo{0};
  glm::vec3 direct{0};               // radiance from lights alone, without the ambient part
  glm::vec2 light{0};                // luminance of `direct`, with and without shadows
  std::size_t object = skin_object;  // object that was hit (fur_scene.h)
};

/// Means of samples by pixel. AOVs that were not requested take no memory: 4 bytes a pixel for the sample count, 20 for
/// beauty, 48 for the filter's features and the AOVs of them, 12 each for position and direct, 8 for shadow, 44 for
/// cryptomatte. A pixel must not be added to by two threads at once; each tile belongs to one thread during a pass.
class Film {
 public:
  static constexpr int tile = 16;  // pixels along a side of the tiles for which noise is estimated

  /// Returns the bytes that such a film takes.
  static std::size_t bytes(int width, int height, std::span<const Aov> aovs, bool filter);
  /// With a crop, only the tiles that its pixels depend on are added to.
  Film(int width, int height, std::span<const Aov> aovs, bool filter, const std::optional<Crop>& crop = {});

  std::size_t bytes() const;
  int width() const { return width_; }
  int height() const { return height_; }
  int tiles_across() const { return (width_ + tile - 1) / tile; }
  /// Returns the numbers of the tiles that are added to, ascending.
  std::span<const int> tiles() const { return tiles_; }

  void add(int x, int y, const FilmSample& sample);
  int samples(int x, int y) const;  // number of samples so far
  double mean_samples() const;      // mean number of samples of a pixel in the tiles

  /// Returns the estimated mean absolute error of a displayed channel (sRGB of the filmic tone-mapped mean, [0, 1])
  /// over a tile's pixels, from the variance of each pixel's samples. Infinity if a pixel has fewer than 4 samples or
  /// the film has no beauty. `exposure` in stops.
  double noise(int tile, double exposure) const;
  /// Returns the same over all tiles where anything was hit; 0 if there are none.
  double noise(double exposure) const;

  /// Returns an AOV of means, in the conventions of Renderer::draw_aovs (depth: 1 / distance). `filtered` denoises
  /// beauty by direction, depth and colour, less with more samples, and not at all from 64 samples a pixel on. The AOV
  /// must have been requested, and `filtered` needs a film with the filter.
  FloatImage aov(Aov aov, bool filtered) const;

 private:
  /// Means are updated incrementally in float. They do not drift, because a new sample's weight shrinks as their count
  /// grows.
  enum Part { beauty, spread, body, depth, position, normal, tangent, albedo, direct, light, objects, part_count };
  static constexpr std::array<std::size_t, part_count> widths{4, 1, 1, 2, 3,          3,
                                                              3, 3, 3, 2, max_objects};  // numbers for each pixel

  static std::array<bool, part_count> parts_of(std::span<const Aov> aovs, bool filter);
  const float* at(Part part, std::size_t pixel) const { return &means_[part][pixel * widths[part]]; }
  struct Noise {
    double sum = 0;  // sum of the pixels' errors
    int pixels = 0;
    bool seen = false;
  };
  struct TileBox {
    int left, top, right, bottom;
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  glm::vec3 colour(Part part, std::size_t pixel) const;
  double displayed_error(std::size_t pixel, double exposure) const;
  TileBox box_of(int tile) const;
  Noise estimate_noise(int tile, double exposure) const;
  bool can_filter() const;
  FloatImage filtered_beauty() const;
  glm::vec4 aov_at(Aov aov, std::size_t pixel) const;

  int width_, height_;
  std::vector<int> tiles_;
  std::vector<std::uint32_t> samples_;
  std::array<std::vector<float>, part_count> means_;  // `spread`: variance of the luminance
};

}  // namespace pelage
