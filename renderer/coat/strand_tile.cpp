#include "renderer/coat/strand_tile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "protocol/base/random.h"

namespace pelage {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// What the strands of one tuft share.
struct Clump {
  glm::dvec2 centre{0};
  glm::dvec2 bow{0};
  double length = 1, lightness = 1;  // [-1, 1]
  double pull = 1;                   // [0, 1]: tufts are not all alike
};

class ClumpGrid {
 public:
  explicit ClumpGrid(const Coat& coat)
      : tile_(coat.tile), side_(std::max(1, static_cast<int>(std::lround(coat.tile / coat.clump_size)))) {
    Random random(coat.seed, 1);
    for (int i = 0; i < side_ * side_; ++i) clumps_.push_back(make_clump(i, random));
  }

  /// The nearest clump on the periodic tile, its centre moved by whole tiles to lie next to `place`.
  Clump nearest(glm::dvec2 place) const {
    const glm::ivec2 cell(glm::floor(place / tile_ * double(side_)));
    Clump best;
    double best_distance = 1e300;
    for (int y = cell.y - 2; y <= cell.y + 2; ++y) {
      for (int x = cell.x - 2; x <= cell.x + 2; ++x) {
        Clump clump = clumps_[static_cast<std::size_t>(wrap(y) * side_ + wrap(x))];
        clump.centre += glm::dvec2(x - wrap(x), y - wrap(y)) * (tile_ / side_);
        const double distance = glm::distance(clump.centre, place);
        if (distance < best_distance) best = clump, best_distance = distance;
      }
    }
    return best;
  }

 private:
  int wrap(int i) const { return (i % side_ + side_) % side_; }

  Clump make_clump(int index, Random& random) const {
    const glm::dvec2 cell(index % side_, index / side_);
    const glm::dvec2 jitter(random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2));
    const double angle = random.uniform(0, turn), reach = random.uniform();
    return {(cell + jitter) * (tile_ / side_), glm::dvec2(std::cos(angle), std::sin(angle)) * reach,
            random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.25, 1)};
  }

  double tile_;
  int side_;
  std::vector<Clump> clumps_;
};

/// Even but not regular for any count: the R2 low-discrepancy sequence (Roberts 2018), which fits a torus, with jitter.
glm::dvec2 root_place(const Coat& coat, int index, Random& random) {
  const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
  const glm::dvec2 jitter(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
  return glm::fract(step * (index + 1.0) + jitter / std::sqrt(static_cast<double>(coat.count))) * coat.tile;
}

}  // namespace

std::vector<Strand> make_strands(const Coat& coat) {
  assert(coat.count >= 1 && coat.tile > 0 && coat.clump_size > 0);
  const ClumpGrid clumps(coat);
  Random random(coat.seed);
  std::vector<Strand> strands;
  strands.reserve(static_cast<std::size_t>(coat.count));
  for (int i = 0; i < coat.count; ++i) {
    Strand strand;
    strand.root = root_place(coat, i, random);
    const Clump clump = clumps.nearest(strand.root);
    const double angle = random.uniform(0, turn), own = random.uniform(), of_clump = coat.clump;
    strand.clump = (clump.centre - strand.root) * clump.pull;
    strand.bow = coat.bend * nominal_length *
                 glm::mix(glm::dvec2(std::cos(angle), std::sin(angle)) * random.uniform(), clump.bow, of_clump * 0.8);
    strand.curl_phase = random.uniform(0, turn);
    const double shorter = glm::mix(own, 0.5 - 0.5 * clump.length, of_clump * 0.4);
    strand.length_share = std::max(0.02, 1 - coat.length_spread * shorter);
    const double lighter = glm::mix(random.uniform(-1, 1), clump.lightness, of_clump * 0.35);
    strand.lightness = std::exp2(2 * coat.colour_spread * lighter);
    strand.number = random.uniform();
    strands.push_back(strand);
  }
  return strands;
}

glm::dvec2 strand_offset(const Coat& coat, const Strand& strand, double q) {
  const double gather = coat.clump * q * std::sqrt(q);
  const double angle = strand.curl_phase + turn * coat.curl_turns * q;
  const glm::dvec2 helix = glm::dvec2(std::cos(angle), std::sin(angle)) * (coat.curl * nominal_length * std::min(1.0, 4 * q));
  return strand.clump * gather + strand.bow * (q * q) + helix;
}

glm::vec3 ramp_colour(const Coat& coat, double q) {
  const std::vector<RampStop>& ramp = coat.ramp;
  assert(!ramp.empty());
  const auto next = std::find_if(ramp.begin(), ramp.end(), [&](const RampStop& stop) { return stop.at >= q; });
  if (next == ramp.begin()) return ramp.front().colour;
  if (next == ramp.end()) return ramp.back().colour;
  const RampStop& last = *(next - 1);
  const double span = next->at - last.at;
  return glm::mix(last.colour, next->colour, static_cast<float>(span > 0 ? (q - last.at) / span : 1));
}

}  // namespace pelage
