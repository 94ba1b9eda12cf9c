#include "server/export/card_texture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/clamped_index.h"
#include "base/colour_space.h"
#include "base/random.h"

namespace pelage {

namespace {

constexpr int lock_width = 128, lock_height = 256;  // texels
constexpr int margin = 6;                           // texels without a strand at each side of a lock
constexpr int strands_of_lock = 56;

/// One strand of a lock. `root` and `sway` are in texels, `root` from the lock's left; `reach` is a share of the lock's
/// height. `height` is a share of the lock's height, too, from the root.
struct LockStrand {
  double root = 0, sway = 0, reach = 1, lightness = 1;

  double middle(double height) const { return root + sway * height * height; }
};

LockStrand random_strand(Random& random) {
  constexpr double inner = lock_width - 2 * margin;
  LockStrand strand;
  strand.root = margin + inner * random.uniform(0.08, 0.92);
  const double gathered = 0.35 * (0.5 * lock_width - strand.root);  // tips of a lock converge
  strand.sway = std::clamp(gathered + 0.12 * inner * (random.uniform() - 0.5), margin - strand.root,
                           lock_width - margin - strand.root);
  strand.reach = random.uniform(0.35, 1);
  strand.lightness = random.uniform(0.75, 1.25);
  return strand;
}

class Lock {
 public:
  Lock() : lightness_(texels, 1), opacity_(texels, 0) {}

  /// `root` and `tip` are half widths in texels.
  void draw(const LockStrand& strand, double root, double tip) {
    for (int y = 0; y < lock_height; ++y) {
      const double height = (lock_height - y - 0.5) / lock_height, along = height / strand.reach;
      if (along > 1) continue;
      draw_row(y, strand.middle(height), root + along * (tip - root), strand.lightness);
    }
  }

  void copy_to(Image& image, int left) const {
    const auto byte = [](double value) {
      return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    for (int y = 0; y < lock_height; ++y) {
      for (int x = 0; x < lock_width; ++x) {
        const std::size_t from = index(x, y);
        std::uint8_t* to = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(left + x))];
        std::fill_n(to, 3, byte(srgb_from_linear(double{card_lightness} * lightness_[from])));
        to[3] = byte(opacity_[from]);
      }
    }
  }

 private:
  static constexpr std::size_t texels = std::size_t{lock_width} * lock_height;

  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * lock_width + static_cast<std::size_t>(x);
  }

  /// Composites a span of a row over earlier strands, by its coverage of each texel.
  void draw_row(int y, double middle, double half, double lightness) {
    const int first = clamped_index(middle - half, 0, lock_width);
    const int last = clamped_index(std::floor(middle + half), -1, lock_width - 1);
    for (int x = first; x <= last; ++x) {
      const double cover = std::min(middle + half, x + 1.0) - std::max(middle - half, static_cast<double>(x));
      const std::size_t at = index(x, y);
      const double before = opacity_[at], after = cover + before * (1 - cover);
      if (!(cover > 0)) continue;
      lightness_[at] = (cover * lightness + before * (1 - cover) * lightness_[at]) / after;
      opacity_[at] = after;
    }
  }

  std::vector<double> lightness_, opacity_;
};

}  // namespace

Image card_texture(const Coat& coat, double width) {
  constexpr double thinnest = 0.35;  // texels; thinner strands would be invisible
  const double texels_per_size = lock_width / width;
  const auto half = [&](double strand_width) {
    return std::clamp(0.5 * strand_width * texels_per_size, thinnest, 0.1 * lock_width);
  };
  Image image{card_locks * lock_width, lock_height, {}};
  image.rgba.resize(std::size_t{4} * card_locks * lock_width * lock_height);
  for (int k = 0; k < card_locks; ++k) {
    Random random(coat.seed, static_cast<std::uint64_t>(k));
    Lock lock;
    for (int i = 0; i < strands_of_lock; ++i)
      lock.draw(random_strand(random), half(coat.width_root), half(coat.width_tip));
    lock.copy_to(image, k * lock_width);
  }
  return image;
}

}  // namespace pelage
