#include "renderer/raster/gpu/fur_cells.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "renderer/raster/gpu/strand_plan.h"

namespace pelage {

namespace {

constexpr std::size_t sum_bytes = 8 * word_bytes;  // bytes of a cell's sums: sum_words of cells.glsl

template <class T>
bool same_bytes(const std::vector<T>& a, std::span<const T> b) {
  return a.size() == b.size() && (b.empty() || std::memcmp(a.data(), b.data(), b.size_bytes()) == 0);
}

/// Replaces `stored` by `now`. Returns whether they differed.
template <class T>
bool take(T& stored, const T& now) {
  if (stored == now) return false;
  stored = now;
  return true;
}

std::size_t groups_of(std::size_t count) { return (count + strand_group - 1) / strand_group; }

}  // namespace

FurCells::FurCells(const Gl& gl)
    : crossed(gl),
      near(gl),
      sky(gl),
      list_groups_(gl),
      list_parts_(gl),
      bends_sent_(gl),
      leans_sent_(gl),
      bent_(gl),
      cell_sums_(gl),
      body_sums_(gl),
      within_(gl),
      through_(gl),
      columns_(gl) {}

bool FurCells::take_bend(const FurBend& bend) {
  if (same_bytes(bends_, bend.triangles) && (bend.triangles.empty() || same_bytes(leans_, bend.leans))) return false;
  bends_.assign(bend.triangles.begin(), bend.triangles.end()), leans_.assign(bend.leans.begin(), bend.leans.end());
  bends_sent_.send(bend.triangles), leans_sent_.send(bend.leans);
  return true;
}

void FurCells::prepare(const RasterScene& scene, const StrandPool& pool, bool strands_changed) {
  const bool bent = take_bend(scene.bend), moved = take(layout_, *scene.cells), other = take(model_, scene.model->id);
  const bool lit = take(lights_, {scene.lights.begin(), scene.lights.end()});
  const bool nearer = take(near_parts_, near_parts(scene));
  const bool other_ground = scene.ground && take(ground_height_, scene.ground->height);
  const bool strands = strands_changed || bent || moved || other;
  stale_.strands |= strands, stale_.light |= strands || lit, stale_.near |= strands || nearer;
  stale_.sky |= strands || other_ground;
  if (strands || nearer) send_list(scene, pool);
}

void FurCells::send_list(const RasterScene& scene, const StrandPool& pool) {
  std::vector<FurListPart> parts;
  std::vector<glm::uvec2> groups;
  for (std::uint32_t i = 0; i < scene.parts.size(); ++i) {
    const GrownPart& part = scene.parts[i];
    FurListPart listed;
    listed.points = pool.at(i).points, listed.words = pool.at(i).words;
    listed.count = static_cast<std::uint32_t>(part.strands->count()), listed.segments = part.strands->segments;
    if (part.role == StrandRole::coat) listed.summed = summed_strands(part, layout_.cell);
    listed.each = static_cast<float>(listed.count) / static_cast<float>(std::max(listed.summed, 1u));
    for (std::uint32_t strand = 0; strand < listed.count; strand += strand_group) groups.emplace_back(i, strand);
    parts.push_back(listed);
  }
  for (const std::uint32_t i : near_parts_) parts[i].near = 1;
  groups_ = static_cast<std::uint32_t>(groups.size());
  list_groups_.send(std::span<const glm::uvec2>(groups)), list_parts_.send(std::span<const FurListPart>(parts));
}

bool FurCells::bend(Stages& stages, const StrandPool& pool) {
  bent_.reserve(pool.points().bytes());
  if (!stages.begin(Stage::bend, RasterOutput::light,
                    {{points_storage, &pool.points()},
                     {words_storage, &pool.words()},
                     {fur_groups_storage, &list_groups_},
                     {fur_parts_storage, &list_parts_},
                     {bends_storage, &bends_sent_},
                     {leans_storage, &leans_sent_},
                     {bent_storage, &bent_}}))
    return false;
  stages.run(groups_);
  return true;
}

bool FurCells::add_strands(Stages& stages, const RasterScene& scene, const StrandPool& pool) {
  cell_sums_.reserve(scene.cells->count() * sum_bytes), cell_sums_.clear(0);
  if (!stages.begin(Stage::density, RasterOutput::light,
                    {{points_storage, &points(pool)},
                     {fur_groups_storage, &list_groups_},
                     {fur_parts_storage, &list_parts_},
                     {cell_sums_storage, &cell_sums_}}))
    return false;
  stages.run(groups_);
  return true;
}

bool FurCells::update_lights(Stages& stages, const RasterScene& scene, const GpuModel& model) {
  const std::size_t bytes = std::max<std::size_t>(scene.lights.size(), 1) * scene.cells->count() * word_bytes;
  for (Storage* storage : {&body_sums_, &within_, &through_, &crossed}) storage->reserve(bytes);
  body_sums_.clear(0);
  const auto begin = [&](Stage stage, std::initializer_list<StageStorage> storage) {
    return stages.begin(stage, RasterOutput::light, storage) != nullptr;
  };
  if (!begin(Stage::body, {{vertices_storage, &model.vertices},
                           {triangles_storage, &model.triangles},
                           {corners_storage, &model.corners},
                           {body_sums_storage, &body_sums_}}))
    return false;
  stages.run(scene.model->triangles.size());
  if (!begin(Stage::within,
             {{cell_sums_storage, &cell_sums_}, {body_sums_storage, &body_sums_}, {within_storage, &within_}}))
    return false;
  stages.run(groups_of(scene.cells->count()));
  if (!begin(Stage::sweep, {{within_storage, &within_}, {through_storage, &through_}})) return false;
  stages.run(scene.lights.size());
  if (!begin(Stage::look_back, {{within_storage, &within_}, {through_storage, &through_}, {crossed_storage, &crossed}}))
    return false;
  stages.run(groups_of(scene.cells->count()));
  return true;
}

bool FurCells::add_near(Stages& stages, const StrandPool& pool) {
  near.reserve(2 * word_bytes + NearCells::count * sizeof(std::uint16_t)), near.clear(0);
  if (!stages.begin(Stage::near, RasterOutput::light,
                    {{points_storage, &points(pool)},
                     {fur_groups_storage, &list_groups_},
                     {fur_parts_storage, &list_parts_},
                     {near_storage, &near}}))
    return false;
  stages.run(groups_);
  return true;
}

bool FurCells::find_sky(Stages& stages, const RasterScene& scene, const GpuModel& model) {
  const auto columns = static_cast<std::size_t>(layout_.size.x) * static_cast<std::size_t>(layout_.size.z);
  columns_.reserve((1 + 2 * columns) * word_bytes), columns_.clear(0);
  const Program* program = stages.begin(Stage::columns, RasterOutput::light,
                                        {{cell_sums_storage, &cell_sums_},
                                         {vertices_storage, &model.vertices},
                                         {triangles_storage, &model.triangles},
                                         {columns_storage, &columns_}});
  if (!program) return false;
  program->set("of_skin", 0), stages.run(groups_of(columns));
  program->set("of_skin", 1), stages.run(scene.model->triangles.size());
  const SkyOverGround map = sky_map(layout_);
  const auto entries = static_cast<std::size_t>(map.size.x) * static_cast<std::size_t>(map.size.y);
  sky.reserve(entries * word_bytes);
  if (!stages.begin(Stage::sky, RasterOutput::light, {{columns_storage, &columns_}, {sky_storage, &sky}})) return false;
  stages.run(groups_of(entries));
  return true;
}

bool FurCells::find(Stages& stages, const RasterScene& scene, const StrandPool& pool, const GpuModel& model) {
  if (stale_.strands && !bends_.empty() && !bend(stages, pool)) return false;
  if (stale_.strands && !add_strands(stages, scene, pool)) return false;
  stale_.strands = false;
  if (stale_.light && !update_lights(stages, scene, model)) return false;
  stale_.light = false;
  if (stale_.near && has_near() && !add_near(stages, pool)) return false;
  stale_.near &= !has_near();
  if (stale_.sky && scene.ground && !find_sky(stages, scene, model)) return false;
  stale_.sky &= !scene.ground;
  return true;
}

}  // namespace pelage
