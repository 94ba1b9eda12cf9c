// What the passes of a traced picture add up to, and how noisy it still is.
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

/// What one ray through a pixel saw. All but radiance and alpha are of the first hit, 0 where there was none.
struct FilmSample {
  glm::vec3 radiance{0};  // multiplied by alpha
  float alpha = 0;        // [0, 1]; the ground darkens: black with an alpha
  float body = 0;         // the same without the ground
  float over_depth = 0;   // 1 / distance along the view, 1 / sizes; 0 for none
  glm::vec3 position{0}, normal{0}, tangent{0}, albedo{0};
  glm::vec3 direct{0};               // of lights alone, without the ambient part
  glm::vec2 light{0};                // luminance of that, and what it would be without shadows
  std::size_t object = skin_object;  // what was hit (fur_scene.h)
};

/// Means of samples by pixel. AOVs that are not asked for take no memory: 4 bytes a pixel for their count, 20 for
/// beauty, 48 for what the filter looks at and the AOVs of it, 12 each for position and direct, 8 for shadow, 44 for
/// cryptomatte. Pixels
/// are added to from one thread at a time; a tile belongs to one thread during a pass.
class Film {
 public:
  static constexpr int tile = 16;  // pixels along the side of the parts that noise is judged by

  /// Bytes that a film of this size takes.
  static std::size_t bytes(int width, int height, std::span<const Aov> aovs, bool filter);
  /// With a crop, only the tiles that its pixels are made of are added to.
  Film(int width, int height, std::span<const Aov> aovs, bool filter, const std::optional<Crop>& crop = {});

  std::size_t bytes() const;
  int width() const { return width_; }
  int height() const { return height_; }
  int tiles_across() const { return (width_ + tile - 1) / tile; }
  /// Numbers of the tiles that are added to, ascending.
  std::span<const int> tiles() const { return tiles_; }

  void add(int x, int y, const FilmSample& sample);
  int samples(int x, int y) const;  // so far
  double mean_samples() const;      // of a pixel of the tiles

  /// Estimated mean absolute error of a shown channel (sRGB of the filmic tone mapped mean, [0, 1]) over a tile's
  /// pixels: from the spread of each pixel's samples; infinity where a pixel has fewer than 4, or for a film without
  /// beauty. `exposure` in stops.
  double noise(int tile, double exposure) const;
  /// The same over the pixels of all tiles where anything was seen, 0 where there are none.
  double noise(double exposure) const;

  /// Returns means, in the conventions of Renderer::draw_aovs (depth: one over the distance). `filtered` smooths beauty
  /// by direction, depth and colour, the less the more samples there are, and not at all from 64 a pixel on. The AOV
  /// has to have been asked for, and `filtered` needs a film with the filter.
  FloatImage aov(Aov aov, bool filtered) const;

 private:
  /// Running means in float do not drift: what a sample adds shrinks as its weight does.
  enum Part { beauty, spread, body, depth, position, normal, tangent, albedo, direct, light, objects, part_count };
  static constexpr std::array<std::size_t, part_count> widths{4, 1, 1, 2, 3,          3,
                                                              3, 3, 3, 2, max_objects};  // numbers a pixel

  static std::array<bool, part_count> parts_of(std::span<const Aov> aovs, bool filter);
  const float* at(Part part, std::size_t pixel) const { return &means_[part][pixel * widths[part]]; }
  struct Noise {
    double sum = 0;  // of the pixels' errors
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
  double shown_error(std::size_t pixel, double exposure) const;
  TileBox box_of(int tile) const;
  Noise judge(int tile, double exposure) const;
  bool can_filter() const;
  FloatImage filtered_beauty() const;
  glm::vec4 aov_at(Aov aov, std::size_t pixel) const;

  int width_, height_;
  std::vector<int> tiles_;
  std::vector<std::uint32_t> samples_;
  std::array<std::vector<float>, part_count> means_;  // spread: of the squared luminance about its mean
};

}  // namespace pelage
