#include "renderer/frame/raster_fur.h"

#include <algorithm>

#include "renderer/coat/strand_tile.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr double max_strands = 2e6;  // number of strands over all coats; if it is exceeded, fewer and wider ones grow

}  // namespace

void RasterFur::grow(std::vector<GrowRecipe> wanted, std::span<const FurCurves> with, Bending how, int threads) {
  for (GrowRecipe& recipe : wanted) recipe.share *= share_of_coat, recipe.widening /= share_of_coat;
  if (recipes == wanted && changes == copy.changes() && bending == how && std::ranges::equal(curves, with)) return;
  fur.update(copy.model(), copy.fields(), wanted, threads, with, how);
  recipes = std::move(wanted), changes = copy.changes(), curves.assign(with.begin(), with.end()), bending = how;
}

void RasterFur::drop(int threads, const std::shared_ptr<RasterScratch>& scratch) {
  fur = GrownFur(), raster = std::make_unique<Raster>(threads, scratch), recipes.clear();
}

RasterModel::RasterModel(const FurModel& model, EachCoat<FurFields> fields, int threads,
                         const std::shared_ptr<RasterScratch>& scratch)
    : copy(model, fields),
      fur_area(pelage::fur_area(model)),
      full(copy, 1, threads, scratch),
      thin(copy, thin_share, threads, scratch) {}

std::vector<GrowRecipe> RasterModel::recipes_for(const FurFrame& frame) const {
  std::vector<GrowRecipe> recipes = recipes_of(frame, copy.model().has_colours, fur_area);
  double expected = 0;
  for (const GrowRecipe& recipe : recipes) expected += expected_strands(fur_area, recipe.coat);
  for (GrowRecipe& recipe : recipes) {
    recipe.share = std::min(max_strands / std::max(expected, 1.0), 1.0);
    recipe.widening = 1 / recipe.share;
  }
  return recipes;
}

std::vector<glm::vec3> RasterModel::field_of(const FurFrame& frame) const {
  const FurFields fields = copy.fields()[frame.overlay_coat];
  const FurModel& model = copy.model();
  const FieldValues value(frame, *std::max_element(fields.length.begin(), fields.length.end()));
  const auto at = [](std::span<const float> painted, std::size_t v, float fallback) {
    return painted.empty() ? fallback : painted[v];
  };
  std::vector<glm::vec3> field(model.positions.size());
  for (std::size_t v = 0; v < field.size(); ++v)
    field[v] = value.of({model.positions[v], model.normals[v], model.tangents[v], fields.direction[v], fields.length[v],
                         at(fields.paint.density, v, 1), at(fields.paint.wetness, v, 0), at(fields.paint.mask, v, 1),
                         static_cast<std::uint32_t>(v)});
  return field;
}

void RasterModel::drop(int threads, const std::shared_ptr<RasterScratch>& scratch) {
  full.drop(threads, scratch), thin.drop(threads, scratch);
}

}  // namespace pelage
