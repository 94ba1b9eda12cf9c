#include "renderer/raster/gpu/gpu_raster.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "renderer/raster/gpu/gpu_model.h"
#include "renderer/raster/gpu/scene_block.h"
#include "renderer/raster/gpu/stages.h"
#include "renderer/raster/gpu/storage.h"
#include "renderer/raster/gpu/strand_plan.h"
#include "renderer/raster/gpu/strand_pool.h"

namespace pelage {

namespace {

constexpr std::size_t words = sizeof(std::uint32_t);
constexpr std::size_t knot_bytes = 24, point_bytes = 16, entry_bytes = 8;

/// A uniform block.
class Uniforms {
 public:
  explicit Uniforms(const Gl& gl) : gl_(gl), buffer_(gl) {}

  template <class Block>
  void send(int binding, const Block& block) {
    gl_.NamedBufferData(buffer_.id(), sizeof(Block), &block, GL_DYNAMIC_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer_.id());
  }

 private:
  const Gl& gl_;
  Buffer buffer_;
};

/// What the stages of a box found, and how much of it there was room for.
struct Totals {
  std::uint32_t knots = 0, points = 0, entries = 0, unused = 0;
};

/// Enough for a little more, so that the next frame has room at once.
std::uint32_t more_room(std::uint32_t room, std::uint32_t wanted, std::size_t most) {
  if (wanted <= room) return room;
  return static_cast<std::uint32_t>(std::min<std::size_t>(wanted + std::size_t{wanted} / 4, most));
}

}  // namespace

struct GpuRaster::Held {
  explicit Held(const Gl& of)
      : gl(of),
        stages(of),
        pool(of),
        model(of),
        frame_block(of),
        scattering_block(of),
        skin_block(of),
        scene_uniforms(of),
        plan(of),
        azimuthal(of),
        eyes(of),
        tissues(of),
        caustics(of),
        eye_pixels(of),
        skin_pixels(of),
        ends(of),
        furthest(of),
        blocks(of),
        hidden(of),
        drawn(of),
        strand_knots(of),
        strand_points(of),
        knots(of),
        points(of),
        tile_entries(of),
        tile_counts(of),
        entries(of),
        others(of),
        sums(of),
        scan_sums(of),
        rows(of),
        encoded(of) {
    GLint64 most = 0;
    gl.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    max_bytes = static_cast<std::size_t>(most);
  }

  const Gl& gl;
  std::size_t max_bytes = 0;  // of a buffer that stages read
  Stages stages;
  StrandPool pool;
  GpuModel model;
  Uniforms frame_block, scattering_block, skin_block, scene_uniforms;
  Storage plan, azimuthal;
  Storage eyes, tissues, caustics, eye_pixels;
  Storage skin_pixels, ends, furthest, blocks, hidden, drawn;  // of pixels, tiles and blocks of pixels
  Storage strand_knots, strand_points, knots, points;
  Storage tile_entries, tile_counts, entries, others;
  Storage sums, scan_sums, rows, encoded;
  StageRooms rooms{1 << 16, 1 << 16, 1 << 18};

  /// All that a box is drawn by.
  struct Box {
    const RasterScene& scene;
    const PixelBox& pixels;
    const StrandPlan& strands;
    TileRows tiles;

    std::size_t groups() const { return strands.groups.size(); }
    glm::ivec2 grid() const { return {tiles.across, tiles.down}; }
  };

  void send_scene(const Box& box);
  void send_plan(const StrandPlan& strands);
  void send_eyes(const EyeOptics& optics);
  void send_azimuthal(const AzimuthalFit& fit);
  void reserve(const Box& box);
  bool begin(Stage stage, const Box& box, std::initializer_list<StageStorage> storage) {
    current = stages.begin(stage, box.scene.shown, storage);
    return current;
  }
  bool begin_eyes(Stage stage, const Box& box, const Storage& pixels) {
    return begin(stage, box,
                 {{0, &pixels},
                  {eye_pixels_storage, &eye_pixels},
                  {raster_eyes_storage, &eyes},
                  {raster_tissue_storage, &tissues},
                  {raster_caustics_storage, &caustics}});
  }
  bool scan(const Box& box, const Storage& numbers, std::size_t count);
  bool find_skin(const Box& box);
  bool place_strands(const Box& box);
  bool light_strands(const Box& box);
  bool fill_tiles(const Box& box);
  bool blend(const Box& box);
  bool draw(const Box& box);
  Totals totals() const;
  /// Whether buffers can be as large as that.
  bool has_room_for(const Totals& found) const {
    return found.knots * knot_bytes <= max_bytes && found.points * point_bytes <= max_bytes &&
           found.entries * entry_bytes <= max_bytes;
  }
  /// Makes room for what was found; false where there was enough.
  bool take_more_room(const Box& box, const Totals& found);
  void read(const RasterScene& scene, const PixelBox& box, FloatImage& picture);
  bool encode(const RasterScene& scene, const Encoding& encoding, Image& picture);

  const Program* current = nullptr;
};

void GpuRaster::Held::send_azimuthal(const AzimuthalFit& fit) {
  std::vector<std::int32_t> sent{fit.azimuths, fit.inclinations};
  sent.insert(sent.end(), fit.nodes.begin(), fit.nodes.end());
  azimuthal.send(std::span<const std::int32_t>(sent));
}

void GpuRaster::Held::send_eyes(const EyeOptics& optics) {
  if (!optics.tissues) return;
  eyes.send(std::span<const EyeBlock>(&optics.block, 1));
  if (tissues.bytes() == 0) tissues.send(std::span<const std::int32_t>(optics.tissues->words));  // the same of all eyes
  caustics.send(optics.caustics);
}

void GpuRaster::Held::send_plan(const StrandPlan& strands) {
  const std::size_t parts_at = max_strand_groups * sizeof(glm::uvec2);
  plan.reserve(parts_at + std::max<std::size_t>(strands.parts.size(), 1) * sizeof(PlannedPart));
  plan.send_at(0, std::span<const glm::uvec2>(strands.groups));
  plan.send_at(parts_at, std::span<const PlannedPart>(strands.parts));
}

void GpuRaster::Held::send_scene(const Box& box) {
  const RasterScene& scene = box.scene;
  frame_block.send(frame_binding, scene.optics.frame),
      scattering_block.send(scattering_binding, scene.optics.scattering);
  skin_block.send(skin_binding, scene.optics.skin);
  model.update(scene), send_azimuthal(*scene.optics.azimuthal), send_plan(box.strands);
  send_eyes(scene.optics.eyes);
  std::vector<std::uint32_t> shown(static_cast<std::size_t>(box.tiles.count()), 1);
  for (std::size_t tile = 0; scene.drawn && tile < shown.size(); ++tile) {
    const int x = static_cast<int>(tile) % box.tiles.across, y = static_cast<int>(tile) / box.tiles.across;
    shown[tile] = scene.drawn->has(box.pixels.left + x * tile_side, box.pixels.top + y * tile_side);
  }
  drawn.send(std::span<const std::uint32_t>(shown));
}

void GpuRaster::Held::reserve(const Box& box) {
  const auto tiles = static_cast<std::size_t>(box.tiles.count()), pixels = tiles * tile_pixels;
  const std::size_t strands = box.strands.strands() + std::size_t{1};
  skin_pixels.reserve(pixels * 2 * words), eye_pixels.reserve(box.scene.eyes.empty() ? 16 : pixels * 2 * words);
  ends.reserve(pixels * words), sums.reserve(pixels * 4 * words);
  furthest.reserve(tiles * words), blocks.reserve(tiles * 16 * words), hidden.reserve(tiles * 16 * words);
  tile_entries.reserve((tiles + 1) * words), tile_counts.reserve((tiles + 1) * words);
  rows.reserve(sizeof(Totals) + pixels * 4 * words);
  strand_knots.reserve(strands * words), strand_points.reserve(strands * words);
  scan_sums.reserve((std::max(strands, tiles + 1) / 1024 + 2) * words);
  knots.reserve(rooms.knots * knot_bytes), points.reserve(rooms.points * point_bytes);
  entries.reserve(rooms.entries * entry_bytes), others.reserve(rooms.entries * entry_bytes);
}

/// Each number becomes the sum of those before it.
bool GpuRaster::Held::scan(const Box& box, const Storage& numbers, std::size_t count) {
  if (!begin(Stage::scan, box, {{0, &numbers}, {1, &scan_sums}})) return false;
  const std::size_t runs = (count + 1023) / 1024;
  current->set("count", static_cast<unsigned>(count));
  for (int stage = 0; stage < 3; ++stage) {
    current->set("stage", stage);
    stages.run(stage == 1 ? std::size_t{1} : runs);
  }
  return true;
}

bool GpuRaster::Held::find_skin(const Box& box) {
  constexpr std::array<GLuint, 2> nothing{0, ~GLuint{0}};
  gl.ClearNamedBufferData(skin_pixels.id(), GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, nothing.data());
  if (!begin(Stage::skin, box, {{0, &model.vertices}, {1, &model.triangles}, {2, &skin_pixels}})) return false;
  for (const int naming : {0, 1}) {
    current->set("naming", naming);
    stages.run((box.scene.model->triangles.size() + 7) / 8);
  }
  if (!box.scene.eyes.empty()) {
    if (!begin_eyes(Stage::meet_eyes, box, skin_pixels)) return false;
    stages.run(box.grid());
  }
  if (!begin(Stage::ends, box,
             {{0, &skin_pixels}, {1, &ends}, {2, &furthest}, {3, &blocks}, {4, &drawn}, {5, &eye_pixels}}))
    return false;
  stages.run(box.grid());
  if (!begin(Stage::hidden, box, {{0, &blocks}, {1, &hidden}})) return false;
  stages.run((4 * box.grid() + 15) / 16);
  return true;
}

/// Counts the knots of each strand, and writes them.
bool GpuRaster::Held::place_strands(const Box& box) {
  if (!begin(Stage::keep, box,
             {{points_storage, &pool.points()}, {words_storage, &pool.words()}, {plan_storage, &plan}}))
    return false;
  stages.run(box.groups());
  strand_knots.clear(0);
  for (const int writing : {0, 1}) {
    if (!begin(Stage::place, box,
               {{points_storage, &pool.points()},
                {words_storage, &pool.words()},
                {plan_storage, &plan},
                {hidden_storage, &hidden},
                {strand_knots_storage, &strand_knots},
                {knots_storage, &knots}}))
      return false;
    current->set("writing", writing);
    stages.run(box.groups());
    if (!writing && !scan(box, strand_knots, box.strands.strands() + std::size_t{1})) return false;
  }
  return true;
}

/// Lights the strands whose light is asked for, and hands it on.
bool GpuRaster::Held::light_strands(const Box& box) {
  strand_points.clear(0);
  if (!sends(box.scene.shown)) return true;
  if (!begin(Stage::mark, box,
             {{words_storage, &pool.words()},
              {plan_storage, &plan},
              {strand_points_storage, &strand_points},
              {strand_knots_storage, &strand_knots}}))
    return false;
  stages.run(box.groups());
  if (!scan(box, strand_points, box.strands.strands() + std::size_t{1})) return false;
  const bool is_field = box.scene.shown == RasterOutput::field;
  if (!begin(Stage::light, box,
             {{points_storage, &pool.points()},
              {words_storage, &pool.words()},
              {plan_storage, &plan},
              {strand_points_storage, &strand_points},
              {lit_points_storage, &points},
              {crossed_storage, &model.crossed},
              {is_field ? field_storage : near_storage, is_field ? &model.field : &model.near},
              {is_field ? triangles_storage : azimuthal_storage, is_field ? &model.triangles : &azimuthal}}))
    return false;
  stages.run(box.groups());
  if (!begin(Stage::hand_on, box,
             {{words_storage, &pool.words()},
              {plan_storage, &plan},
              {strand_points_storage, &strand_points},
              {lit_points_storage, &points},
              {strand_knots_storage, &strand_knots},
              {knots_storage, &knots}}))
    return false;
  stages.run(box.groups());
  return true;
}

/// Counts the segments of each tile, writes and sorts them.
bool GpuRaster::Held::fill_tiles(const Box& box) {
  const auto tiles = static_cast<std::size_t>(box.tiles.count());
  tile_entries.clear(0), tile_counts.clear(0);
  for (const int writing : {0, 1}) {
    if (!begin(Stage::bins, box,
               {{0, &strand_knots},
                {1, &knots},
                {2, &furthest},
                {3, writing ? &tile_counts : &tile_entries},
                {4, writing ? &tile_entries : &tile_counts},
                {5, &entries}}))
      return false;
    current->set("writing", writing);
    stages.run(box.groups());
    if (!writing && !scan(box, tile_entries, tiles + 1)) return false;
  }
  if (!begin(Stage::sort, box, {{0, &tile_entries}, {1, &entries}, {2, &others}})) return false;
  current->set("entry_room", rooms.entries);
  stages.run(tiles);
  return true;
}

/// Strands, then the skin behind them, then what the ground is darkened by; to rows of pixels.
bool GpuRaster::Held::blend(const Box& box) {
  if (!begin(Stage::blend, box, {{0, &tile_entries}, {1, &entries}, {2, &knots}, {3, &ends}, {4, &sums}})) return false;
  stages.run(box.grid());
  if (box.scene.shown == RasterOutput::strand) {
    if (!begin(Stage::name, box,
               {{sums_storage, &sums},
                {1, &ends},
                {plan_storage, &plan},
                {strand_knots_storage, &strand_knots},
                {knots_storage, &knots}}))
      return false;
    stages.run(box.grid());
  }
  if (!box.scene.eyes.empty()) {
    if (!begin_eyes(Stage::light_eyes, box, sums)) return false;
    stages.run(box.grid());
  }
  const bool is_field = box.scene.shown == RasterOutput::field;
  if (!begin(Stage::skin_light, box,
             {{sums_storage, &sums},
              {skin_pixels_storage, &skin_pixels},
              {vertices_storage, &model.vertices},
              {corners_storage, &model.corners},
              {looks_storage, &model.looks},
              {crossed_storage, &model.crossed},
              {is_field ? field_storage : texels_storage, is_field ? &model.field : &model.texels},
              {triangles_storage, &model.triangles}}))
    return false;
  stages.run(box.grid());
  if (box.scene.ground && box.scene.shown == RasterOutput::light) {
    if (!begin(Stage::ground, box,
               {{sums_storage, &sums}, {sky_storage, &model.sky}, {crossed_storage, &model.crossed}}))
      return false;
    stages.run(box.grid());
  }
  if (!begin(Stage::resolve, box,
             {{0, &sums}, {1, &rows}, {2, &strand_knots}, {3, &strand_points}, {4, &tile_entries}}))
    return false;
  stages.run(box.grid());
  return true;
}

bool GpuRaster::Held::draw(const Box& box) {
  reserve(box);
  scene_uniforms.send(raster_binding, scene_block(box.scene, box.pixels, box.strands.strands(), rooms));
  return find_skin(box) && place_strands(box) && light_strands(box) && fill_tiles(box) && blend(box);
}

Totals GpuRaster::Held::totals() const {
  Totals found;
  gl.GetNamedBufferSubData(rows.id(), 0, sizeof(Totals), &found);
  return found;
}

bool GpuRaster::Held::take_more_room(const Box& box, const Totals& found) {
  const StageRooms wanted{more_room(rooms.knots, found.knots, max_bytes / knot_bytes),
                          more_room(rooms.points, found.points, max_bytes / point_bytes),
                          more_room(rooms.entries, found.entries, max_bytes / entry_bytes)};
  if (wanted == rooms) return false;
  rooms = wanted;
  send_plan(box.strands);  // without what stages have found of its parts
  return true;
}

/// Of tiles that are drawn, into the picture.
void GpuRaster::Held::read(const RasterScene& scene, const PixelBox& box, FloatImage& picture) {
  const int width = box.right - box.left, height = box.bottom - box.top;
  std::vector<float> pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  rows.read(sizeof(Totals), std::span(pixels));
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

bool GpuRaster::Held::encode(const RasterScene& scene, const Encoding& encoding, Image& picture) {
  encoded.reserve(picture.rgba.size());
  current = stages.begin(Stage::finish, scene.shown, {{0, &rows}, {1, &encoded}});
  if (!current) return false;
  current->set("encoding.exposure", encoding.exposure), current->set("encoding.filmic", int{encoding.filmic});
  current->set("encoding.transparent", int{encoding.transparent}),
      current->set("encoding.studio", int{encoding.studio});
  current->set("encoding.background", encoding.background);
  current->set("encoding.width", encoding.width), current->set("encoding.height", encoding.height);
  current->set("encoding.largest", encoding.largest), current->set("light_size", glm::ivec2(scene.width, scene.height));
  stages.run((glm::ivec2(encoding.width, encoding.height) + 15) / 16);
  encoded.read(0, std::span(picture.rgba));
  return true;
}

Result<std::unique_ptr<GpuRaster>> GpuRaster::create(const Gl& gl) {
  std::unique_ptr<GpuRaster> raster(new GpuRaster(gl));
  // Of what is there seldom the first frame waits.
  for (const Stage stage :
       {Stage::skin, Stage::ends, Stage::hidden, Stage::keep, Stage::place, Stage::mark, Stage::light, Stage::hand_on,
        Stage::bins, Stage::scan, Stage::sort, Stage::blend, Stage::skin_light, Stage::resolve, Stage::finish})
    if (!raster->held_->stages.begin(stage, RasterOutput::light, {})) return raster->held_->stages.failure();
  return raster;
}

GpuRaster::GpuRaster(const Gl& gl) : held_(std::make_unique<Held>(gl)) {}
GpuRaster::~GpuRaster() = default;

bool GpuRaster::can_draw(std::span<const GrownPart> parts) const {
  std::size_t groups = 0;
  for (const GrownPart& part : parts) groups += (part.strands->count() + strand_group - 1) / strand_group;
  return groups <= max_strand_groups && StrandPool::bytes_for(parts) <= held_->max_bytes;
}

void GpuRaster::measure(StageTimes* times) { held_->stages.measure(times); }

int GpuRaster::box_pixels() const {
  constexpr std::size_t most = 1 << 24;
  return static_cast<int>(std::min(held_->max_bytes / 32, most));
}

Result<bool> GpuRaster::draw_rows(const RasterScene& scene, const PixelBox& pixels, RasterCounts& counts) {
  Held& held = *held_;
  held.pool.update(scene.parts);
  const StrandPlan strands = strand_plan(scene, pixels, held.pool);
  const Held::Box box{scene, pixels, strands, tiles_of(pixels)};
  held.send_scene(box);
  Totals found;
  do {
    if (!held.draw(box)) return held.stages.failure();
    found = held.totals();
    lost_ = held.gl.GetGraphicsResetStatus() != GL_NO_ERROR;
    if (lost_) return failure(Code::unavailable, "the GL was reset");
    if (!held.has_room_for(found)) return false;
  } while (held.take_more_room(box, found));
  counts.entries += found.entries, counts.lit += found.points;
  return true;
}

Status GpuRaster::draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts) {
  const Result<bool> drawn = draw_rows(scene, box, counts);
  if (!drawn) return drawn.status();
  if (!*drawn) return draw_halves(scene, box, picture, counts);
  held_->read(scene, box, picture);
  return {};
}

Result<std::optional<Image>> GpuRaster::draw_picture(const RasterScene& scene, const Encoding& encoding) {
  RasterCounts counts;
  const PixelBox whole{0, 0, scene.width, scene.height};
  if (scene.width * std::int64_t{scene.height} > box_pixels()) return std::optional<Image>();
  const Result<bool> drawn = draw_rows(scene, whole, counts);
  if (!drawn) return drawn.status();
  if (!*drawn) return std::optional<Image>();
  auto picture = empty_picture<Image>(encoding.width, encoding.height);
  if (!held_->encode(scene, encoding, picture)) return held_->stages.failure();
  return std::optional<Image>(std::move(picture));
}

/// What one after the other has room.
Status GpuRaster::draw_halves(const RasterScene& scene, const PixelBox& box, FloatImage& picture,
                              RasterCounts& counts) {
  const int middle = box.top + (tiles_of(box).down / 2) * tile_side;
  if (middle == box.top) return failure(Code::too_large, "no memory for a frame of this size", "/width");
  const Status drawn = draw_box(scene, {box.left, box.top, box.right, middle}, picture, counts);
  return drawn.ok() ? draw_box(scene, {box.left, middle, box.right, box.bottom}, picture, counts) : drawn;
}

}  // namespace pelage
