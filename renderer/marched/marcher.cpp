#include "renderer/marched/marcher.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>

#include "protocol/base/parallel.h"
#include "protocol/base/stopwatch.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/marched/bins.h"
#include "renderer/marched/box_cull.h"
#include "renderer/marched/field_overlay.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/kernels.h"
#include "renderer/marched/light_map_overlay.h"
#include "renderer/marched/marcher_kept.h"
#include "renderer/marched/shape_overlay.h"
#include "renderer/marched/shell_shadow.h"
#include "renderer/overlay/field_picture.h"
#include "renderer/shaders/constants.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

constexpr std::size_t max_cached_coats = 3;

/// Vertices of all shells together are bounded, 1.5 million of about 100 bytes: of a mesh of 200,000 triangles 14
/// shells, of the largest four.
int shells_for(const MarchQuality& quality, std::size_t vertices) {
  constexpr std::size_t max_rows = 1'500'000, min_shells = 4;
  const std::size_t affordable = max_rows / std::max<std::size_t>(vertices, 1);
  return std::min(quality.shells, static_cast<int>(std::max(affordable, min_shells + 1) - 1));
}

/// Boundaries of shells: closer to the tips, where rays come in, and fewer where the skin faces the camera.
ShellSet shells_of(const MarchQuality& quality, std::size_t vertices) {
  constexpr std::array<float, 3> silhouettes{0.5f, 0.3f, 0.15f};
  const int count = shells_for(quality, vertices);
  ShellSet shells;
  for (int i = 0; i <= count; ++i) {
    const float below = 1 - static_cast<float>(i) / static_cast<float>(count);
    shells.heights.push_back(1 - std::pow(below, quality.denser));
    float facing = 2;
    for (int k = 0; i > 0 && k < quality.halvings; ++k) {
      if ((count - i) % (1 << (quality.halvings - k)) == 0) break;
      facing = silhouettes[static_cast<std::size_t>(k)];
    }
    shells.facing.push_back(facing);
  }
  return shells;
}

FloatImage picture_of(glm::ivec2 size) {
  FloatImage picture;
  picture.width = size.x, picture.height = size.y;
  picture.rgba.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  return picture;
}

constexpr std::size_t block_vertices = 8;

/// Blocks of vertices, one after the other, of which the pieces or roots of hairs have any.
std::vector<std::size_t> blocks_of(const MarchScene& scene) {
  std::vector<char> used((scene.mesh.positions.size() + block_vertices - 1) / block_vertices);
  for (const std::uint32_t piece : scene.pieces) {
    for (int k = 0; k < 3; ++k) used[scene.mesh.triangles[piece][k] / block_vertices] = 1;
  }
  for (const HairRoot& hair : scene.hairs) {
    for (int k = 0; k < 3; ++k) used[hair.corners[k] / block_vertices] = 1;
  }
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) blocks.push_back(i);
  }
  return blocks;
}

void place_vertices(MarchScene& scene, int threads) {
  constexpr std::size_t grain = 32;
  const std::size_t vertices = scene.mesh.positions.size();
  scene.vertices.resize(vertices * static_cast<std::size_t>(scene.shells.count() * scene.varyings.stride));
  const std::vector<std::size_t> blocks = blocks_of(scene);
  for_each_in_parallel(
      static_cast<std::uint32_t>((blocks.size() + grain - 1) / grain),
      [&](std::uint32_t i) {
        for (std::size_t k = i * grain; k < std::min(blocks.size(), (i + 1) * grain); ++k) {
          const std::size_t begin = blocks[k] * block_vertices;
          place_shell_vertices(scene, begin, std::min(vertices, begin + block_vertices));
        }
      },
      threads);
}

}  // namespace

Marcher::Marcher(int threads) : threads_(threads), kept_(std::make_unique<Kept>()) { assert(threads >= 1); }
Marcher::~Marcher() = default;

std::size_t Marcher::add(const FurModel& model, const FurFields& fields) {
  assert(!has(model.id));
  return meshes_.try_emplace(model.id, model, fields).first->second.bytes();
}

std::size_t Marcher::update(std::uint64_t model, const FurFields& fields) { return meshes_.at(model).update(fields); }

const Marcher::Coated& Marcher::coat_of(const Coat& coat, int finest) {
  const auto found = std::find_if(coats_.begin(), coats_.end(), [&](const Coated& c) {
    return c.slices.finest <= finest && same_strands(c.coat, coat);
  });
  if (found != coats_.end()) {
    coats_.splice(coats_.begin(), coats_, found);
    return coats_.front();
  }
  add(coat, bake_slices(coat, finest));
  return coats_.front();
}

/// A level is chosen by the size of a pixel, and coarser at a slant (level_of in march-inl.h): none is finer than that
/// of the nearest fur seen from above. Either all levels or those from `usual` on, which frames of a whole animal read,
/// so that a camera that comes nearer bakes once.
int Marcher::finest_level(const FurFrame& frame) const {
  constexpr int usual = 2;
  constexpr double rounding = 0.1;  // of the kernel's levels
  const float radius = radius_of_fur(meshes_.at(frame.model).view());
  const double fur = double{radius} * (1 + frame.coat.variation.length);
  const auto level = [&](const FurFrame& seen) {
    const double nearest = -glm::dot(glm::dvec3(seen.camera.position), glm::dvec3(seen.camera.forward)) - fur;
    const int pixels = size_of(seen).y;
    const double pixel = 2 * double{seen.camera.tan_half_fov} / pixels * std::max(nearest, 0.0);
    return std::log2(pixel / finest_texel(seen, pixels));
  };
  double finest = level(frame);
  if (ShadowCache::wanted(frame)) {
    for (const FurLight& light : frame.lights)
      if (light.self_shadow_maps) finest = std::min(finest, level(frame_of_light(frame, light, radius)));
  }
  return finest >= usual + rounding ? usual : 0;
}

bool Marcher::has(const Coat& coat, int finest) const {
  return std::any_of(coats_.begin(), coats_.end(),
                     [&](const Coated& c) { return c.slices.finest <= finest && same_strands(c.coat, coat); });
}

std::optional<CoatNeed> Marcher::missing_coat(const FurFrame& frame) const {
  const int finest = finest_level(frame);
  if (has(frame.coat, finest)) return {};
  return CoatNeed{frame.coat, finest};
}

std::size_t Marcher::coat_bytes() const {
  std::size_t bytes = 0;
  for (const Coated& coated : coats_) bytes += coated.atlas.bytes();
  return bytes;
}

void Marcher::add(const Coat& coat, const Slices& slices) {
  std::erase_if(coats_, [&](const Coated& c) { return same_strands(c.coat, coat); });
  if (coats_.size() == max_cached_coats) coats_.pop_back();
  coats_.emplace_front(coat, slices);
}

std::size_t Marcher::bytes_of(std::uint64_t original) const {
  std::size_t bytes = 0;
  for (const auto& [id, mesh] : meshes_) bytes += mesh.original() == original ? mesh.bytes() : 0;
  return bytes;
}

void Marcher::forget(std::uint64_t original) {
  std::erase_if(meshes_, [&](const auto& mesh) { return mesh.second.original() == original; });
}

void Marcher::forget_all() { meshes_.clear(); }

float Marcher::reach_of(std::uint64_t model) const {
  float longest = 1e-6f;
  for (const glm::vec3& groom : meshes_.at(model).view().groom) longest = std::max(longest, groom.z);
  return std::exp2(std::ceil(std::log2(longest)));
}

std::optional<ClipBox> Marcher::changed_box(const FurFrame& frame, const glm::mat4& to_clip,
                                            std::uint64_t since) const {
  return meshes_.at(frame.model).changed_box(frame.coat, to_clip, since);
}

glm::ivec2 Marcher::size_of(const FurFrame& frame) {
  const auto scaled = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels * frame.knobs.scale)));
  };
  return {scaled(frame.width), scaled(frame.height)};
}

ShellShadow Marcher::shell_shadow_of(const FurFrame& frame, const FurLight& light, float radius,
                                     std::vector<float>& maps) {
  constexpr int samples = 2 * shadow_shells;
  const FurFrame seen = frame_of_light(frame, light, radius);
  MarchScene scene = scene_of(seen, coat_of(seen.coat, finest_level(seen)), shadow_shell_set(), samples);
  scene.box = {0, 0, scene.width, scene.height};
  maps.assign(shell_map_numbers(scene.width), 1.0f);
  draw_tiles(scene, nullptr,
             [&](const Tile& tile, TileScratch& scratch) { draw_shell_shadow(scene, tile, scratch, maps.data()); });
  return {world_to_clip(seen), scene.width, maps.data()};
}

template <class Draw>
void Marcher::draw_tiles(MarchScene& scene, MarchTimes* times, const Draw& draw) const {
  MarchTimes taken;
  const Stopwatch placing;
  scene.pieces = pieces_in_box(scene);
  place_vertices(scene, threads_);
  taken.vertices = placing.milliseconds();
  const Stopwatch sorting;
  const Bins bins(scene);
  taken.bins = sorting.milliseconds();
  const Stopwatch drawing;
  std::atomic<int> next = 0;
  run_on_threads(threads_, [&] {
    TileScratch scratch;
    for (int i = next++; i < bins.count(); i = next++) draw(bins.tile(i), scratch);
  });
  taken.tiles = drawing.milliseconds();
  if (times) *times = taken;
}

FloatImage Marcher::draw(const FurFrame& frame, const MarchQuality& quality, MarchTimes* times) {
  FloatImage picture = picture_of(size_of(frame));
  draw_part(frame, quality, {0, 0, picture.width, picture.height}, picture, nullptr, times);
  return picture;
}

void Marcher::draw_part(const FurFrame& frame, const MarchQuality& quality, const PixelBox& part, FloatImage& picture,
                        std::vector<AovPixel>* aovs, MarchTimes* times) {
  assert(size_of(frame) == glm::ivec2(picture.width, picture.height));
  const std::size_t vertices = meshes_.at(frame.model).view().positions.size();
  MarchScene scene =
      scene_of(frame, coat_of(frame.coat, finest_level(frame)), shells_of(quality, vertices), quality.samples);
  scene.box = part;
  add_ribbons(frame, scene);
  draw_tiles(scene, times, [&](const Tile& tile, TileScratch& scratch) {
    draw_tile(scene, tile, scratch, picture.rgba.data(), aovs ? aovs->data() : nullptr);
  });
}

FloatImage Marcher::draw_bare(const FurFrame& frame, std::vector<AovPixel>& aovs) {
  const ShellSet skin{{0}, {2}};
  const Coated no_fur{frame.coat, Slices{std::vector<SliceLevel>(slice_levels)}};
  MarchScene scene = scene_of(frame, no_fur, skin, 1);
  scene.bare = true, scene.box = {0, 0, scene.width, scene.height};
  FloatImage picture = picture_of({scene.width, scene.height});
  aovs.resize(picture.rgba.size() / 4);
  draw_tiles(scene, nullptr, [&](const Tile& tile, TileScratch& scratch) {
    draw_tile(scene, tile, scratch, picture.rgba.data(), aovs.data());
  });
  return picture;
}

std::optional<FloatImage> Marcher::draw_overlay(const FurFrame& frame) const {
  const MarchMesh mesh = meshes_.at(frame.model).view();
  if (is_light_map(frame.overlay)) return light_map_overlay(frame, mesh, threads_);
  if (is_shape(frame.overlay)) return shape_overlay(frame, mesh, threads_);
  return field_overlay(frame, mesh, threads_);
}

}  // namespace pelage
