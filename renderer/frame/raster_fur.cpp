#include "renderer/frame/raster_fur.h"

#include <algorithm>

#include "renderer/coat/strand_tile.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr double max_strands = 2e6;  // that grow of a coat; fewer are wider

double whole_coats_of(const FurModel& model) {
  Coat coat;
  coat.count = 1, coat.tile = 1;
  return expected_strands(model, coat);
}

}  // namespace

void RasterFur::grow(GrowRecipe wanted, std::span<const FurCurves> with, Bending how, int threads) {
  wanted.share *= share_of_coat, wanted.widening /= share_of_coat;
  if (recipe == wanted && changes == copy.changes() && bending == how && std::ranges::equal(curves, with)) return;
  fur.update(copy.model(), copy.fields(), wanted, threads, with, how);
  recipe = wanted, changes = copy.changes(), curves.assign(with.begin(), with.end()), bending = how;
}

void RasterFur::drop(int threads, const std::shared_ptr<RasterRoom>& room) {
  fur = GrownFur(), raster = std::make_unique<Raster>(threads, room), recipe.reset();
}

RasterModel::RasterModel(const FurModel& model, const FurFields& fields, int threads,
                         const std::shared_ptr<RasterRoom>& room)
    : copy(model, fields),
      whole_coats(whole_coats_of(model)),
      whole(copy, 1, threads, room),
      thin(copy, thin_share, threads, room) {}

GrowRecipe RasterModel::recipe_for(const FurFrame& frame) const {
  GrowRecipe recipe{.coat = frame.coat, .model_colours = takes_model_colours(frame.look, copy.model().has_colours)};
  const double expected = whole_coats * frame.coat.count / (frame.coat.tile * frame.coat.tile);
  recipe.guard_share = expected > 0 ? std::min(frame.coat.guard_hairs / expected, 1.0) : 0;
  recipe.share = std::min(max_strands / std::max(expected, 1.0), 1.0);
  recipe.widening = 1 / recipe.share;
  return recipe;
}

std::vector<glm::vec3> RasterModel::field_of(const FurFrame& frame) const {
  const FurFields fields = copy.fields();
  const FurModel& model = copy.model();
  const FieldValues value(frame, *std::max_element(fields.length.begin(), fields.length.end()));
  const auto at = [](std::span<const float> painted, std::size_t v, float rest) {
    return painted.empty() ? rest : painted[v];
  };
  std::vector<glm::vec3> field(model.positions.size());
  for (std::size_t v = 0; v < field.size(); ++v)
    field[v] = value.of({model.positions[v], model.normals[v], model.tangents[v], fields.direction[v], fields.length[v],
                         at(fields.paint.density, v, 1), at(fields.paint.wetness, v, 0), at(fields.paint.mask, v, 1),
                         static_cast<std::uint32_t>(v)});
  return field;
}

void RasterModel::drop(int threads, const std::shared_ptr<RasterRoom>& room) {
  whole.drop(threads, room), thin.drop(threads, room);
}

}  // namespace pelage
