#include "renderer/strands/grown_fur.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/parallel.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr double strands_of_grown_part = 1000;

double area_of(const FurModel& model, const StrandChunk& chunk) {
  double area = 0;
  for (const std::uint32_t piece : chunk) {
    const glm::uvec3 t = model.triangles[piece];
    const glm::dvec3 a(model.positions[t.x]), b(model.positions[t.y]), c(model.positions[t.z]);
    const auto& corners = model.corners[piece];
    const double weight = (double{corners[0].weight} + corners[1].weight + corners[2].weight) / 3;
    area += 0.5 * glm::length(glm::cross(b - a, c - a)) * weight;
  }
  return area;
}

/// Finds the bounds of a part that stands on some pieces of the model.
void find_bounds(const FurModel& model, std::span<const std::uint32_t> pieces, GrownPart& part) {
  const StrandSet& set = *part.strands;
  const std::size_t knots = static_cast<std::size_t>(set.segments) + 1;
  part.low = glm::vec3(1e9f), part.high = glm::vec3(-1e9f);
  for (const std::uint32_t piece : pieces) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 corner = model.positions[model.triangles[piece][k]];
      part.low = glm::min(part.low, corner), part.high = glm::max(part.high, corner);
    }
  }
  part.middle = 0.5f * (part.low + part.high), part.radius = 0.5f * glm::length(part.high - part.low);
  float length = 0, longest = 0;
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const StrandPoint& point = set.points[i];
    part.low = glm::min(part.low, point.place - point.radius);
    part.high = glm::max(part.high, point.place + point.radius);
    part.thickest = std::max(part.thickest, point.radius);
    length = i % knots == 0 ? 0 : length + glm::length(point.place - set.points[i - 1].place);
    longest = std::max(longest, length);
  }
  constexpr float step = 1.0f / 32;
  part.longest = std::ceil(longest / step) * step;
}

/// Extends a box by the offsets that `bend` gives to strands whose curves are `stretch` times as long.
void add_bend(const PieceBend& bend, const LeanTable& leans, float stretch, glm::vec3& low, glm::vec3& high) {
  constexpr std::size_t step = lean_cells / 4;  // they go ever further on their way up
  for (const auto& [still, moved] : bend) {
    for (std::size_t k = step; k <= lean_cells; k += step) {
      const auto place = [&](const CornerLean& lean) {
        const glm::vec2 at = leans.knot(lean.inclination, k).place;
        return lean.length * (at.x * lean.way + at.y * lean.normal);
      };
      const glm::vec3 way = stretch * (place(moved) - place(still));
      low = glm::min(low, way), high = glm::max(high, way);
    }
  }
}

}  // namespace

void GrownFur::divide(const FurModel& model, const GrowRecipe& recipe) {
  const Coat& coat = recipe.coat;
  if (model.id == model_ && coat.count == count_ && coat.tile == tile_ && recipe.share == share_) return;
  chunks_ = make_chunks(model, coat, strands_of_grown_part / recipe.share);
  parts_.clear(), still_.assign(chunks_.size(), {}), curves_.clear(), skin_.assign(model.triangles.size(), {});
  bends_.clear();
  const auto none = std::make_shared<const StrandSet>();
  for (const StrandChunk& chunk : chunks_) parts_.push_back({.strands = none, .area = area_of(model, chunk)});
  parts_.push_back({.role = StrandRole::curve, .strands = none, .crowding = 0});
  model_ = model.id, count_ = coat.count, tile_ = coat.tile, share_ = recipe.share;
}

/// Grows a chunk at rest. Returns the number of strands that were grown.
std::size_t GrownFur::grow_still(const FurModel& model, const Grower& grower, const GrowRecipe& recipe,
                                 std::size_t chunk) {
  Still& still = still_[chunk];
  const std::uint64_t state = grower.fingerprint(chunks_[chunk]);
  if (still.state == state) return 0;
  still = {std::make_shared<const StrandSet>(grower.grow(chunks_[chunk])), state};
  for (const StrandRoot& root : still.strands->roots) still.stretch = std::max(still.stretch, root.stretch);
  GrownPart& part = parts_[chunk];
  part.strands = still.strands;
  find_bounds(model, chunks_[chunk], part);
  still.low = part.low, still.high = part.high;
  Hash skin;
  for (const std::uint32_t piece : chunks_[chunk]) skin.add_value(skin_[piece] = grower.skin(piece));
  part.skin = skin.value();
  const std::size_t count = still.strands->count();
  const double on_area = recipe.coat.count / (recipe.coat.tile * recipe.coat.tile);
  const double of_coat = on_area * recipe.share * part.area;
  part.crowding = static_cast<float>(static_cast<double>(count) / std::max(of_coat, 1e-12));
  part.wider = static_cast<float>(1 / recipe.share);
  part.packing = static_cast<float>(glm::pi<double>() * on_area);
  return count;
}

void GrownFur::bend_part(const Grower& grower, Bending bending, std::size_t chunk) {
  GrownPart& part = parts_[chunk];
  const Still& still = still_[chunk];
  glm::vec3 low(0), high(0);
  for (const std::uint32_t piece : chunks_[chunk])
    add_bend(bends_[piece] = grower.bend_of(piece), grower.leans(), still.stretch, low, high);
  part.low = still.low + low, part.high = still.high + high;
  if (bending == Bending::left) return;
  auto bent = std::make_shared<StrandSet>(*still.strands);
  grower.bend(chunks_[chunk], *bent);
  part.strands = std::move(bent);
}

/// Bends what has grown as well, where something moves it.
std::size_t GrownFur::grow_part(const FurModel& model, const Grower& grower, const GrowRecipe& recipe, Bending bending,
                                std::size_t chunk) {
  const std::size_t grown = grow_still(model, grower, recipe, chunk);
  GrownPart& part = parts_[chunk];
  const Still& still = still_[chunk];
  Hash state;
  state.add(still.state), state.add(grower.bend_fingerprint(chunks_[chunk]));
  state.add(static_cast<std::uint64_t>(bending));
  if (part.state == state.value()) return grown;
  part.state = state.value(), part.strands = still.strands, part.low = still.low, part.high = still.high;
  if (!bends_.empty()) bend_part(grower, bending, chunk);
  return grown;
}

std::size_t GrownFur::set_curves(std::span<const FurCurves> curves) {
  if (std::equal(curves.begin(), curves.end(), curves_.begin(), curves_.end())) return 0;
  curves_.assign(curves.begin(), curves.end());
  GrownPart& part = parts_.back();
  part.strands = std::make_shared<const StrandSet>(grow_curves(curves));
  ++part.state;
  find_bounds({}, {}, part);
  return part.strands->count();
}

std::size_t GrownFur::update(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe, int threads,
                             std::span<const FurCurves> curves, Bending bending) {
  divide(model, recipe);
  const Grower grower(model, fields, recipe, tables_);
  tables_ = grower.tables(), leans_ = {tables_, &grower.leans()};
  bends_.resize(fields.still.empty() ? 0 : model.triangles.size());
  std::atomic<std::size_t> grown{set_curves(curves)};
  for_each_in_parallel(
      static_cast<std::uint32_t>(chunks_.size()),
      [&](std::uint32_t chunk) { grown += grow_part(model, grower, recipe, bending, chunk); }, threads);
  return grown;
}

std::size_t GrownFur::count() const {
  std::size_t sum = 0;
  for (const GrownPart& part : parts_) sum += part.strands->count();
  return sum;
}

std::size_t GrownFur::bytes() const {
  std::size_t sum = 0;
  for (const GrownPart& part : parts_) sum += part.strands->bytes();
  for (std::size_t i = 0; i < still_.size(); ++i)
    if (still_[i].strands && still_[i].strands != parts_[i].strands) sum += still_[i].strands->bytes();
  return sum + skin_.size() * sizeof(skin_[0]) + bends_.size() * sizeof(PieceBend);
}

}  // namespace pelage
