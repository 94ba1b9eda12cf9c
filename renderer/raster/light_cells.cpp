#include "renderer/raster/light_cells.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr float spread = 0.08f;  // strands of one place differ in direction (light-inl.h)
constexpr float skin_depth = 4;  // optical depth of a whole face of skin
constexpr int near_steps = 8;    // cells

/// A triangle's area facing away from a light, spread over the cells that it lies in.
void add_skin(const GridPlace& place, glm::vec3 a, glm::vec3 b, glm::vec3 c, float away, std::vector<float>& cells) {
  const float longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
  if (longest > 0.75f * place.cell) {
    const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
    add_skin(place, a, ab, ca, away / 4, cells), add_skin(place, ab, b, bc, away / 4, cells);
    add_skin(place, ca, bc, c, away / 4, cells), add_skin(place, ab, bc, ca, away / 4, cells);
    return;
  }
  const glm::ivec3 cell(glm::floor(((a + b + c) / 3.0f - place.low) / place.cell));
  if (place.has(cell)) cells[place.index(cell)] += away / (place.cell * place.cell);
}

/// Of each cell's face what skin covers. Only what faces away from the light stops it: then nothing lies in its own
/// shadow, whatever the size of cells.
std::vector<float> skin_facing_away(const GridPlace& place, const FurModel& model, const FurLight& light) {
  std::vector<float> cells(place.count());
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    const glm::uvec3 t = model.triangles[i];
    const glm::vec3 a = model.positions[t.x], b = model.positions[t.y], c = model.positions[t.z];
    const glm::vec3 apart = (a + b + c) / 3.0f - light.position;
    const glm::vec3 from =
        light.kind == LightKind::directional ? light.direction : apart / std::max(glm::length(apart), 1e-6f);
    const float away = 0.5f * glm::dot(glm::cross(b - a, c - a), from) * model.corners[i][0].weight;
    if (away > 0) add_skin(place, a, b, c, away, cells);
  }
  return cells;
}

/// Cells of an axis in an order in which light comes to them: from where it is to both ends.
std::vector<int> order_from(float light, int size) {
  const float held = std::clamp(light, 0.0f, static_cast<float>(size) - 1);
  const int first = static_cast<int>(held);
  std::vector<int> order;
  for (int i = first; i < size; ++i) order.push_back(i);
  for (int i = first - 1; i >= 0; --i) order.push_back(i);
  return order;
}

class LightThrough {
 public:
  LightThrough(const GridPlace& place, std::span<const CellDensity> density, const FurModel& model,
               const FurLight& light)
      : place_(place),
        density_(density),
        skin_(skin_facing_away(place, model, light)),
        far_(light.kind == LightKind::directional) {
    source_ = far_ ? -light.direction : (light.position - place.low) / place.cell;
  }

  std::vector<Crossed> all() const {
    const std::vector<Crossed> swept = sweep();
    std::vector<Crossed> crossed;
    crossed.reserve(place_.count());
    for (int z = 0; z < place_.size.z; ++z)
      for (int y = 0; y < place_.size.y; ++y)
        for (int x = 0; x < place_.size.x; ++x) crossed.push_back(along_ray({x, y, z}, swept));
    return crossed;
  }

 private:
  glm::vec3 way_from(glm::vec3 place) const {
    if (far_) return source_;
    const glm::vec3 apart = source_ - place;
    return apart / std::max(glm::length(apart), 1e-3f);
  }

  /// What light crosses in a cell on a way of its width.
  Crossed in_cell(std::size_t at, glm::vec3 to_light) const {
    const CellDensity& density = density_[at];
    if (density.sum[0] <= 0) return {0, skin_depth * skin_[at]};
    const glm::vec3 way(density.sum[1], density.sum[2], density.sum[3]);
    const float whole = static_cast<float>(density.sum[0]), along = glm::dot(way, to_light) / whole;
    return {whole / CellDensity::one * std::sqrt(std::max(1 - (1 - spread) * along * along, 0.0f)),
            skin_depth * skin_[at]};
  }

  std::vector<Crossed> sweep() const;
  Crossed from_neighbours(glm::ivec3 cell, const std::vector<Crossed>& middle) const;
  Crossed along_ray(glm::ivec3 cell, const std::vector<Crossed>& swept) const;
  Crossed between(const std::vector<Crossed>& cells, glm::vec3 at) const;

  const GridPlace& place_;
  std::span<const CellDensity> density_;
  std::vector<float> skin_;
  bool far_;
  glm::vec3 source_;  // the light's place, in cells; of a far one the way to it
};

void add(Crossed& sum, const Crossed& part, float share) {
  sum.strands += share * part.strands, sum.body += share * part.body;
}

/// Up to each cell's middle by short characteristics (Kunasz and Auer 1988): a cell gets what comes through the four
/// cells next to it on its side of the light. Light spreads a little from cell to cell: what is far has a soft edge.
std::vector<Crossed> LightThrough::sweep() const {
  const glm::vec3 start = far_ ? glm::sign(source_) * 1e9f : source_;
  const std::array order{order_from(start.x, place_.size.x), order_from(start.y, place_.size.y),
                         order_from(start.z, place_.size.z)};
  std::vector<Crossed> middle(place_.count());
  for (const int z : order[2])
    for (const int y : order[1])
      for (const int x : order[0]) middle[place_.index({x, y, z})] = from_neighbours({x, y, z}, middle);
  return middle;
}

Crossed LightThrough::from_neighbours(glm::ivec3 cell, const std::vector<Crossed>& middle) const {
  const glm::vec3 to_light = way_from(glm::vec3(cell) + 0.5f), size = glm::abs(to_light);
  const int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
  const glm::ivec3 step(glm::sign(to_light));
  const float longer = 1 / std::max(size[a], 0.5f), off_b = size[b] * longer, off_c = size[c] * longer;
  Crossed sum;
  add(sum, in_cell(place_.index(cell), to_light), 0.5f * longer);
  for (int k = 0; k < 4; ++k) {
    glm::ivec3 from = cell;
    from[a] += step[a];
    if (k & 1) from[b] += step[b];
    if (k & 2) from[c] += step[c];
    const float share = (k & 1 ? off_b : 1 - off_b) * (k & 2 ? off_c : 1 - off_c);
    if (!place_.has(from) || from == cell) continue;
    const std::size_t of = place_.index(from);
    add(sum, middle[of], share), add(sum, in_cell(of, to_light), 0.5f * longer * share);
  }
  return sum;
}

/// Near a cell along the ray itself, so that shadows of what is near are sharp; from there on what was swept.
Crossed LightThrough::along_ray(glm::ivec3 cell, const std::vector<Crossed>& swept) const {
  const glm::vec3 middle = glm::vec3(cell) + 0.5f, to_light = way_from(middle);
  Crossed sum;
  add(sum, in_cell(place_.index(cell), to_light), 0.5f);
  for (int s = 1; s <= near_steps; ++s) {
    const glm::ivec3 at(glm::floor(middle + to_light * static_cast<float>(s)));
    if (!place_.has(at)) return sum;
    add(sum, in_cell(place_.index(at), to_light), s < near_steps ? 1.0f : 0.5f);
  }
  add(sum, between(swept, middle + to_light * static_cast<float>(near_steps)), 1);
  return sum;
}

/// Between the middles of eight cells; `at` in cells.
Crossed LightThrough::between(const std::vector<Crossed>& cells, glm::vec3 at) const {
  const glm::vec3 held = glm::clamp(at - 0.5f, glm::vec3(0), glm::vec3(place_.size) - 1.001f), low = glm::floor(held);
  const glm::vec3 part = held - low;
  Crossed sum;
  for (int k = 0; k < 8; ++k) {
    const glm::ivec3 off(k & 1, k >> 1 & 1, k >> 2);
    const glm::vec3 share = glm::mix(1.0f - part, part, glm::vec3(off));
    add(sum, cells[place_.index(glm::ivec3(low) + off)], share.x * share.y * share.z);
  }
  return sum;
}

}  // namespace

std::vector<Crossed> light_cells(const GridPlace& place, std::span<const CellDensity> density, const FurModel& model,
                                 const FurLight& light) {
  return LightThrough(place, density, model, light).all();
}

}  // namespace pelage
