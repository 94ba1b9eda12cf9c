#include "server/export/strands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/limits.h"
#include "base/parallel.h"
#include "renderer/strands/grow.h"
#include "server/frames/fur_view.h"
#include "server/surface/prepare.h"

namespace pelage {

namespace {

constexpr double strands_each = 6000;  // of a set
constexpr int strands_of_card = 8;     // enough to find clumps

GrowRecipe recipe_of(const FurFrame& frame, const FurModel& model, const ExportRequest& request) {
  GrowRecipe recipe{.coat = frame.coat, .model_colours = takes_model_colours(frame.look, model.has_colours)};
  recipe.share = 1.0 / request.every;
  recipe.widening = request.widen ? request.every : 1;
  return recipe;
}

/// Texture coordinates at the roots of one set, by the triangle that is nearest to each.
void find_root_uvs(const Surface& surface, const StrandSet& set, glm::vec2* uvs) {
  const std::size_t points = static_cast<std::size_t>(set.segments) + 1;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const SurfacePoint at = surface.nearest(glm::dvec3(set.points[i * points].place));
    const std::array<glm::vec2, 3>& corners = surface.mesh().texture_uv[at.triangle];
    glm::dvec2 uv(0);
    for (int k = 0; k < 3; ++k) uv += at.barycentric[k] * glm::dvec2(corners[static_cast<std::size_t>(k)]);
    uvs[i] = glm::vec2(uv);
  }
}

void add_root_uvs(const Surface& surface, ExportedStrands& strands, const Cancel& cancel) {
  if (surface.mesh().texture_uv.empty()) return;
  std::vector<std::size_t> first{0};
  for (const StrandSet& set : strands.sets) first.push_back(first.back() + set.count());
  strands.root_uvs.resize(first.back());
  for_each_in_parallel(static_cast<std::uint32_t>(strands.sets.size()), [&](std::uint32_t i) {
    cancel.check();
    find_root_uvs(surface, strands.sets[i], strands.root_uvs.data() + first[i]);
  });
}

Status check_count(double expected, const ExportRequest& request) {
  if (expected / request.every <= limits::export_strands) return {};
  const double every = std::ceil(expected / limits::export_strands);
  return failure(Code::too_large, "The fur has too many strands for one file.", "/every",
                 "at least " + std::to_string(static_cast<long long>(every)));
}

/// Returns a request for the strands that the file needs: cards need only some of them, without whiskers.
ExportRequest needed(ExportRequest request, double expected) {
  if (request.format != ExportFormat::cards) return request;
  request.curves = false;
  request.every = static_cast<int>(std::clamp(expected / (double{strands_of_card} * request.cards), 1.0, 1e6));
  return request;
}

}  // namespace

FilePlace file_place(const Mesh& mesh, const ExportRequest& request) {
  const double metres = request.metres_per_unit.value_or(1);
  if (request.frame == AssetFrame::pelage) return {mesh.centre, glm::dmat3(1), metres, Axis::plus_y};
  const glm::dmat3 turn = glm::transpose(turn_of(mesh.report.up, mesh.report.front));
  return {turn * mesh.centre, turn, metres, mesh.report.up};
}

namespace {

ExportedSkin skin_of(const Mesh& mesh, const FilePlace& place) {
  ExportedSkin skin;
  skin.triangles = mesh.triangles, skin.uvs = mesh.texture_uv;
  for (const glm::vec3 position : mesh.positions)
    skin.points.emplace_back(place.turn * glm::dvec3(position) * mesh.size);
  for (const glm::vec3 normal : mesh.normals) skin.normals.emplace_back(place.turn * glm::dvec3(normal));
  return skin;
}

}  // namespace

std::uint64_t ExportedStrands::count() const {
  return std::accumulate(sets.begin(), sets.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const StrandSet& set) { return sum + set.count(); });
}

std::uint64_t ExportedStrands::points() const {
  return std::accumulate(sets.begin(), sets.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const StrandSet& set) { return sum + set.points.size(); });
}

Result<ExportedStrands> gather_strands(const SceneView& scene, const ExportRequest& asked, const Cancel& cancel) {
  const Mesh& mesh = scene.model.surface.mesh();
  const ModelArrays arrays = make_arrays(scene);
  const FurModel model = make_model(scene, arrays);
  const std::vector<FurSkinRegion> skin = make_skin(scene.settings.skin, mesh);
  const FurFields fields = make_fields(scene, skin, {});
  const FurFrame frame = make_frame(scene, FrameRequest{});
  const double expected = expected_strands(model, frame.coat);
  const ExportRequest request = needed(asked, expected);
  if (Status many = check_count(expected, request); !many.ok()) return many;

  const Grower grower(model, fields, recipe_of(frame, model, request));
  const std::vector<StrandChunk> chunks = make_chunks(model, frame.coat, strands_each * request.every);
  ExportedStrands strands;
  strands.place = file_place(mesh, request), strands.size = mesh.size;
  if (request.skin) strands.skin = skin_of(mesh, strands.place);
  strands.sets.resize(chunks.size());
  for_each_in_parallel(static_cast<std::uint32_t>(chunks.size()), [&](std::uint32_t i) {
    cancel.check();
    strands.sets[i] = grower.grow(chunks[i]);
  });
  std::erase_if(strands.sets, [](const StrandSet& set) { return set.count() == 0; });
  if (request.curves && !frame.curves.empty()) {
    strands.sets.push_back(grow_curves(frame.curves));
    strands.curve_sets = 1;
  }
  add_root_uvs(scene.model.surface, strands, cancel);
  return strands;
}

}  // namespace pelage
