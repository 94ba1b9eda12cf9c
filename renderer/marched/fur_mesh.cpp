#include "renderer/marched/fur_mesh.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "renderer/skin/bare.h"
#include "renderer/upload/split_corners.h"

namespace pelage {

namespace {

/// Twice the area of a triangle on the plane, without its sign.
float area_of(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
  return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

float value_of(std::span<const float> field, std::uint32_t vertex, float default_value) {
  return field.empty() ? default_value : field[vertex];
}

glm::vec4 covered(std::span<const glm::vec4> field, std::uint32_t vertex) {
  return field.empty() ? glm::vec4(0) : glm::vec4(glm::vec3(field[vertex]) * field[vertex].a, field[vertex].a);
}

}  // namespace

FurMesh::FurMesh(const FurModel& model, const FurFields& fields)
    : original_(model.original ? model.original : model.id), has_colours_(model.has_colours), images_(model.images) {
  SplitModel split = split_corners(model);
  for (const RenderVertex& vertex : split.vertices) {
    positions_.push_back(vertex.position), normals_.push_back(vertex.normal), tangents_.push_back(vertex.tangent);
    tiles_.push_back(vertex.tile_uv), image_uvs_.push_back(vertex.image_uv), colours_.push_back(vertex.colour);
    weights_.push_back(vertex.weight), shading_normals_.push_back(vertex.shading_normal);
  }
  triangles_ = std::move(split.triangles), first_ = std::move(split.first), welded_ = std::move(split.welded);
  rest_positions_ = by_vertex(model.rest_positions, welded_), rest_normals_ = by_vertex(model.rest_normals, welded_);
  for (const glm::uvec3& t : triangles_) {
    const glm::vec3 across = glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x]);
    const float area = std::max(glm::length(across), 1e-20f),
                on_image = area_of(image_uvs_[t.x], image_uvs_[t.y], image_uvs_[t.z]);
    axes_.push_back({split.vertices[t.x].tile_axis, 0.5f * area_of(tiles_[t.x], tiles_[t.y], tiles_[t.z]),
                     std::sqrt(on_image / area)});
  }
  find_patches(welded_);
  groom_.resize(positions_.size());
  const DirtyRange all{0, static_cast<std::uint32_t>(model.positions.size())};
  update({fields.direction, fields.length, {&all, 1}, fields.skin, fields.paint});
}

/// Triangles that meet at a vertex at the same place on the tile are of one patch.
void FurMesh::find_patches(const std::vector<std::uint32_t>& welded) {
  std::vector<std::uint32_t> parents(triangles_.size());
  std::iota(parents.begin(), parents.end(), 0u);
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> at_place;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = triangles_[i][k];
      const auto [place, added] = at_place.try_emplace({welded[vertex], tiles_[vertex].x, tiles_[vertex].y}, i);
      if (!added) parents[root_of(parents, i)] = root_of(parents, place->second);
    }
  }
  patches_.resize(triangles_.size());
  for (std::uint32_t i = 0; i < patches_.size(); ++i) patches_[i] = root_of(parents, i);
}

bool FurMesh::set_paint(const FurPaint& paint) {
  const bool form = !(paint.density.empty() && paint.width.empty() && paint.wetness.empty() && paint.bare.empty() &&
                      paint.curl.empty() && paint.clump.empty());
  const bool colour = !(paint.root_colour.empty() && paint.tip_colour.empty());
  const std::size_t forms = form ? positions_.size() : 0, painted = colour ? positions_.size() : 0;
  const std::size_t masks = paint.mask.empty() ? 0 : positions_.size();
  if (paint_.size() == forms && painted_.size() == painted && mask_.size() == masks) return false;
  paint_.resize(forms), painted_.resize(painted), mask_.resize(masks);
  return true;
}

std::size_t FurMesh::update(const FurFields& fields) {
  const DirtyRange all{0, static_cast<std::uint32_t>(first_.size() - 1)};
  const bool other_skin = !std::equal(fields.skin.begin(), fields.skin.end(), skin_.begin(), skin_.end());
  if (other_skin) {
    skin_.assign(fields.skin.begin(), fields.skin.end());
    fur_share_.resize(skin_.empty() ? 0 : positions_.size());
    for (std::size_t i = 0; i < fur_share_.size(); ++i)
      fur_share_[i] = static_cast<float>(fur_share(skin_, positions_[i], normals_[i]));
  }
  const bool other_paint = set_paint(fields.paint);
  const std::span<const DirtyRange> dirty = other_skin || other_paint ? std::span(&all, 1) : fields.dirty;
  std::size_t vertices = 0;
  for (const DirtyRange& range : dirty) {
    change(fields, first_[range.begin], first_[range.end]);
    vertices += first_[range.end] - first_[range.begin];
  }
  const auto each = [](const auto& field) { return field.empty() ? 0 : sizeof(field[0]); };
  return vertices * (each(groom_) + each(paint_) + each(painted_) + each(mask_));
}

void FurMesh::change(const FurFields& fields, std::uint32_t begin, std::uint32_t end) {
  const FurPaint& paint = fields.paint;
  for (std::uint32_t i = begin; i < end; ++i) {
    const std::uint32_t v = welded_[i];
    const float share = (fur_share_.empty() ? 1 : fur_share_[i]) * (1 - value_of(paint.bare, v, 0));
    changed_.note(i, groom_[i]);
    groom_[i] = {fields.direction[v], fields.length[v] * share};
    changed_.note(i, groom_[i]);
    if (!paint_.empty())
      paint_[i] = {value_of(paint.density, v, 1), value_of(paint.width, v, 1), value_of(paint.wetness, v, 0),
                   value_of(paint.bare, v, 0),    value_of(paint.curl, v, 0),  value_of(paint.clump, v, 0)};
    if (!mask_.empty()) mask_[i] = paint.mask[v];
    if (painted_.empty()) continue;
    const glm::vec4 root = covered(paint.root_colour, v), tip = covered(paint.tip_colour, v);
    painted_[i] = {root.r, root.g, root.b, root.a, tip.r, tip.g, tip.b, tip.a};
  }
}

MarchMesh FurMesh::view() const {
  return {.positions = positions_,
          .normals = normals_,
          .tangents = tangents_,
          .shading_normals = shading_normals_,
          .tiles = tiles_,
          .weights = weights_,
          .image_uvs = image_uvs_,
          .colours = colours_,
          .groom = groom_,
          .variation = {},
          .paint = paint_,
          .painted = painted_,
          .mask = mask_,
          .welded = welded_,
          .triangles = triangles_,
          .patches = patches_,
          .axes = axes_};
}

std::size_t FurMesh::bytes() const {
  std::size_t bytes = sizeof(FurMesh);
  const auto add = [&](const auto&... arrays) { ((bytes += arrays.capacity() * sizeof(arrays[0])), ...); };
  add(rest_positions_, rest_normals_, positions_, normals_, shading_normals_, tangents_, image_uvs_, colours_, groom_,
      tiles_, weights_, fur_share_, mask_, paint_, painted_, triangles_, patches_, welded_, first_, axes_, skin_);
  return bytes + changed_.bytes();
}

}  // namespace pelage
