#include "renderer/strands/grown_fur.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/parallel.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/strands/sampling.h"

namespace pelage {

namespace {

constexpr double strands_of_grown_part = 1000;

/// Returns the coverage of a full coat over the length of its fur, up to a constant factor.
double cover_of(const Coat& coat) {
  return expected_strands(1, coat) * std::max(coat.width_root + coat.width_tip, 1e-9);
}

double area_of(const FurModel& model, const StrandChunk& chunk) {
  double area = 0;
  for (const std::uint32_t triangle : chunk) {
    const glm::uvec3 t = model.triangles[triangle];
    const glm::dvec3 a(model.positions[t.x]), b(model.positions[t.y]), c(model.positions[t.z]);
    const auto& corners = model.corners[triangle];
    const double weight = (double{corners[0].weight} + corners[1].weight + corners[2].weight) / 3;
    area += 0.5 * glm::length(glm::cross(b - a, c - a)) * weight;
  }
  return area;
}

/// Finds the bounds of a part that stands on some triangles of the model.
void find_bounds(const FurModel& model, std::span<const std::uint32_t> triangles, GrownPart& part) {
  const StrandSet& set = *part.strands;
  const std::size_t knots = static_cast<std::size_t>(set.segments) + 1;
  part.low = glm::vec3(1e9f), part.high = glm::vec3(-1e9f);
  for (const std::uint32_t triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 corner = model.positions[model.triangles[triangle][k]];
      part.low = glm::min(part.low, corner), part.high = glm::max(part.high, corner);
    }
  }
  part.middle = 0.5f * (part.low + part.high), part.radius = 0.5f * glm::length(part.high - part.low);
  float length = 0, longest = 0;
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    const StrandPoint& point = set.points[i];
    part.low = glm::min(part.low, point.position - point.radius);
    part.high = glm::max(part.high, point.position + point.radius);
    part.thickest = std::max(part.thickest, point.radius);
    length = i % knots == 0 ? 0 : length + glm::length(point.position - set.points[i - 1].position);
    longest = std::max(longest, length);
  }
  constexpr float step = 1.0f / 32;
  part.longest = std::ceil(longest / step) * step;
}

/// Extends a box by the offsets that `bend` gives to strands whose curves are `stretch` times as long.
void add_bend(const TriangleBend& bend, const LeanTable& leans, float stretch, glm::vec3& low, glm::vec3& high) {
  constexpr std::size_t step = lean_cells / 4;  // offsets grow with the height, so a few heights suffice
  for (const auto& [still, moved] : bend) {
    for (std::size_t k = step; k <= lean_cells; k += step) {
      const auto offset = [&](const CornerLean& lean) {
        const glm::vec2 at = leans.knot(lean.inclination, k).position;
        return lean.length * (at.x * lean.direction + at.y * lean.normal);
      };
      const glm::vec3 direction = stretch * (offset(moved) - offset(still));
      low = glm::min(low, direction), high = glm::max(high, direction);
    }
  }
}

}  // namespace

bool GrownFur::divided_for(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes) const {
  if (model.id != model_ || recipes.size() != coats_.size()) return false;
  for (std::size_t c = 0; c < coats_.size(); ++c) {
    const GrownCoat& coat = coats_[c];
    const Coat& wanted = recipes[c].coat;
    if (fields[c].coat != coat.id || wanted.count != coat.count || wanted.tile != coat.tile ||
        recipes[c].share != coat.share)
      return false;
  }
  return true;
}

void GrownFur::divide(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes) {
  std::vector<Coat> coats;
  for (const GrowRecipe& recipe : recipes) coats.push_back(recipe.coat);
  chunks_ = make_chunks(model, coats, strands_of_grown_part / recipes.front().share);
  coats_.clear(), parts_.clear(), curves_.clear(), still_.assign(coats.size() * chunks_.size(), {});
  const auto none = std::make_shared<const StrandSet>();
  for (std::size_t c = 0; c < coats.size(); ++c) {
    coats_.push_back(
        {fields[c].coat, static_cast<double>(coats[c].count), coats[c].tile, recipes[c].share, {}, {}, {}});
    coats_.back().skin.assign(model.triangles.size(), {});
    for (const StrandChunk& chunk : chunks_)
      parts_.push_back({.strands = none, .area = area_of(model, chunk), .coat = fields[c].coat});
  }
  parts_.push_back({.role = StrandRole::curve, .strands = none, .crowding = 0});
  model_ = model.id;
}

/// Grows a chunk of a coat before anything bends it. Returns the number of strands that were grown.
std::size_t GrownFur::grow_still(const Growing& how, std::size_t chunk) {
  const std::size_t number = part_of(how.coat, chunk);
  Still& still = still_[number];
  const std::uint64_t state = how.grower.fingerprint(chunks_[chunk]);
  if (still.state == state) return 0;
  still = {std::make_shared<const StrandSet>(how.grower.grow(chunks_[chunk])), state};
  for (const StrandRoot& root : still.strands->roots) still.stretch = std::max(still.stretch, root.stretch);
  GrownPart& part = parts_[number];
  part.strands = still.strands;
  find_bounds(how.model, chunks_[chunk], part);
  still.low = part.low, still.high = part.high;
  Hash skin;
  for (const std::uint32_t triangle : chunks_[chunk])
    skin.add_value(coats_[how.coat].skin[triangle] = how.grower.skin(triangle));
  part.skin = skin.value();
  const std::size_t count = still.strands->count();
  const double on_area = expected_strands(1, how.recipe.coat);
  const double of_coat = on_area * how.recipe.share * part.area;
  part.crowding = static_cast<float>(static_cast<double>(count) / std::max(of_coat, 1e-12) * how.cover);
  part.wider = static_cast<float>(1 / how.recipe.share);
  part.unwound = static_cast<float>(how.unwound);
  part.packing = static_cast<float>(glm::pi<double>() * on_area);
  return count;
}

void GrownFur::bend_part(const Growing& how, std::size_t chunk) {
  GrownPart& part = parts_[part_of(how.coat, chunk)];
  const Still& still = still_[part_of(how.coat, chunk)];
  glm::vec3 low(0), high(0);
  for (const std::uint32_t triangle : chunks_[chunk])
    add_bend(coats_[how.coat].bends[triangle] = how.grower.bend_of(triangle), how.grower.leans(), still.stretch, low,
             high);
  part.low = still.low + low, part.high = still.high + high;
  if (how.bending == Bending::left) return;
  auto bent = std::make_shared<StrandSet>(*still.strands);
  how.grower.bend(chunks_[chunk], *bent);
  part.strands = std::move(bent);
}

/// Grows a chunk of a coat if it changed, and bends it if something moves it. Returns the number of strands that were
/// grown.
std::size_t GrownFur::grow_part(const Growing& how, std::size_t chunk) {
  const std::size_t grown = grow_still(how, chunk);
  GrownPart& part = parts_[part_of(how.coat, chunk)];
  const Still& still = still_[part_of(how.coat, chunk)];
  Hash state;
  state.add(still.state), state.add(how.grower.bend_fingerprint(chunks_[chunk]));
  state.add(static_cast<std::uint64_t>(how.bending));
  if (part.state == state.value()) return grown;
  part.state = state.value(), part.strands = still.strands, part.low = still.low, part.high = still.high;
  if (!coats_[how.coat].bends.empty()) bend_part(how, chunk);
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

void GrownFur::join_skin() {
  if (coats_.size() == 1) return;
  std::vector<std::array<SkinLook, 3>> of_each(coats_.size());
  skin_.resize(coats_.front().skin.size());
  for (std::size_t triangle = 0; triangle < skin_.size(); ++triangle) {
    for (std::size_t c = 0; c < coats_.size(); ++c) of_each[c] = coats_[c].skin[triangle];
    skin_[triangle] = skin_under(of_each);
  }
}

std::size_t GrownFur::update(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes,
                             int threads, std::span<const FurCurves> curves, Bending bending) {
  assert(fields.size() == recipes.size() && !recipes.empty());
  if (!divided_for(model, fields, recipes)) divide(model, fields, recipes);
  if (recipes.size() > 1) bending = Bending::done;
  std::vector<std::unique_ptr<const Grower>> growers;
  std::vector<Growing> how;
  for (std::size_t c = 0; c < recipes.size(); ++c) {
    GrownCoat& coat = coats_[c];
    growers.push_back(std::make_unique<const Grower>(model, fields[c], recipes[c], coat.tables));
    coat.tables = growers.back()->tables();
    coat.bends.resize(fields[c].still.empty() ? 0 : model.triangles.size());
    how.push_back({model, *growers.back(), recipes[c], bending, c,
                   cover_of(recipes[c].coat) / cover_of(recipes[0].coat),
                   std::sqrt(winding(recipes[0].coat) / winding(recipes[c].coat))});
  }
  std::atomic<std::size_t> grown{set_curves(curves)};
  const auto chunks = static_cast<std::uint32_t>(chunks_.size());
  for_each_in_parallel(
      chunks * static_cast<std::uint32_t>(how.size()),
      [&](std::uint32_t part) { grown += grow_part(how[part / chunks], part % chunks); }, threads);
  join_skin();
  return grown;
}

FurBend GrownFur::bend() const {
  if (coats_.size() != 1 || !coats_.front().tables) return {};
  return {coats_.front().bends, leans_of(*coats_.front().tables).rows()};
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
  for (const GrownCoat& coat : coats_)
    sum += coat.skin.size() * sizeof(skin_[0]) + coat.bends.size() * sizeof(TriangleBend);
  return sum + skin_.size() * sizeof(skin_[0]);
}

}  // namespace pelage
