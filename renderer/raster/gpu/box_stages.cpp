#include "renderer/raster/gpu/box_stages.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pelage {

namespace {

constexpr std::size_t knot_bytes = 24, point_bytes = 16, entry_bytes = 8;

/// Returns the new capacity: a quarter more than is wanted, so that the next frame fits at once; `capacity` if that
/// suffices.
std::uint32_t grown_capacity(std::uint32_t capacity, std::uint32_t wanted, std::size_t upper_limit) {
  if (wanted <= capacity) return capacity;
  return static_cast<std::uint32_t>(std::min<std::size_t>(wanted + std::size_t{wanted} / 4, upper_limit));
}

/// Returns how many lanes cover one triangle: more for a model of few triangles, because these are large.
std::size_t lanes_a_triangle(std::size_t triangles) {
  constexpr std::size_t enough = 1 << 18, lower_limit = 8, upper_limit = 1024;
  return std::clamp(enough / std::max<std::size_t>(triangles, 1), lower_limit, upper_limit);
}

/// Returns the capacities to start with, before any frame has shown how much is needed.
StageCapacities initial_capacities(std::size_t max_bytes) {
  const auto fitting = [=](std::size_t capacity, std::size_t bytes) {
    return static_cast<std::uint32_t>(std::min(capacity, max_bytes / bytes));
  };
  return {fitting(1 << 16, knot_bytes), fitting(1 << 16, point_bytes), fitting(1 << 18, entry_bytes)};
}

}  // namespace

BoxStages::BoxStages(const Gl& gl, std::size_t max_bytes)
    : gl_(gl),
      max_bytes_(max_bytes),
      stages_(gl),
      skin_pixels_(gl),
      eye_pixels_(gl),
      ends_(gl),
      furthest_(gl),
      blocks_(gl),
      hidden_(gl),
      strand_knots_(gl),
      strand_points_(gl),
      knots_(gl),
      lit_points_(gl),
      tile_entries_(gl),
      tile_counts_(gl),
      entries_(gl),
      others_(gl),
      sums_(gl),
      scan_sums_(gl),
      rows_(gl),
      encoded_(gl) {
  GLint64 upper_limit = 0;
  gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &upper_limit);
  max_bytes_ = std::min(max_bytes_, static_cast<std::size_t>(upper_limit));
  capacities_ = initial_capacities(max_bytes_);
}

void BoxStages::release() {
  for (Storage* storage :
       {&skin_pixels_, &eye_pixels_, &ends_, &furthest_, &blocks_, &hidden_, &strand_knots_, &strand_points_, &knots_,
        &lit_points_, &tile_entries_, &tile_counts_, &entries_, &others_, &sums_, &scan_sums_, &rows_, &encoded_})
    *storage = Storage(gl_);
  capacities_ = initial_capacities(max_bytes_);
}

bool BoxStages::begin(Stage stage, const DrawnBox& box, std::initializer_list<StageStorage> storage) {
  current_ = stages_.begin(stage, box.scene.output, storage);
  return current_;
}

bool BoxStages::begin_eyes(Stage stage, const DrawnBox& box, const SceneData& data, const Storage& pixels) {
  return begin(stage, box,
               {{0, &pixels},
                {eye_pixels_storage, &eye_pixels_},
                {raster_eyes_storage, &data.eyes},
                {raster_tissue_storage, &data.tissues},
                {raster_caustics_storage, &data.caustics}});
}

bool BoxStages::has_room_for(const Totals& found) const {
  return found.knots * knot_bytes <= max_bytes_ && found.lit_points * point_bytes <= max_bytes_ &&
         found.entries * entry_bytes <= max_bytes_;
}

void BoxStages::reserve(const DrawnBox& box) {
  const auto tiles = static_cast<std::size_t>(box.tiles.count()), pixels = tiles * tile_pixels;
  const std::size_t strands = box.strands.strands() + std::size_t{1};
  skin_pixels_.reserve(pixels * 2 * word_bytes);
  if (!box.scene.eyes.empty()) eye_pixels_.reserve(pixels * 2 * word_bytes);
  ends_.reserve(pixels * word_bytes), sums_.reserve(pixels * 4 * word_bytes);
  furthest_.reserve(tiles * word_bytes);
  blocks_.reserve(tiles * 16 * word_bytes), hidden_.reserve(tiles * 16 * word_bytes);
  tile_entries_.reserve((tiles + 1) * word_bytes), tile_counts_.reserve((tiles + 1) * word_bytes);
  rows_.reserve(sizeof(Totals) + pixels * 4 * word_bytes);
  strand_knots_.reserve(strands * word_bytes), strand_points_.reserve(strands * word_bytes);
  scan_sums_.reserve((std::max(strands, tiles + 1) / 1024 + 2) * word_bytes);
  knots_.reserve(capacities_.knots * knot_bytes), lit_points_.reserve(capacities_.lit_points * point_bytes);
  entries_.reserve(capacities_.entries * entry_bytes), others_.reserve(capacities_.entries * entry_bytes);
}

bool BoxStages::scan(const DrawnBox& box, const Storage& numbers, std::size_t count) {
  if (!begin(Stage::scan, box, {{0, &numbers}, {1, &scan_sums_}})) return false;
  const std::size_t runs = (count + 1023) / 1024;
  current_->set("count", static_cast<unsigned>(count));
  for (int stage = 0; stage < 3; ++stage) {
    current_->set("stage", stage);
    stages_.run(stage == 1 ? std::size_t{1} : runs);
  }
  return true;
}

bool BoxStages::find_skin(const DrawnBox& box, const SceneData& data) {
  constexpr std::array<GLuint, 2> nothing{0, ~GLuint{0}};
  gl_.ClearNamedBufferData(skin_pixels_.id(), GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, nothing.data());
  if (!begin(Stage::skin, box, {{0, &data.model.vertices}, {1, &data.model.triangles}, {2, &skin_pixels_}}))
    return false;
  const std::size_t triangles = box.scene.model->triangles.size(), lanes = lanes_a_triangle(triangles);
  current_->set("lanes_a_triangle", static_cast<unsigned>(lanes));
  for (const int naming : {0, 1}) {
    current_->set("naming", naming);
    stages_.run((triangles * lanes + strand_group - 1) / strand_group);
  }
  if (!box.scene.eyes.empty()) {
    if (!begin_eyes(Stage::intersect_eyes, box, data, skin_pixels_)) return false;
    stages_.run(box.grid());
  }
  if (!begin(Stage::ends, box,
             {{0, &skin_pixels_}, {1, &ends_}, {2, &furthest_}, {3, &blocks_}, {4, &data.drawn}, {5, &eye_pixels_}}))
    return false;
  stages_.run(box.grid());
  if (!begin(Stage::hidden, box, {{0, &blocks_}, {1, &hidden_}})) return false;
  stages_.run((4 * box.grid() + 15) / 16);
  return true;
}

bool BoxStages::place_strands(const DrawnBox& box, const SceneData& data) {
  if (!begin(Stage::keep, box,
             {{points_storage, &data.cells.points(data.pool)},
              {words_storage, &data.pool.words()},
              {plan_storage, &data.plan}}))
    return false;
  stages_.run(box.groups());
  strand_knots_.clear(0);
  for (const int writing : {0, 1}) {
    if (!begin(Stage::place, box,
               {{points_storage, &data.cells.points(data.pool)},
                {words_storage, &data.pool.words()},
                {plan_storage, &data.plan},
                {hidden_storage, &hidden_},
                {strand_knots_storage, &strand_knots_},
                {knots_storage, &knots_}}))
      return false;
    current_->set("writing", writing);
    stages_.run(box.groups());
    if (!writing && !scan(box, strand_knots_, box.strands.strands() + std::size_t{1})) return false;
  }
  return true;
}

bool BoxStages::light_strands(const DrawnBox& box, const SceneData& data) {
  strand_points_.clear(0);
  if (!has_knot_values(box.scene.output)) return true;
  if (!begin(Stage::mark, box,
             {{words_storage, &data.pool.words()},
              {plan_storage, &data.plan},
              {strand_points_storage, &strand_points_},
              {strand_knots_storage, &strand_knots_}}))
    return false;
  stages_.run(box.groups());
  if (!scan(box, strand_points_, box.strands.strands() + std::size_t{1})) return false;
  const bool is_field = box.scene.output == RasterOutput::field;
  if (!begin(Stage::light, box,
             {{points_storage, &data.cells.points(data.pool)},
              {words_storage, &data.pool.words()},
              {plan_storage, &data.plan},
              {strand_points_storage, &strand_points_},
              {lit_points_storage, &lit_points_},
              {crossed_storage, &data.cells.crossed},
              {is_field ? field_storage : near_storage, is_field ? &data.model.field : &data.cells.near},
              {is_field ? triangles_storage : azimuthal_storage, is_field ? &data.model.triangles : &data.azimuthal}}))
    return false;
  stages_.run(box.groups());
  if (!begin(Stage::hand_on, box,
             {{words_storage, &data.pool.words()},
              {plan_storage, &data.plan},
              {strand_points_storage, &strand_points_},
              {lit_points_storage, &lit_points_},
              {strand_knots_storage, &strand_knots_},
              {knots_storage, &knots_}}))
    return false;
  stages_.run(box.groups());
  return true;
}

bool BoxStages::fill_tiles(const DrawnBox& box) {
  const auto tiles = static_cast<std::size_t>(box.tiles.count());
  tile_entries_.clear(0), tile_counts_.clear(0);
  for (const int writing : {0, 1}) {  // counts go into tile_entries_, where the scan makes them first entries
    if (!begin(Stage::bins, box,
               {{0, &strand_knots_},
                {1, &knots_},
                {2, &furthest_},
                {3, writing ? &tile_counts_ : &tile_entries_},
                {4, writing ? &tile_entries_ : &tile_counts_},
                {5, &entries_}}))
      return false;
    current_->set("writing", writing);
    stages_.run(box.groups());
    if (!writing && !scan(box, tile_entries_, tiles + 1)) return false;
  }
  if (!begin(Stage::sort, box, {{0, &tile_entries_}, {1, &entries_}, {2, &others_}})) return false;
  current_->set("entry_capacity", capacities_.entries);
  stages_.run(box.grid());
  return true;
}

bool BoxStages::blend(const DrawnBox& box, const SceneData& data) {
  if (!begin(Stage::blend, box, {{0, &tile_entries_}, {1, &entries_}, {2, &knots_}, {3, &ends_}, {4, &sums_}}))
    return false;
  stages_.run(box.grid());
  if (box.scene.output == RasterOutput::strand) {
    if (!begin(Stage::name, box,
               {{sums_storage, &sums_},
                {1, &ends_},
                {plan_storage, &data.plan},
                {strand_knots_storage, &strand_knots_},
                {knots_storage, &knots_}}))
      return false;
    stages_.run(box.grid());
  }
  if (!add_behind(box, data)) return false;
  if (!begin(Stage::resolve, box,
             {{0, &sums_}, {1, &rows_}, {2, &strand_knots_}, {3, &strand_points_}, {4, &tile_entries_}}))
    return false;
  stages_.run(box.grid());
  return true;
}

bool BoxStages::add_behind(const DrawnBox& box, const SceneData& data) {
  if (!box.scene.eyes.empty()) {
    if (!begin_eyes(Stage::light_eyes, box, data, sums_)) return false;
    stages_.run(box.grid());
  }
  const bool is_field = box.scene.output == RasterOutput::field;
  if (!begin(Stage::skin_light, box,
             {{sums_storage, &sums_},
              {skin_pixels_storage, &skin_pixels_},
              {vertices_storage, &data.model.vertices},
              {corners_storage, &data.model.corners},
              {looks_storage, &data.model.looks},
              {crossed_storage, &data.cells.crossed},
              {is_field ? field_storage : texels_storage, is_field ? &data.model.field : &data.model.texels},
              {triangles_storage, &data.model.triangles}}))
    return false;
  stages_.run(box.grid());
  if (box.scene.ground && box.scene.output == RasterOutput::light) {
    if (!begin(Stage::ground, box,
               {{sums_storage, &sums_}, {sky_storage, &data.cells.sky}, {crossed_storage, &data.cells.crossed}}))
      return false;
    stages_.run(box.grid());
  }
  return true;
}

bool BoxStages::draw(const DrawnBox& box, SceneData& data) {
  reserve(box);
  data.send_capacities(box, capacities_);
  return data.cells.find(stages_, box.scene, data.pool, data.model) && find_skin(box, data) &&
         place_strands(box, data) && light_strands(box, data) && fill_tiles(box) && blend(box, data);
}

Totals BoxStages::totals() const {
  Totals found;
  gl_.GetNamedBufferSubData(rows_.id(), 0, sizeof(Totals), &found);
  return found;
}

bool BoxStages::grow_capacities(const Totals& found) {
  const StageCapacities wanted{grown_capacity(capacities_.knots, found.knots, max_bytes_ / knot_bytes),
                               grown_capacity(capacities_.lit_points, found.lit_points, max_bytes_ / point_bytes),
                               grown_capacity(capacities_.entries, found.entries, max_bytes_ / entry_bytes)};
  if (wanted == capacities_) return false;
  capacities_ = wanted;
  return true;
}

void BoxStages::read(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const {
  const int width = box.right - box.left, height = box.bottom - box.top;
  std::vector<float> pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  rows_.read(sizeof(Totals), std::span(pixels));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; x += tile_side) {
      const int column = box.left + x, row = box.top + y, count = std::min(tile_side, width - x);
      if (scene.drawn && !scene.drawn->has(column, row)) continue;
      const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const auto to =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column);
      std::copy_n(&pixels[4 * from], 4 * count, &picture.rgba[4 * to]);
    }
  }
}

bool BoxStages::encode(const RasterScene& scene, const Encoding& encoding) {
  encoded_.reserve(word_bytes * static_cast<std::size_t>(encoding.width) * static_cast<std::size_t>(encoding.height));
  current_ = stages_.begin(Stage::finish, scene.output, {{0, &rows_}, {1, &encoded_}});
  if (!current_) return false;
  current_->set("encoding.exposure", encoding.exposure), current_->set("encoding.filmic", int{encoding.filmic});
  current_->set("encoding.transparent", int{encoding.transparent});
  current_->set("encoding.studio", int{encoding.studio});
  current_->set("encoding.background", encoding.background);
  current_->set("encoding.width", encoding.width), current_->set("encoding.height", encoding.height);
  current_->set("encoding.largest", encoding.largest);
  current_->set("light_size", glm::ivec2(scene.width, scene.height));
  stages_.run((glm::ivec2(encoding.width, encoding.height) + 15) / 16);
  return true;
}

}  // namespace pelage
