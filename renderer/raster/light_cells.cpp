#include "renderer/raster/light_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

void add(Crossed& sum, const Crossed& part, float share) {
  sum.strands += share * part.strands, sum.body += share * part.body;
}

/// Cells beside one that light comes to it through, and how much each of them counts; nothing lies outside the grid.
template <std::size_t count>
struct Stencil {
  struct Tap {
    glm::ivec3 off{0};
    std::ptrdiff_t index = 0;  // of it, from the cell's
    float share = 0;
  };
  std::array<Tap, count> taps;

  void set(const GridPlace& place, std::size_t i, glm::ivec3 off, float share) {
    taps[i] = {off, (static_cast<std::ptrdiff_t>(off.z) * place.size.y + off.y) * place.size.x + off.x, share};
  }
  Crossed sum(const GridPlace& place, glm::ivec3 cell, const Crossed* at) const {
    Crossed sum;
    for (const Tap& tap : taps)
      if (place.has(cell + tap.off)) add(sum, at[tap.index], tap.share);
    return sum;
  }
  /// Adds the sums of all cells of a row, times `times`, but for what lies in the row itself: a tap after the other, so
  /// that several cells are summed at once.
  void add_other_rows(const GridPlace& place, int y, int z, const std::vector<Crossed>& cells, float times,
                      Crossed* row) const {
    for (const Tap& tap : taps)
      if (tap.off.y != 0 || tap.off.z != 0) add_tap(place, y, z, cells, tap, times, row);
  }
  void add_rows(const GridPlace& place, int y, int z, const std::vector<Crossed>& cells, Crossed* row) const {
    for (const Tap& tap : taps) add_tap(place, y, z, cells, tap, 1, row);
  }

 private:
  static void add_tap(const GridPlace& place, int y, int z, const std::vector<Crossed>& cells, const Tap& tap,
                      float times, Crossed* row) {
    if (!place.has({0, y + tap.off.y, z + tap.off.z})) return;
    const int begin = std::max(-tap.off.x, 0), end = place.size.x - std::max(tap.off.x, 0);
    const Crossed* from = &cells[place.index({0, y + tap.off.y, z + tap.off.z})] + tap.off.x;
    const float share = tap.share * times;
    for (int x = begin; x < end; ++x) add(row[x], from[x], share);
  }
};

/// The way to a light in cells.
struct Way {
  Stencil<4> before;  // cells next to one, on its side of the light
  float longer = 1;   // of the way to them over that along an axis
  Stencil<near_steps> near;
  Stencil<8> beyond;  // about where those end

  Way(const GridPlace& place, glm::vec3 to_light) {
    const glm::vec3 size = glm::abs(to_light);
    const int a = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const glm::ivec3 step(glm::sign(to_light));
    longer = 1 / std::max(size[a], 0.5f);
    const float off_b = size[b] * longer, off_c = size[c] * longer;
    for (int k = 0; k < 4; ++k) {
      glm::ivec3 off(0);
      off[a] = step[a];
      if (k & 1) off[b] = step[b];
      if (k & 2) off[c] = step[c];
      const float share = (k & 1 ? off_b : 1 - off_b) * (k & 2 ? off_c : 1 - off_c);
      before.set(place, static_cast<std::size_t>(k), off, off == glm::ivec3(0) ? 0.0f : share);
    }
    for (int s = 1; s <= near_steps; ++s)
      near.set(place, static_cast<std::size_t>(s - 1), glm::ivec3(glm::floor(0.5f + to_light * static_cast<float>(s))),
               s < near_steps ? 1.0f : 0.5f);
    const glm::vec3 end = to_light * static_cast<float>(near_steps), low = glm::floor(end), part = end - low;
    for (int k = 0; k < 8; ++k) {
      const glm::ivec3 off(k & 1, k >> 1 & 1, k >> 2);
      const glm::vec3 share = glm::mix(1.0f - part, part, glm::vec3(off));
      beyond.set(place, static_cast<std::size_t>(k), glm::ivec3(low) + off, share.x * share.y * share.z);
    }
  }
};

class LightThrough {
 public:
  LightThrough(const GridPlace& place, const FurLight& light)
      : place_(place),
        far_(light.kind == LightKind::directional),
        source_(far_ ? -light.direction : (light.position - place.low) / place.cell),
        same_(place, way_from(glm::vec3(0))) {}

  std::vector<Crossed> all(std::span<const CellDensity> density, const std::vector<float>& skin) {
    find_local(density, skin);
    swept_.resize(place_.count());
    each_row_from_light([&](int y, int z, const std::vector<int>& along) { sweep_row(y, z, along); });
    std::vector<Crossed> crossed(place_.count());
    for (int z = 0; z < place_.size.z; ++z)
      for (int y = 0; y < place_.size.y; ++y) follow_row(y, z, &crossed[place_.index({0, y, z})]);
    return crossed;
  }

 private:
  glm::vec3 way_from(glm::vec3 place) const {
    if (far_) return source_;
    const glm::vec3 apart = source_ - place;
    return apart / std::max(glm::length(apart), 1e-3f);
  }
  Way way_of(int x, int y, int z) const { return {place_, way_from(glm::vec3(x, y, z) + 0.5f)}; }
  template <class Use>
  void each_row_from_light(const Use& use) const;

  void find_local(std::span<const CellDensity> density, const std::vector<float>& skin);
  void sweep_row(int y, int z, const std::vector<int>& along);
  void follow_row(int y, int z, Crossed* row) const;

  const GridPlace& place_;
  bool far_;
  glm::vec3 source_;  // the light's place, in cells; of a far one the way to it
  Way same_;          // of a far light
  std::vector<Crossed> local_, swept_;
};

/// What light crosses in each cell on a way of its width.
void LightThrough::find_local(std::span<const CellDensity> density, const std::vector<float>& skin) {
  local_.resize(place_.count());
  for (std::size_t at = 0; at < local_.size(); ++at) {
    const CellDensity& fur = density[at];
    local_[at].body = skin_depth * skin[at];
    if (fur.sum[0] <= 0) continue;
    const auto width = static_cast<std::size_t>(place_.size.x), height = static_cast<std::size_t>(place_.size.y);
    const glm::vec3 middle = glm::vec3(at % width, at / width % height, at / (width * height)) + 0.5f;
    const glm::vec3 way(fur.sum[1], fur.sum[2], fur.sum[3]);
    const float whole = static_cast<float>(fur.sum[0]), along = glm::dot(way, way_from(middle)) / whole;
    local_[at].strands = whole / CellDensity::one * std::sqrt(std::max(1 - (1 - spread) * along * along, 0.0f));
  }
}

/// use(y, z, x in the order that light comes in).
template <class Use>
void LightThrough::each_row_from_light(const Use& use) const {
  const glm::vec3 start = far_ ? glm::sign(source_) * 1e9f : source_;
  const std::vector<int> along = order_from(start.x, place_.size.x), down = order_from(start.y, place_.size.y);
  for (const int z : order_from(start.z, place_.size.z))
    for (const int y : down) use(y, z, along);
}

/// Up to each cell's middle by short characteristics (Kunasz and Auer 1988): a cell gets what comes through the four
/// cells next to it on its side of the light. Light spreads a little from cell to cell: what is far has a soft edge.
void LightThrough::sweep_row(int y, int z, const std::vector<int>& along) {
  const std::size_t first = place_.index({0, y, z});
  Crossed* row = &swept_[first];
  if (far_) {
    same_.before.add_other_rows(place_, y, z, swept_, 1, row);
    same_.before.add_other_rows(place_, y, z, local_, 0.5f * same_.longer, row);
  }
  for (const int x : along) {
    const std::size_t at = first + static_cast<std::size_t>(x);
    const auto add_before = [&](const Way& way, const auto& wanted) {
      add(row[x], local_[at], 0.5f * way.longer);
      for (const auto& tap : way.before.taps) {
        if (!wanted(tap.off) || !place_.has(glm::ivec3(x, y, z) + tap.off)) continue;
        add(row[x], swept_[at + static_cast<std::size_t>(tap.index)], tap.share);
        add(row[x], local_[at + static_cast<std::size_t>(tap.index)], tap.share * 0.5f * way.longer);
      }
    };
    if (far_)
      add_before(same_, [](glm::ivec3 off) { return off.y == 0 && off.z == 0; });
    else
      add_before(way_of(x, y, z), [](glm::ivec3) { return true; });
  }
}

/// Near a cell along the ray itself, so that shadows of what is near are sharp; from there on what was swept.
void LightThrough::follow_row(int y, int z, Crossed* row) const {
  const std::size_t first = place_.index({0, y, z});
  for (int x = 0; x < place_.size.x; ++x) add(row[x], local_[first + static_cast<std::size_t>(x)], 0.5f);
  if (far_) {
    same_.near.add_rows(place_, y, z, local_, row), same_.beyond.add_rows(place_, y, z, swept_, row);
    return;
  }
  for (int x = 0; x < place_.size.x; ++x) {
    const Way way = way_of(x, y, z);
    const glm::ivec3 cell(x, y, z);
    const std::size_t at = first + static_cast<std::size_t>(x);
    add(row[x], way.near.sum(place_, cell, &local_[at]), 1), add(row[x], way.beyond.sum(place_, cell, &swept_[at]), 1);
  }
}

}  // namespace

std::vector<Crossed> light_cells(const GridPlace& place, std::span<const CellDensity> density, const FurModel& model,
                                 const FurLight& light) {
  return LightThrough(place, light).all(density, skin_facing_away(place, model, light));
}

}  // namespace pelage
