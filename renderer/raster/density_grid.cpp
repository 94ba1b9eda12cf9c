#include "renderer/raster/density_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "protocol/base/parallel.h"

namespace pelage {

namespace {

constexpr float finest_cell = 0.008f;  // sizes
constexpr double max_cells = 1 << 20;
constexpr float fixed_point = 65536;
constexpr float spread = 0.08f;  // strands of one place differ in direction (light-inl.h)
constexpr float skin_depth = 4;  // optical depth of a whole face of skin

GridPlace place_around(std::span<const GrownPart> parts) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const GrownPart& part : parts) {
    if (part.strands->count() == 0) continue;
    low = glm::min(low, part.low), high = glm::max(high, part.high);
  }
  if (low.x > high.x) return {};
  const glm::dvec3 room(high - low);
  const double cell = std::max(double{finest_cell}, std::cbrt(room.x * room.y * room.z / max_cells));
  const glm::dvec3 first = glm::floor(glm::dvec3(low) / cell) - 1.0, last = glm::floor(glm::dvec3(high) / cell) + 1.0;
  return {glm::vec3(first * cell), static_cast<float>(cell), glm::ivec3(last - first) + 1};
}

/// Adds to sums that several threads add to.
void add(std::int32_t& sum, float value) {
  std::atomic_ref(sum).fetch_add(static_cast<std::int32_t>(std::lround(value * fixed_point)), std::memory_order_relaxed);
}

/// A triangle's area facing away from a light, spread over the cells that it lies in.
struct SkinOfLight {
  const GridPlace& place;
  std::vector<float>& cells;

  void add(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 across, float away) const {
    const float longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (longest > 0.75f * place.cell && away > 0) {
      const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
      add(a, ab, ca, across, away / 4), add(ab, b, bc, across, away / 4);
      add(ca, bc, c, across, away / 4), add(ab, bc, ca, across, away / 4);
      return;
    }
    const glm::ivec3 cell(glm::floor(((a + b + c) / 3.0f - place.low) / place.cell));
    if (glm::any(glm::lessThan(cell, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(cell, place.size))) return;
    cells[place.index(cell)] += away / (place.cell * place.cell);
  }
};

constexpr int near_steps = 8;  // cells

glm::vec3 way_to(const FurLight& light, glm::vec3 source, glm::vec3 place) {
  if (light.kind == LightKind::directional) return -light.direction;
  const glm::vec3 apart = source - place;
  return apart / std::max(glm::length(apart), 1e-3f);
}

/// Cells of an axis in an order in which light comes to them: from where it is to both ends.
std::vector<int> order_from(float light, int size) {
  const int first = std::clamp(static_cast<int>(std::floor(std::clamp(light, -1.0f, static_cast<float>(size)))), 0, size - 1);
  std::vector<int> order;
  for (int i = first; i < size; ++i) order.push_back(i);
  for (int i = first - 1; i >= 0; --i) order.push_back(i);
  return order;
}

}  // namespace

bool DensityGrid::add_fur(std::span<const GrownPart> parts, int threads) {
  std::vector<std::uint64_t> states;
  for (const GrownPart& part : parts) states.push_back(part.state);
  const GridPlace around = place_around(parts);
  if (states == states_ && around == place_) return false;
  states_ = std::move(states), place_ = around;
  density_.assign(place_.count(), {});
  for_each_in_parallel(
      static_cast<std::uint32_t>(parts.size()),
      [&](std::uint32_t p) {
        const StrandSet& set = *parts[p].strands;
        const auto segments = static_cast<std::size_t>(set.segments);
        for (std::size_t i = 0; i < set.count(); ++i) {
          const StrandPoint* knot = &set.points[i * (segments + 1)];
          for (std::size_t k = 0; k < segments; ++k) {
            const glm::vec3 way = knot[k + 1].place - knot[k].place;
            const float length = glm::length(way);
            const int steps = std::clamp(static_cast<int>(std::ceil(length / place_.cell)), 1, 4096);
            const float width = (knot[k].radius + knot[k + 1].radius) / (place_.cell * place_.cell * static_cast<float>(steps));
            for (int s = 0; s < steps; ++s) {
              const glm::vec3 at = knot[k].place + way * ((static_cast<float>(s) + 0.5f) / static_cast<float>(steps));
              const glm::ivec3 cell = glm::clamp(glm::ivec3((at - place_.low) / place_.cell), glm::ivec3(0), place_.size - 1);
              Density& density = density_[place_.index(cell)];
              add(density.sum[0], width * length);
              for (int axis = 0; axis < 3; ++axis) add(density.sum[static_cast<std::size_t>(axis) + 1], width * way[axis]);
            }
          }
        }
      },
      threads);
  return true;
}

/// Only what faces away from the light stops it: then nothing lies in its own shadow, whatever the size of cells.
std::vector<float> DensityGrid::skin_towards(const FurModel& model, const FurLight& light) const {
  std::vector<float> cells(place_.count());
  const SkinOfLight skin{place_, cells};
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::vec3 a = model.positions[t.x], b = model.positions[t.y], c = model.positions[t.z];
    const glm::vec3 across = 0.5f * glm::cross(b - a, c - a);
    const glm::vec3 from = light.kind == LightKind::directional
                               ? light.direction
                               : glm::normalize((a + b + c) / 3.0f - light.position + glm::vec3(1e-9f));
    const float away = glm::dot(across, from) * model.corners[i][0].weight;
    if (away > 0) skin.add(a, b, c, across, away);
  }
  return cells;
}

/// What a light crosses in a cell on a way of its width.
Crossed DensityGrid::own(std::size_t at, float skin, glm::vec3 to_light) const {
  const Density& density = density_[at];
  Crossed own{0, skin_depth * skin};
  if (density.sum[0] <= 0) return own;
  const glm::vec3 way(density.sum[1], density.sum[2], density.sum[3]);
  const float whole = static_cast<float>(density.sum[0]), along = glm::dot(way, to_light) / whole;
  own.strands = whole / fixed_point * std::sqrt(std::max(1 - (1 - spread) * along * along, 0.0f));
  return own;
}

/// Up to each cell's middle by short characteristics (Kunasz and Auer 1988): a cell gets what comes out of the four cells
/// next to it on its side of the light. Light spreads a little from cell to cell, so that what is far has a soft edge.
std::vector<Crossed> DensityGrid::swept(const FurLight& light, const std::vector<float>& skin) const {
  const glm::vec3 source = source_of(light);
  const std::array order{order_from(source.x, place_.size.x), order_from(source.y, place_.size.y),
                         order_from(source.z, place_.size.z)};
  std::vector<Crossed> middle(place_.count());
  for (const int z : order[2]) {
    for (const int y : order[1]) {
      for (const int x : order[0]) {
        const glm::ivec3 cell(x, y, z);
        const glm::vec3 to_light = way_to(light, source, glm::vec3(cell) + 0.5f), size = glm::abs(to_light);
        const int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
        const float step = 1 / std::max(size[a], 0.5f);
        const std::size_t at = place_.index(cell);
        const Crossed here = own(at, skin[at], to_light);
        Crossed& sum = middle[at];
        sum = {0.5f * step * here.strands, 0.5f * step * here.body};
        glm::ivec3 before = cell;
        before[a] += to_light[a] > 0 ? 1 : -1;
        if (before[a] < 0 || before[a] >= place_.size[a]) continue;
        const float off_b = size[b] * step, off_c = size[c] * step;
        for (int k = 0; k < 4; ++k) {
          glm::ivec3 from = before;
          if (k & 1) from[b] += to_light[b] > 0 ? 1 : -1;
          if (k & 2) from[c] += to_light[c] > 0 ? 1 : -1;
          if (from[b] < 0 || from[c] < 0 || from[b] >= place_.size[b] || from[c] >= place_.size[c]) continue;
          const float weight = (k & 1 ? off_b : 1 - off_b) * (k & 2 ? off_c : 1 - off_c);
          const std::size_t of = place_.index(from);
          const Crossed there = own(of, skin[of], to_light);
          sum.strands += weight * (middle[of].strands + 0.5f * step * there.strands);
          sum.body += weight * (middle[of].body + 0.5f * step * there.body);
        }
      }
    }
  }
  return middle;
}

/// Near a cell along the ray itself, so that shadows of what is near are sharp; from there on what was swept.
void DensityGrid::light_cells(const FurModel& model, const FurLight& light, std::size_t number) {
  const std::vector<float> skin = skin_towards(model, light);
  const std::vector<Crossed> far = swept(light, skin);
  const glm::vec3 source = source_of(light);
  std::size_t at = 0;
  for (int z = 0; z < place_.size.z; ++z) {
    for (int y = 0; y < place_.size.y; ++y) {
      for (int x = 0; x < place_.size.x; ++x, ++at) {
        const glm::vec3 middle = glm::vec3(x, y, z) + 0.5f, to_light = way_to(light, source, middle);
        const Crossed here = own(at, skin[at], to_light);
        Crossed sum{0.5f * here.strands, 0.5f * here.body};
        bool inside = true;
        for (int s = 1; s <= near_steps && inside; ++s) {
          const glm::ivec3 cell(glm::floor(middle + to_light * static_cast<float>(s)));
          inside = !glm::any(glm::lessThan(cell, glm::ivec3(0))) && !glm::any(glm::greaterThanEqual(cell, place_.size));
          if (!inside) break;
          const std::size_t of = place_.index(cell);
          const float share = s < near_steps ? 1.0f : 0.5f;
          const Crossed there = own(of, skin[of], to_light);
          sum.strands += share * there.strands, sum.body += share * there.body;
        }
        if (inside) {
          const Crossed rest = between(far, middle + to_light * static_cast<float>(near_steps));
          sum.strands += rest.strands, sum.body += rest.body;
        }
        crossed_[number / 2][at][number % 2] = sum;
      }
    }
  }
}

/// Between the middles of eight cells; `at` in cells.
Crossed DensityGrid::between(const std::vector<Crossed>& cells, glm::vec3 at) const {
  const glm::vec3 held = glm::clamp(at - 0.5f, glm::vec3(0), glm::vec3(place_.size) - 1.001f), low = glm::floor(held), part = held - low;
  Crossed sum;
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 off(k & 1, k >> 1 & 1, k >> 2);
    const float weight = (off.x ? part.x : 1 - part.x) * (off.y ? part.y : 1 - part.y) * (off.z ? part.z : 1 - part.z);
    const Crossed& cell = cells[place_.index(glm::ivec3(low) + off)];
    sum.strands += weight * cell.strands, sum.body += weight * cell.body;
  }
  return sum;
}

/// Where a light stands, in cells; far away for one that has no place.
glm::vec3 DensityGrid::source_of(const FurLight& light) const {
  if (light.kind == LightKind::directional) return glm::sign(-light.direction) * 1e9f;
  return (light.position - place_.low) / place_.cell;
}

void DensityGrid::update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights,
                         int threads) {
  const bool changed = add_fur(parts, threads) || model.id != model_;
  model_ = model.id;
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    if (changed || i >= lights_.size() || !(lights_[i] == lights[i])) moved.push_back(i);
  }
  lights_.assign(lights.begin(), lights.end());
  crossed_.resize((lights.size() + 1) / 2);
  for (auto& pair : crossed_) pair.resize(place_.count());
  for_each_in_parallel(
      static_cast<std::uint32_t>(moved.size()), [&](std::uint32_t i) { light_cells(model, lights[moved[i]], moved[i]); },
      threads);
}

std::size_t DensityGrid::bytes() const {
  return density_.size() * sizeof(Density) + crossed_.size() * place_.count() * sizeof(CrossedByTwo);
}

}  // namespace pelage
