#include "renderer/strands/filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "base/parallel.h"

namespace pelage {

namespace {

constexpr int farthest = 6;                    // pixels; radius of the filter at 1 sample
static_assert(filter_margin == farthest + 3);  // 1 for silhouettes, 2 for the windows around a pixel
constexpr int band_rows = 32;
constexpr int block_pixels = 32;     // pixels of a row that are processed together
constexpr float min_albedo = 0.02f;  // added to albedo, so that highlights on black survive the division
constexpr float unknown = 1e9f;      // variance of a feature where too few pixels have it

/// Feature groups (tangent, normal, square root of albedo, logarithm of depth) and the filter's width in each of them
/// for features without noise.
constexpr int feature_groups = 4;
constexpr std::array<float, feature_groups> sharpness{0.2f, 0.25f, 0.08f, 0.012f};
constexpr std::array<int, feature_groups + 1> group_begins{0, 3, 6, 9, 10};
constexpr int features = 10;

/// The planes of a band, with one number for each pixel. Features are 0 where nothing was hit; `light` and `white`
/// (albedo + min_albedo) are premultiplied by body.
enum Plane : int {
  feature = 0,
  mean = features,                 // mean of each feature over 3 x 3 pixels
  noise = mean + features,         // variance of each group there
  guide = noise + feature_groups,  // each feature, with less noise
  falloff = guide + features,      // for each group, 1 / squared width
  body = falloff + feature_groups,
  light,
  light_end = light + 3,
  white = light_end,
  white_end = white + 3,
  over_reach = white_end,  // 1 / square of the filter's radius
  own_share,               // weight of a pixel's own features in its guide
  ground,                  // alpha without the body
  result,
  result_end = result + 3,  // light, filtered
  plane_count = result_end
};

/// Returns the radius of the filter in pixels: from 7 at 1 sample, where the farthest pixel with a weight is 6 away, to
/// 1, where no other pixel has a weight.
float reach_of(std::uint32_t samples) {
  if (samples >= filtered_samples) return 1;
  return 1 + farthest * (1 - std::log2(static_cast<float>(std::max(samples, 1u))) / 6);
}

using Lanes = std::array<float, block_pixels>;

/// Weighted sums for a block of pixels.
struct Sums {
  std::array<Lanes, 3> light{}, white{}, near_white{};
  Lanes near_body{};
};

/// A band of rows of a picture, with the pixels around it that the filter reads.
class Band {
 public:
  Band(const FilterSource& source, int top, int bottom);
  void filter();
  void write(FloatImage& image) const;

 private:
  float* row(int plane, int y) { return &planes_[offset(plane, y)]; }
  const float* row(int plane, int y) const { return &planes_[offset(plane, y)]; }
  /// Returns the offset of column 0 of a row of the picture.
  std::size_t offset(int plane, int y) const {
    return (static_cast<std::size_t>(plane * rows_ + (y - top_ + filter_margin)) * stride_) + filter_margin;
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(source_.width) + static_cast<std::size_t>(x);
  }
  void load(int y);
  void load_features(int x, int y);
  void judge_windows(int x, int y);
  void make_guides(int y);
  void gather(int x, int y);
  void add_tap(int x, int y, int dx, int dy, Sums& sums) const;
  void finish(int x, int y, const Sums& sums);
  glm::vec4 at_silhouette(int x, int y) const;
  float smooth_ground(int x, int y) const;

  const FilterSource& source_;
  int top_, bottom_, rows_;
  std::size_t stride_;
  bool has_ground_ = false;
  std::vector<float> planes_;
};

Band::Band(const FilterSource& source, int top, int bottom)
    : source_(source),
      top_(top),
      bottom_(bottom),
      rows_(bottom - top + 2 * filter_margin),
      stride_(static_cast<std::size_t>(source.width + 2 * filter_margin + block_pixels)),
      planes_(static_cast<std::size_t>(plane_count * rows_) * stride_) {
  for (int y = std::max(top - filter_margin, 0); y < std::min(bottom + filter_margin, source.height); ++y) load(y);
}

void Band::load(int y) {
  for (int x = 0; x < source_.width; ++x) {
    const std::size_t i = index(x, y);
    const float covered = source_.body[i], reach = reach_of(source_.samples[i]);
    row(body, y)[x] = covered;
    row(over_reach, y)[x] = 1 / (reach * reach);
    row(own_share, y)[x] = 1 - 1 / static_cast<float>(std::max(source_.samples[i], 1u));
    row(ground, y)[x] = std::max(source_.beauty[4 * i + 3] - covered, 0.0f);
    has_ground_ = has_ground_ || row(ground, y)[x] > 0;
    for (int c = 0; c < 3; ++c) {
      const std::size_t k = static_cast<std::size_t>(c);
      row(light + c, y)[x] = row(result + c, y)[x] = source_.beauty[4 * i + k];
      row(white + c, y)[x] = source_.albedo[3 * i + k] + min_albedo * covered;
    }
    if (covered > 0) load_features(x, y);
  }
}

void Band::load_features(int x, int y) {
  const std::size_t i = index(x, y);
  const float over = 1 / source_.body[i];
  for (int c = 0; c < 3; ++c) {
    const std::size_t k = 3 * i + static_cast<std::size_t>(c);
    row(feature + c, y)[x] = source_.tangent[k] * over;
    row(feature + 3 + c, y)[x] = source_.normal[k] * over;
    row(feature + 6 + c, y)[x] = std::sqrt(std::max(source_.albedo[k] * over, 0.0f));
  }
  const float nearness = source_.depth[2 * i], share = source_.depth[2 * i + 1];
  row(feature + 9, y)[x] = nearness > 0 && share > 0 ? std::log(nearness / share) : 0;
}

/// Computes the mean and variance of features in the 3 x 3 windows around a block's pixels.
void Band::judge_windows(int x, int y) {
  Lanes count{};
  const auto over_window = [&](int plane, auto&& add) {
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        const float* values = row(plane, v) + u;
        for (std::size_t i = 0; i < block_pixels; ++i) add(i, values[i]);
      }
    }
  };
  over_window(body, [&](std::size_t i, float value) { count[i] += value > 0 ? 1.0f : 0.0f; });
  for (int group = 0; group < feature_groups; ++group) {
    Lanes spread{};
    for (int k = group_begins[std::size_t(group)]; k < group_begins[std::size_t(group) + 1]; ++k) {
      Lanes sum{}, squares{};
      over_window(feature + k, [&](std::size_t i, float value) { sum[i] += value, squares[i] += value * value; });
      float* means = row(mean + k, y) + x;
      for (std::size_t i = 0; i < block_pixels; ++i) {
        means[i] = sum[i] / std::max(count[i], 1.0f);
        spread[i] += std::max(squares[i] - sum[i] * means[i], 0.0f);
      }
    }
    float* variance = row(noise + group, y) + x;
    for (std::size_t i = 0; i < block_pixels; ++i) variance[i] = count[i] > 3 ? spread[i] / (count[i] - 1) : unknown;
  }
}

/// Makes the guides, by which pixels are compared. Features of few samples are noisy and would select pixels by chance,
/// with a bias to common values. So each is blended with the mean of the least noisy of the four windows that have the
/// pixel in a corner, because an edge lies in the other windows (Kuwahara 1976). The noise that remains lowers a
/// feature's weight.
void Band::make_guides(int y) {
  for (int group = 0; group < feature_groups; ++group) {
    const int begin = group_begins[std::size_t(group)], end = group_begins[std::size_t(group) + 1];
    const float sharp = sharpness[std::size_t(group)];
    for (int x = 0; x < source_.width; ++x) {
      glm::ivec2 best(x - 1, y - 1);
      for (const glm::ivec2 other : {glm::ivec2(x + 1, y - 1), {x - 1, y + 1}, {x + 1, y + 1}}) {
        if (row(noise + group, other.y)[other.x] < row(noise + group, best.y)[best.x]) best = other;
      }
      const float min = row(noise + group, best.y)[best.x];
      const bool known = min < unknown && row(body, y)[x] > 0;
      const float own = known ? row(own_share, y)[x] : 1, drawn = 1 - own;
      for (int k = begin; k < end; ++k)
        row(guide + k, y)[x] = own * row(feature + k, y)[x] + drawn * row(mean + k, best.y)[best.x];
      const float left = known ? min * (own * own + drawn * drawn / 9) : 0;
      row(falloff + group, y)[x] = 1 / (2 * sharp * sharp + 32 * left);
    }
  }
}

/// Adds light from the pixels at an offset, weighted by similarity: about exp(-difference), and 0 beyond the radius.
/// Albedo itself is averaged over a smaller radius.
void Band::add_tap(int x, int y, int dx, int dy, Sums& sums) const {
  Lanes difference{}, weight;
  for (int group = 0; group < feature_groups; ++group) {
    Lanes square{};
    for (int k = group_begins[std::size_t(group)]; k < group_begins[std::size_t(group) + 1]; ++k) {
      const float *own = row(guide + k, y) + x, *other = row(guide + k, y + dy) + x + dx;
      for (std::size_t i = 0; i < block_pixels; ++i) square[i] += (own[i] - other[i]) * (own[i] - other[i]);
    }
    const float* over = row(falloff + group, y) + x;
    for (std::size_t i = 0; i < block_pixels; ++i) difference[i] += square[i] * over[i];
  }
  const float* over = row(over_reach, y) + x;
  const float apart = static_cast<float>(dx * dx + dy * dy);
  for (std::size_t i = 0; i < block_pixels; ++i) {
    const float alike = std::max(1 - difference[i] / 8, 0.0f), near = std::max(1 - apart * over[i], 0.0f);
    const float fourth = alike * alike * alike * alike;
    weight[i] = fourth * fourth * near;
  }
  const auto add = [&](int plane, const Lanes& weights, Lanes& sum) {
    const float* other = row(plane, y + dy) + x + dx;
    for (std::size_t i = 0; i < block_pixels; ++i) sum[i] += weights[i] * other[i];
  };
  for (int c = 0; c < 3; ++c) add(light + c, weight, sums.light[std::size_t(c)]);
  for (int c = 0; c < 3; ++c) add(white + c, weight, sums.white[std::size_t(c)]);
  if (4 * (dx * dx + dy * dy) > farthest * farthest) return;
  for (std::size_t i = 0; i < block_pixels; ++i) weight[i] *= std::max(1 - 4 * apart * over[i], 0.0f);
  for (int c = 0; c < 3; ++c) add(white + c, weight, sums.near_white[std::size_t(c)]);
  add(body, weight, sums.near_body);
}

void Band::gather(int x, int y) {
  float min = 1;
  for (int i = x; i < x + block_pixels; ++i) {
    if (row(body, y)[i] > 0) min = std::min(min, row(over_reach, y)[i]);
  }
  if (min == 1) return;
  Sums sums;
  for (int dy = -farthest; dy <= farthest; ++dy) {
    for (int dx = -farthest; dx <= farthest; ++dx) {
      const int square = dx * dx + dy * dy;
      if (square > 9 && (dx + dy) % 2 != 0) continue;  // every other one of the far pixels suffices
      if (static_cast<float>(square) * min < 1) add_tap(x, y, dx, dy, sums);
    }
  }
  finish(x, y, sums);
}

/// Divides the sum of light by the sum of albedo, so that the mean is preserved where both vary together.
void Band::finish(int x, int y, const Sums& sums) {
  for (std::size_t i = 0; i < block_pixels; ++i) {
    const int u = x + static_cast<int>(i);
    const float covered = row(body, y)[u];
    if (!(covered > 0) || row(over_reach, y)[u] == 1 || u >= source_.width) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const float own = covered * sums.near_white[c][i] / sums.near_body[i];
      row(result + int(c), y)[u] = own * sums.light[c][i] / sums.white[c][i];
    }
  }
}

void Band::filter() {
  for (int y = top_ - filter_margin + 1; y < bottom_ + filter_margin - 1; ++y) {
    for (int x = -1; x <= source_.width; x += block_pixels) judge_windows(x, y);
  }
  for (int y = top_ - filter_margin + 2; y < bottom_ + filter_margin - 2; ++y) make_guides(y);
  for (int y = std::max(top_ - 1, 0); y < std::min(bottom_ + 1, source_.height); ++y) {
    for (int x = 0; x < source_.width; x += block_pixels) gather(x, y);
  }
}

/// Returns light and the body's alpha. At silhouettes they are smoothed over 3 x 3 pixels, less with more samples.
glm::vec4 Band::at_silhouette(int x, int y) const {
  const float share = 0.75f * (1 / std::sqrt(row(over_reach, y)[x]) - 1) / farthest;
  glm::vec4 own(0), mean(0);
  float min = 1, max = 0, sum = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, source_.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, source_.width - 1); ++u) {
      const glm::vec4 value(row(result, v)[u], row(result + 1, v)[u], row(result + 2, v)[u], row(body, v)[u]);
      const float weight = (u == x ? 2.0f : 1.0f) * (v == y ? 2.0f : 1.0f);
      if (u == x && v == y) own = value;
      mean += weight * value, sum += weight;
      min = std::min(min, value.a), max = std::max(max, value.a);
    }
  }
  return min < max ? own + share * (mean / sum - own) : own;
}

/// Returns the ground's alpha over the area that the body leaves open, averaged over the filter's radius.
float Band::smooth_ground(int x, int y) const {
  const float over = row(over_reach, y)[x];
  float dark = 0, uncovered = 0;
  for (int dy = -farthest; dy <= farthest; ++dy) {
    for (int dx = -farthest; dx <= farthest; ++dx) {
      const float weight = std::max(1 - static_cast<float>(dx * dx + dy * dy) * over, 0.0f);
      if (x + dx < 0 || x + dx >= source_.width || y + dy < 0 || y + dy >= source_.height) continue;
      dark += weight * row(ground, y + dy)[x + dx];
      uncovered += weight * (1 - row(body, y + dy)[x + dx]);
    }
  }
  return uncovered > 0 ? dark / uncovered : 0;
}

void Band::write(FloatImage& image) const {
  for (int y = top_; y < bottom_; ++y) {
    for (int x = 0; x < source_.width; ++x) {
      const std::size_t i = 4 * index(x, y);
      const bool unfiltered = row(over_reach, y)[x] == 1;
      glm::vec4 pixel(0);
      if (!unfiltered) pixel = at_silhouette(x, y);
      if (!unfiltered && has_ground_ && pixel.a < 1) pixel.a += (1 - pixel.a) * smooth_ground(x, y);
      for (int c = 0; c < 4; ++c) {
        const std::size_t k = i + static_cast<std::size_t>(c);
        image.rgba[k] = unfiltered ? source_.beauty[k] : pixel[c];
      }
    }
  }
}

}  // namespace

FloatImage filter_beauty(const FilterSource& source, int threads) {
  FloatImage image{source.width, source.height, std::vector<float>(source.beauty.size())};
  const int bands = (source.height + band_rows - 1) / band_rows;
  const auto work = [&](std::uint32_t i) {
    const int band = static_cast<int>(i);
    Band part(source, band * band_rows, std::min((band + 1) * band_rows, source.height));
    part.filter();
    part.write(image);
  };
  for_each_in_parallel(static_cast<std::uint32_t>(bands), work, threads > 0 ? threads : default_threads());
  return image;
}

}  // namespace pelage
