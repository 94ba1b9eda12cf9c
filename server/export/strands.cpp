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

constexpr double strands_each = 6000;  // aimed number of strands in a set
constexpr int strands_of_card = 8;     // strands grown for each card; enough to find clumps

std::vector<GrowRecipe> recipes_for(const FurFrame& frame, const FurModel& model, const ExportRequest& request) {
  std::vector<GrowRecipe> recipes = recipes_of(frame, model.has_colours, fur_area(model));
  for (GrowRecipe& recipe : recipes) {
    recipe.share = 1.0 / request.every;
    recipe.widening = request.widen ? request.every : 1;
  }
  return recipes;
}

/// Writes the texture coordinates at the roots of one set, interpolated on the nearest triangle.
void find_root_uvs(const Surface& surface, const StrandSet& set, glm::vec2* uvs) {
  const std::size_t points = static_cast<std::size_t>(set.segments) + 1;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const SurfacePoint at = surface.nearest(glm::dvec3(set.points[i * points].position));
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

FileTransform file_transform(const Mesh& mesh, const ExportRequest& request) {
  const double metres = request.metres_per_unit.value_or(1);
  if (request.frame == AssetFrame::pelage) return {mesh.centre, glm::dmat3(1), metres, Axis::plus_y};
  const glm::dmat3 turn = glm::transpose(axes_rotation(mesh.report.up, mesh.report.front));
  return {turn * mesh.centre, turn, metres, mesh.report.up};
}

namespace {

ExportedSkin skin_of(const Mesh& mesh, const FileTransform& transform) {
  ExportedSkin skin;
  skin.triangles = mesh.triangles, skin.uvs = mesh.texture_uv;
  for (const glm::vec3 position : mesh.positions)
    skin.points.emplace_back(transform.turn * glm::dvec3(position) * mesh.size);
  for (const glm::vec3 normal : mesh.normals) skin.normals.emplace_back(transform.turn * glm::dvec3(normal));
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

static void grow_coats(const FurModel& model, const std::vector<FurFields>& fields, const FurFrame& frame,
                       const ExportRequest& request, const Cancel& cancel, ExportedStrands& strands) {
  const std::vector<GrowRecipe> recipes = recipes_for(frame, model, request);
  for (std::size_t c = 0; c < recipes.size(); ++c) {
    const Grower grower(model, fields[c], recipes[c]);
    const std::vector<StrandChunk> chunks = make_chunks(model, recipes[c].coat, strands_each * request.every);
    std::vector<StrandSet> sets(chunks.size());
    for_each_in_parallel(static_cast<std::uint32_t>(chunks.size()), [&](std::uint32_t i) {
      cancel.check();
      sets[i] = grower.grow(chunks[i]);
    });
    for (StrandSet& set : sets) {
      if (set.count() == 0) continue;
      strands.sets.push_back(std::move(set)), strands.group_of.push_back(c);
    }
    strands.groups.push_back({static_cast<int>(frame.coats[c].id), frame.coats[c].name});
  }
}

Result<ExportedStrands> gather_strands(const SceneView& scene, const ExportRequest& asked, const Cancel& cancel) {
  const Mesh& mesh = scene.model.surface.mesh();
  const ModelArrays arrays = make_arrays(scene);
  const FurModel model = make_model(scene, arrays);
  const std::vector<FurSkinRegion> skin = make_skin(scene.settings.skin, mesh);
  const FurFrame frame = make_frame(scene, FrameRequest{});
  double expected = 0;
  for (const NamedCoat& coat : frame.coats) expected += expected_strands(model, coat.coat);
  const ExportRequest request = needed(asked, expected);
  if (Status many = check_count(expected, request); !many.ok()) return many;

  ExportedStrands strands;
  strands.transform = file_transform(mesh, request), strands.size = mesh.size;
  if (request.skin) strands.skin = skin_of(mesh, strands.transform);
  grow_coats(model, make_fields(scene, skin, {}), frame, request, cancel, strands);
  if (request.curves && !frame.curves.empty()) {
    strands.group_of.push_back(strands.groups.size()), strands.groups.push_back({limits::coats, "whiskers"});
    strands.sets.push_back(grow_curves(frame.curves));
    strands.curve_sets = 1;
  }
  add_root_uvs(scene.model.surface, strands, cancel);
  return strands;
}

}  // namespace pelage
