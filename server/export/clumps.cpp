#include "server/export/clumps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>

#include "base/clamped_index.h"

namespace pelage {

namespace {

/// The coat, the three indices of a cube, and which of six directions the skin faces.
using CellKey = std::tuple<std::size_t, int, int, int, int>;

int facing_of(glm::vec3 normal) {
  const glm::vec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

CellKey key_of(std::size_t coat, glm::vec3 root, glm::vec3 normal, double cell) {
  const glm::dvec3 cube = glm::floor(glm::dvec3(root) / cell);
  const auto held = [](double at) { return clamped_index(at, -(1 << 30), 1 << 30); };
  return {coat, held(cube.x), held(cube.y), held(cube.z), facing_of(normal)};
}

/// Calls use(coat, set, index of the strand in the set, index of its first point) for each strand of the fur.
template <class Use>
void for_each_strand(const ExportedStrands& strands, const Use& use) {
  for (std::size_t k = 0; k + strands.curve_sets < strands.sets.size(); ++k) {
    const StrandSet& set = strands.sets[k];
    const std::size_t points = static_cast<std::size_t>(set.segments) + 1;
    for (std::size_t i = 0; i < set.count(); ++i) use(strands.group_of[k], set, i, i * points);
  }
}

std::size_t count_clumps(const ExportedStrands& strands, double cell) {
  std::set<CellKey> keys;
  for_each_strand(strands, [&](std::size_t coat, const StrandSet& set, std::size_t i, std::size_t first) {
    keys.insert(key_of(coat, set.points[first].position, set.roots[i].normal, cell));
  });
  return keys.size();
}

/// The sums over a clump's strands.
struct Sum {
  std::array<glm::dvec3, CardLine::rows> positions{}, colours{};
  glm::dvec3 normal{0};
  double count = 0;
  float number = 0;

  void add(const StrandSet& set, std::size_t strand, std::size_t first) {
    if (count == 0) number = set.roots[strand].number;
    for (std::size_t row = 0; row < CardLine::rows; ++row) {
      const double at = static_cast<double>(row) / (CardLine::rows - 1) * set.segments;
      const auto low = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(set.segments) - 1);
      const double share = at - static_cast<double>(low);
      const auto mix = [&](auto of) { return glm::mix(of(first + low), of(first + low + 1), share); };
      positions[row] += mix([&](std::size_t k) { return glm::dvec3(set.points[k].position); });
      colours[row] += mix([&](std::size_t k) { return glm::dvec3(unpack_colour(set.colours[k])); });
    }
    normal += glm::dvec3(set.roots[strand].normal);
    ++count;
  }

  CardLine mean() const {
    CardLine clump;
    for (std::size_t row = 0; row < CardLine::rows; ++row) {
      clump.positions[row] = glm::vec3(positions[row] / count);
      clump.colours[row] = glm::vec3(colours[row] / count);
    }
    clump.normal = glm::vec3(glm::normalize(normal));
    clump.number = number;
    return clump;
  }
};

}  // namespace

std::vector<CardLine> make_clumps(const ExportedStrands& strands, double cell) {
  std::map<CellKey, Sum> sums;
  for_each_strand(strands, [&](std::size_t coat, const StrandSet& set, std::size_t i, std::size_t first) {
    sums[key_of(coat, set.points[first].position, set.roots[i].normal, cell)].add(set, i, first);
  });
  std::vector<CardLine> clumps;
  clumps.reserve(sums.size());
  for (const auto& [key, sum] : sums) clumps.push_back(sum.mean()), clumps.back().coat = std::get<0>(key);
  return clumps;
}

double cell_of(const ExportedStrands& strands, int count) {
  constexpr double narrowest = 1e-4, widest = 1;  // sizes
  double low = narrowest, high = widest, cell = std::sqrt(low * high);
  for (int step = 0; step < 24; ++step) {
    cell = std::sqrt(low * high);
    const auto clumps = static_cast<double>(count_clumps(strands, cell));
    if (std::abs(clumps - count) <= 0.1 * count) break;
    (clumps > count ? low : high) = cell;
  }
  return cell;
}

}  // namespace pelage
