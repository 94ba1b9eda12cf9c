#include "renderer/raster/raster.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "renderer/raster/bins.h"
#include "renderer/raster/cull.h"
#include "renderer/raster/kernels.h"
#include "renderer/raster/raster_optics.h"
#include "renderer/raster/shared_light.h"
#include "renderer/raster/skin.h"

namespace pelage {

namespace {

constexpr std::size_t max_batches = 64;  // batches of strands, each for one thread; the same for any number of threads

/// A strand as RasterOutput::strand shows it. `number` counts all strands of the fur from 1.
struct NamedStrand {
  std::size_t number;
  float coat;  // coat_number
};

/// A range of the parts, and their strands placed on the picture.
struct Batch {
  std::size_t first = 0, end = 0;  // range of parts
  std::size_t before = 0;          // number of strands in the parts before `first`
  PlacedStrands placed;
  std::vector<NamedStrand> named;  // for each placed strand, if RasterOutput::strand is shown
  std::size_t lit = 0;
};

void divide(std::span<const GrownPart> parts, std::vector<Batch>& batches) {
  const std::size_t count = std::min(parts.size(), max_batches);
  batches.resize(count);
  std::size_t strands = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Batch& batch = batches[i];
    batch.first = i * parts.size() / count, batch.end = (i + 1) * parts.size() / count;
    batch.before = strands, batch.placed.clear(), batch.named.clear(), batch.lit = 0;
    for (std::size_t k = batch.first; k < batch.end; ++k) strands += parts[k].strands->count();
  }
}

void place_batch(const RasterScene& scene, const PixelBox& box, std::span<const float> hidden, Batch& batch) {
  KeptStrands kept;
  SharedLight light;
  std::size_t number = batch.before;
  for (std::size_t i = batch.first; i < batch.end; ++i) {
    const GrownPart& part = scene.parts[i];
    const std::size_t first_number = std::exchange(number, number + part.strands->count());
    if (!shows_in(scene, part, box)) continue;
    keep_strands(scene, part, kept);
    if (kept.ids.empty()) continue;
    const std::uint32_t last = kept.ids.back();
    const std::size_t before = batch.placed.first.empty() ? 0 : batch.placed.first.size() - 1;
    place_strands(scene, part, box, hidden, kept, batch.placed);
    if (scene.output == RasterOutput::strand)
      for (const std::uint32_t id : kept.ids) batch.named.push_back({first_number + id + 1, coat_number(part)});
    if (!has_knot_values(scene.output)) continue;
    batch.lit += light.light(scene, part, kept.ids, last, before, batch.placed);
  }
}

/// Draws a tile: sorts its segments, blends them, and adds eyes and skin behind them.
struct TileDrawer {
  const RasterScene& scene;
  const PixelBox& box;
  const Bins& bins;
  const SkinPixels& skin;
  std::span<const Batch> batches;
  FloatImage& picture;

  /// Scratch memory of a thread, reused from tile to tile.
  struct Scratch {
    std::vector<BinEntry> sorted, sorting;
    std::vector<TileSegment> segments;
  };
  bool is_drawn(int tile) const {
    const int across = tiles_of(box).across;
    return !scene.drawn || scene.drawn->has(box.left + tile % across * tile_side, box.top + tile / across * tile_side);
  }
  void draw(int tile, Scratch& scratch) const;
  void name_strands(std::span<const BinEntry> segments, TileSums& sums) const;
  void add_skin(int tile, int left, int top, TileSums& sums) const;
  void write(int left, int top, const TileSums& sums) const;
};

void TileDrawer::draw(int tile, Scratch& scratch) const {
  const int across = tiles_of(box).across, left = box.left + tile % across * tile_side,
            top = box.top + tile / across * tile_side;
  TileSums sums;
  std::fill_n(sums.transmittance, tile_pixels, 1.0f);
  for (float* channel : {sums.red, sums.green, sums.blue}) std::fill_n(channel, tile_pixels, 0.0f);
  const std::size_t first_pixel = static_cast<std::size_t>(tile) * tile_pixels;
  std::copy_n(&skin.background_inverse()[first_pixel], tile_pixels, sums.background_inverse);
  sort_by_distance(bins.tile(tile), scratch.sorted, scratch.sorting);
  scratch.segments.clear();
  for (const BinEntry& entry : scratch.sorted) {
    const PlacedKnot* knot = &batches[entry.batch].placed.knots[entry.knot];
    scratch.segments.push_back({knot, knot + 1});
  }
  blend_segments(scene, scratch.segments, left, top, sums);
  if (scene.output == RasterOutput::strand) name_strands(scratch.sorted, sums);
  if (!skin.eyes.empty())
    light_eyes(scene, left, top, std::span(skin.eyes).subspan(first_pixel, tile_pixels),
               std::span(skin.background_inverse()).subspan(first_pixel, tile_pixels), sums);
  add_skin(tile, left, top, sums);
  write(left, top, sums);
}

/// Replaces the number of the segment that covers most of a pixel by its strand's; 0 where skin or an eye covers more.
void TileDrawer::name_strands(std::span<const BinEntry> segments, TileSums& sums) const {
  for (int pixel = 0; pixel < tile_pixels; ++pixel) {
    const auto segment = static_cast<std::size_t>(sums.red[pixel]);
    const float covered = std::exchange(sums.blue[pixel], 0.0f), share = std::exchange(sums.green[pixel], 0.0f);
    sums.red[pixel] = 0;
    if (segment == 0 || (sums.background_inverse[pixel] > 0 && sums.transmittance[pixel] > covered)) continue;
    const BinEntry& entry = segments[segment - 1];
    const PlacedStrands& placed = batches[entry.batch].placed;
    const auto next = std::upper_bound(placed.first.begin(), placed.first.end(), std::uint32_t{entry.knot});
    const NamedStrand& strand = batches[entry.batch].named[static_cast<std::size_t>(next - placed.first.begin()) - 1];
    sums.red[pixel] = static_cast<float>(strand.number);
    sums.green[pixel] = glm::mix(placed.along[entry.knot], placed.along[entry.knot + 1], share);
    sums.blue[pixel] = strand.coat;
  }
}

/// Shades the skin in some pixels of a tile, and adds it weighted by the transmittance of the strands in front.
void blend_skin(const RasterScene& scene, std::span<const int> pixels, SkinSeen& seen, TileSums& sums) {
  for (std::size_t i = pixels.size(); i < SkinSeen::count; ++i)  // fill the unused lanes
    seen.x[i] = seen.x[0], seen.y[i] = seen.y[0], seen.inverse[i] = seen.inverse[0],
    seen.triangle[i] = seen.triangle[0];
  light_skin(scene, seen);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const int pixel = pixels[i];
    float transmittance = std::exchange(sums.transmittance[pixel], 0.0f);
    if (scene.output == RasterOutput::depth) transmittance = transmittance >= 0.5f ? 1.0f : 0.0f;
    sums.red[pixel] += transmittance * seen.red[i], sums.green[pixel] += transmittance * seen.green[i];
    sums.blue[pixel] += transmittance * seen.blue[i];
  }
}

/// Adds the skin where at least min_visible of a pixel is left for it, SkinSeen::count pixels at a time.
void TileDrawer::add_skin(int tile, int left, int top, TileSums& sums) const {
  const std::uint32_t* triangle = &skin.triangle[static_cast<std::size_t>(tile) * tile_pixels];
  const float* inverse = &skin.inverse[static_cast<std::size_t>(tile) * tile_pixels];
  SkinSeen seen;
  std::array<int, SkinSeen::count> pixels{};
  std::size_t count = 0;
  for (int i = 0; i < tile_pixels; ++i) {
    const int x = i % tile_side, y = i / tile_side, pixel = pixel_in_tile(x, y);
    if (!(inverse[pixel] > 0)) continue;
    if (sums.transmittance[pixel] < min_visible) sums.transmittance[pixel] = 0;
    if (sums.transmittance[pixel] == 0) continue;
    seen.x[count] = static_cast<float>(left + x) + 0.5f, seen.y[count] = static_cast<float>(top + y) + 0.5f;
    seen.inverse[count] = inverse[pixel], seen.triangle[count] = triangle[pixel], pixels[count++] = pixel;
    if (count == pixels.size()) blend_skin(scene, pixels, seen, sums), count = 0;
  }
  if (count > 0) blend_skin(scene, std::span(pixels).first(count), seen, sums);
}

void TileDrawer::write(int left, int top, const TileSums& sums) const {
  const int right = std::min(left + tile_side, box.right), bottom = std::min(top + tile_side, box.bottom);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const int pixel = pixel_in_tile(x - left, y - top);
      float* out = &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                      static_cast<std::size_t>(x))];
      out[0] = sums.red[pixel], out[1] = sums.green[pixel], out[2] = sums.blue[pixel],
      out[3] = 1 - sums.transmittance[pixel];
    }
  }
}

/// Places and lights the strands of a box, and sorts their segments into tiles.
void place_and_bin(const RasterScene& scene, const PixelBox& box, const SkinPixels& skin, int threads,
                   std::vector<Batch>& batches, Bins& bins) {
  const auto count = static_cast<std::uint32_t>(batches.size());
  for_each_in_parallel(
      count,
      [&](std::uint32_t i) {
        place_batch(scene, box, skin.hidden, batches[i]);
        bins.find(i, batches[i].placed, skin.furthest, scene.keys);
      },
      threads);
  bins.allocate_entries();
  for_each_in_parallel(
      count, [&](std::uint32_t i) { bins.put(i); }, threads);
}

void draw_tiles(const TileDrawer& drawer, int count, int threads) {
  std::atomic<int> next{0};
  run_on_threads(threads, [&] {
    TileDrawer::Scratch scratch;
    for (int tile = next++; tile < count; tile = next++)
      if (drawer.is_drawn(tile)) drawer.draw(tile, scratch);
  });
}

void darken_tile(const RasterScene& scene, const PixelBox& box, int tile, FloatImage& picture) {
  const int across = tiles_of(box).across, left = box.left + tile % across * tile_side,
            top = box.top + tile / across * tile_side;
  const int right = std::min(left + tile_side, box.right), bottom = std::min(top + tile_side, box.bottom);
  alignas(64) std::array<float, tile_pixels> transmittance{};
  const auto each = [&](const auto& use) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        use(transmittance[static_cast<std::size_t>(pixel_in_tile(x - left, y - top))],
            picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x)) +
                         3]);
  };
  each([](float& open, const float& alpha) { open = 1 - alpha; });
  darken_ground(scene, left, top, transmittance);
  each([](const float& open, float& alpha) { alpha = 1 - open; });
}

/// Returns keys for the distances of the grid, which a stroke seldom moves, with a margin for what reaches beyond it.
DistanceKeys keys_of(const RasterScene& scene) {
  constexpr float beyond = 0.25f;  // sizes
  const GridLayout& grid = *scene.cells;
  const glm::vec3 half = 0.5f * grid.cell * glm::vec3(grid.size);
  const float radius = glm::length(half) + beyond;
  const float middle = glm::dot(grid.low + half - scene.camera.position, scene.camera.forward);
  const float furthest = std::max(middle + radius, 2 * near_distance);
  return {1 / furthest, 1 / std::clamp(middle - radius, near_distance, furthest)};
}

}  // namespace

struct Raster::Cache {
  RasterOptics optics;
  DensityGrid grid;
  NearCells near;
  std::uint64_t sky_of = 0;  // fur_version of the grid that `sky` was made for
  float sky_height = 0;
  SkyOverGround sky;

  void update_sky(const FurModel& model, float height, int threads) {
    if (sky_of == grid.fur_version() && sky_height == height) return;
    sky = sky_over_ground(grid.layout(), grid.density(), model, height, threads);
    sky_of = grid.fur_version(), sky_height = height;
  }
};

struct RasterScratch::Buffers {
  static constexpr std::size_t max_bytes = 64u << 20;  // kept from box to box; more is freed

  std::vector<Batch> batches;
  Bins bins;

  std::size_t bytes() const {
    std::size_t bytes = bins.bytes();
    for (const Batch& batch : batches) bytes += batch.placed.bytes() + batch.named.capacity() * sizeof(NamedStrand);
    return bytes;
  }
};

RasterScratch::RasterScratch() : buffers_(std::make_unique<Buffers>()) {}
RasterScratch::~RasterScratch() = default;

Raster::Raster(int threads, std::shared_ptr<RasterScratch> scratch)
    : threads_(threads), scratch_(std::move(scratch)), cache_(std::make_unique<Cache>()) {
  assert(threads >= 1);
}
Raster::~Raster() = default;

std::uint64_t Raster::version() const { return cache_->grid.version(); }

std::size_t Raster::bytes() const {
  return cache_->grid.bytes() + cache_->near.bytes() + cache_->sky.hidden.size() * sizeof(float);
}

// Extends a box to whole tiles, so that what is drawn does not depend on how a picture is cut into boxes.
PixelBox tile_aligned(const PixelBox& box, int width, int height) {
  const auto up = [](int at, int end) { return std::min((at + tile_side - 1) / tile_side * tile_side, end); };
  return {box.left / tile_side * tile_side, box.top / tile_side * tile_side, up(box.right, width),
          up(box.bottom, height)};
}

std::vector<PixelBox> Raster::boxes_of(const FurFrame& frame, int pixels) {
  PixelBox all{0, 0, frame.width, frame.height};
  if (const std::optional<Crop>& crop = frame.crop)
    all = tile_aligned({crop->left, crop->top, crop->left + crop->width, crop->top + crop->height}, frame.width,
                       frame.height);
  const int rows = std::max(pixels / (all.right - all.left) / tile_side, 1) * tile_side;
  std::vector<PixelBox> boxes;
  for (int top = all.top; top < all.bottom; top += rows)
    boxes.push_back({all.left, top, all.right, std::min(top + rows, all.bottom)});
  return boxes;
}

void Raster::draw_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture, RasterCounts& counts) const {
  const SkinPixels skin(scene, box, threads_);
  std::vector<Batch>& batches = scratch_->buffers_->batches;
  Bins& bins = scratch_->buffers_->bins;
  divide(scene.parts, batches), bins.begin(box, batches.size());
  place_and_bin(scene, box, skin, threads_, batches, bins);
  const int tiles = tiles_of(box).count();
  draw_tiles({scene, box, bins, skin, batches, picture}, tiles, threads_);
  for (const Batch& batch : batches)
    counts.lit += batch.lit, counts.placed += std::max<std::size_t>(batch.placed.first.size(), 1) - 1;
  for (int tile = 0; tile < tiles; ++tile) counts.entries += bins.tile(tile).size();
  const std::size_t bytes = scratch_->buffers_->bytes();
  counts.bytes = std::max(counts.bytes, bytes);
  if (bytes > RasterScratch::Buffers::max_bytes) *scratch_->buffers_ = {};
}

void Raster::darken_box(const RasterScene& scene, const PixelBox& box, FloatImage& picture) const {
  if (!scene.ground || scene.output != RasterOutput::light) return;
  for_each_in_parallel(
      static_cast<std::uint32_t>(tiles_of(box).count()),
      [&](std::uint32_t tile) { darken_tile(scene, box, static_cast<int>(tile), picture); }, threads_);
}

RasterScene Raster::bare_scene_of(const FurModel& model, std::span<const std::array<SkinLook, 3>> skin,
                                  const FurFrame& frame, RasterOutput output) {
  RasterScene scene;
  scene.optics = cache_->optics.of(frame, model);
  scene.width = frame.width, scene.height = frame.height;
  scene.oversampling = static_cast<float>(std::max(frame.knobs.scale, 1.0));
  scene.camera = picture_camera(frame), scene.output = output;
  for (std::size_t k = 0; k < frame.eyes.size(); ++k)
    scene.eyes.push_back(eye_camera(scene.optics.eyes.block.eyes[k], frame.camera, scene.optics.frame.world_to_clip,
                                    {frame.width, frame.height}));
  for (std::size_t i = 0; i < frame.lights.size(); ++i) scene.light_sizes[i] = size_of(frame.lights[i]);
  scene.model = &model, scene.skin = skin;
  return scene;
}

RasterScene Raster::scene_of(const FurModel& model, const GrownFur& fur, const FurFrame& frame,
                             const RasterQuality& quality, RasterOutput output) {
  RasterScene scene = bare_scene_of(model, fur.skin(), frame, output);
  scene.quality = quality, scene.parts = fur.parts(), scene.bend = fur.bend(), scene.coats = frame.coats;
  scene.cells = grid_layout(scene.parts), scene.lights = frame.lights;
  if (frame.ground && frame.ground->height < frame.camera.position.y) scene.ground = frame.ground;
  scene.keys = keys_of(scene);
  return scene;
}

void Raster::fill_cells(RasterScene& scene) {
  cache_->grid.update(*scene.model, scene.parts, scene.lights, threads_);
  scene.grid = &cache_->grid;
  if (scene.ground) {
    cache_->update_sky(*scene.model, scene.ground->height, threads_);
    scene.sky = &cache_->sky;
  }
  cache_->near.update(scene, cache_->grid.version(), threads_);
  scene.near = &cache_->near;
}

FloatImage Raster::draw(const FurModel& model, const GrownFur& fur, const FurFrame& frame, const RasterQuality& quality,
                        RasterCounts* counts, RasterOutput output) {
  RasterCounts counted;
  RasterScene scene = scene_of(model, fur, frame, quality, output);
  fill_cells(scene);
  auto picture = empty_picture<FloatImage>(frame.width, frame.height);
  for (const PixelBox& box : boxes_of(frame)) {
    draw_box(scene, box, picture, counted);
    darken_box(scene, box, picture);
  }
  counted.strands = fur.count();
  if (counts) *counts = counted;
  return picture;
}

}  // namespace pelage
