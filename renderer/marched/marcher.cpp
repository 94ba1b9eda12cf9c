#include "renderer/marched/marcher.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>

#include "protocol/base/parallel.h"
#include "protocol/base/stopwatch.h"
#include "renderer/coat/strand_tile.h"
#include "renderer/marched/bins.h"
#include "renderer/marched/box_cull.h"
#include "renderer/marched/field_overlay.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/hair_ribbons.h"
#include "renderer/marched/kernels.h"
#include "renderer/marched/light_map_overlay.h"
#include "renderer/marched/shadow_cache.h"
#include "renderer/marched/shell_shadow.h"
#include "renderer/pattern/tufts.h"
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

void add_camera(const FurFrame& frame, MarchScene& scene) {
  const FurCamera& camera = frame.camera;
  const float up = camera.tan_half_fov, right = up * static_cast<float>(frame.width) / static_cast<float>(frame.height);
  scene.viewpoint = camera.position, scene.forward = camera.forward;
  scene.ray_0 = camera.forward - right * camera.right + up * camera.up;
  scene.ray_x = camera.right * (2 * right / static_cast<float>(scene.width));
  scene.ray_y = camera.up * (-2 * up / static_cast<float>(scene.height));
}

/// Gives the rows of what a frame interpolates their places.
Varyings varyings_of(const MarchScene& scene) {
  Varyings at;
  const auto take = [&](bool wanted, int& place, int rows) {
    if (wanted) place = std::exchange(at.stride, at.stride + rows);
  };
  const bool pattern = scene.optics.pattern.volume != nullptr;
  take(pattern || scene.optics.tufts.volume, at.root, 3), take(pattern, at.varied, 2);
  take(!scene.optics.casters.empty(), at.open, 4), take(scene.optics.model_colours, at.image, 6);
  take(scene.optics.paint.form, at.paint, 6), take(scene.optics.paint.colour, at.painted, 8);
  return at;
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

struct Marcher::Coated {
  Coat coat;
  Slices slices;
  SliceAtlas atlas;

  Coated(const Coat& of, Slices baked) : coat(of), slices(std::move(baked)), atlas(slices) {
    for (SliceLevel& level : slices.levels) level.shape = {}, level.colour = {};  // the atlas has them now
  }
};

namespace {

/// Maps of the shells of a frame's lights.
struct ShellShadows {
  struct Key {
    std::uint64_t model = 0, changes = 0;
    Coat coat;
    std::vector<FurLight> lights;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  Key key;
  std::vector<std::vector<float>> maps;
  std::vector<ShellShadow> shadows;   // of each light
  std::vector<ShadowCaster> casters;  // of the last frame
};

}  // namespace

struct Marcher::Kept {
  std::optional<Look> look;
  ScatteringBlock scattering{};
  AzimuthalFit azimuthal;
  std::uint64_t model = 0;
  std::optional<PatternBlock> pattern;
  SurfaceVolume volume;
  std::vector<glm::vec4> variation;
  std::uint64_t tufted = 0;  // the model of the tufts
  std::optional<Tufts> tufts;
  SurfaceVolume tuft_volume;
  std::optional<Coat> clumped;  // whose clumps they are
  std::vector<std::int32_t> clumps;
  float clump_reach = 0;
  std::uint64_t standing = 0;  // the model on the ground
  float ground_height = 0;
  GroundContact contact;
  std::vector<FurCurves> curves;
  CurveStrips strips;        // of those curves
  std::uint64_t haired = 0;  // the model of the hairs
  int hair_count = 0;
  std::vector<HairRoot> hairs;
  ShadowCache shadows;
  ShellShadows shell_shadows;
};

Marcher::Marcher(int threads) : threads_(threads), kept_(std::make_unique<Kept>()) { assert(threads >= 1); }
Marcher::~Marcher() = default;

std::size_t Marcher::add(const FurModel& model, const FurFields& fields) {
  assert(!has(model.id));
  return meshes_.try_emplace(model.id, model, fields).first->second.bytes();
}

std::size_t Marcher::update(std::uint64_t model, const FurFields& fields) { return meshes_.at(model).update(fields); }

const Marcher::Coated& Marcher::coat_of(const Coat& coat) {
  const auto found =
      std::find_if(coats_.begin(), coats_.end(), [&](const Coated& c) { return same_strands(c.coat, coat); });
  if (found != coats_.end()) {
    coats_.splice(coats_.begin(), coats_, found);
    return coats_.front();
  }
  add(coat, bake_slices(coat));
  return coats_.front();
}

bool Marcher::has(const Coat& coat) const {
  return std::any_of(coats_.begin(), coats_.end(), [&](const Coated& c) { return same_strands(c.coat, coat); });
}

void Marcher::add(const Coat& coat, Slices slices) {
  if (coats_.size() == max_cached_coats) coats_.pop_back();
  coats_.emplace_front(coat, std::move(slices));
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

void Marcher::add_pattern(const FurFrame& frame, MarchScene& scene) {
  if (!has_pattern(frame.coat)) return;
  const PatternBlock block = make_pattern_block(frame.coat);
  Kept& kept = *kept_;
  if (kept.model != frame.model || kept.pattern != block) {
    kept.model = frame.model, kept.pattern = block;
    kept.volume = make_surface_volume(
        {scene.mesh.positions, scene.mesh.normals, scene.mesh.triangles},
        [&](glm::vec3 middle, glm::vec3 normal) { return glm::vec4(pattern_weights(block, middle, normal), 1); });
    kept.variation.clear();
    for (const glm::vec3& place : scene.mesh.positions) kept.variation.push_back(pattern_variation(block, place));
  }
  scene.mesh.variation = kept.variation;
  scene.optics.pattern = {block.colour, block.inner_colour, block.belly_colour,
                          block.axis.w, kept.volume.origin, 1.0f / (glm::vec3(kept.volume.size) * kept.volume.cell),
                          &kept.volume};
}

glm::ivec2 Marcher::size_of(const FurFrame& frame) {
  const auto scaled = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels * frame.knobs.scale)));
  };
  return {scaled(frame.width), scaled(frame.height)};
}

void Marcher::add_tufts(const FurFrame& frame, MarchScene& scene) {
  const Tufts& tufts = frame.coat.tufts;
  if (!(tufts.gather > 0)) return;
  Kept& kept = *kept_;
  const float longest = longest_pull(tufts);
  if (kept.tufted != frame.model || kept.tufts != tufts) {
    kept.tufted = frame.model, kept.tufts = tufts;
    kept.tuft_volume = make_surface_volume({scene.mesh.positions, scene.mesh.normals, scene.mesh.triangles},
                                           [&](glm::vec3 middle, glm::vec3 normal) {
                                             const TuftPlace tuft = tuft_at(tufts, middle, normal);
                                             return glm::vec4(0.5f + 0.5f * tuft.to_middle / longest, tuft.inside);
                                           });
  }
  const SurfaceVolume& volume = kept.tuft_volume;
  scene.optics.tufts = {gathered(tufts, 1), longest, volume.origin, 1.0f / (glm::vec3(volume.size) * volume.cell),
                        &volume};
}

void Marcher::add_paint(const FurFrame& frame, MarchScene& scene) {
  PaintOptics& paint = scene.optics.paint;
  const Coat& coat = frame.coat;
  paint.form = !scene.mesh.paint.empty(), paint.colour = !scene.mesh.painted.empty();
  paint.wetness = static_cast<float>(coat.wetness), paint.curl = static_cast<float>(coat.curl);
  paint.curl_turns = static_cast<float>(coat.curl_turns);
  if (!paint.form) return;
  Kept& kept = *kept_;
  if (!kept.clumped || !same_strands(*kept.clumped, coat)) {
    const ClumpMap map = bake_clump_map(coat);
    kept.clumps.resize(map.texels.size() / 4);
    std::memcpy(kept.clumps.data(), map.texels.data(), map.texels.size());
    kept.clump_reach = static_cast<float>(map.reach), kept.clumped = coat;
  }
  paint.clumps = kept.clumps, paint.clump_side = ClumpMap::side, paint.clump_reach = kept.clump_reach;
}

void Marcher::add_ribbons(const FurFrame& frame, MarchScene& scene) {
  if (frame.curves.empty() && frame.knobs.guard_hairs == 0) return;
  const RibbonCamera camera{
      scene.optics.frame.world_to_clip, scene.viewpoint, scene.optics.frame.viewpoint.w, {scene.width, scene.height}};
  std::vector<Ribbon> ribbons = ribbons_of(kept_->strips, camera);
  if (frame.knobs.guard_hairs > 0) {
    Kept& kept = *kept_;
    const HairMesh mesh{scene.mesh.positions, scene.mesh.normals, scene.mesh.triangles, scene.mesh.welded};
    if (kept.haired != frame.model || kept.hair_count != frame.knobs.guard_hairs) {
      kept.haired = frame.model, kept.hair_count = frame.knobs.guard_hairs;
      kept.hairs = scatter_hairs(mesh, kept.hair_count);
    }
    scene.hairs = shown_hairs(mesh, kept.hairs, scene.viewpoint).roots;
    const std::vector<Ribbon> hairs = hair_ribbons(frame.coat, scene.hairs, scene, camera);
    ribbons.insert(ribbons.end(), hairs.begin(), hairs.end());
  }
  scene.ribbons = Ribbons(std::move(ribbons), scene);
}

void Marcher::add_ground(const FurFrame& frame, MarchScene& scene) {
  if (!frame.ground || frame.camera.position.y <= frame.ground->height) return;
  Kept& kept = *kept_;
  if (kept.standing != frame.model || kept.ground_height != frame.ground->height) {
    kept.standing = frame.model, kept.ground_height = frame.ground->height;
    kept.contact = make_ground_contact(scene.mesh.positions, scene.mesh.triangles, frame.ground->height, threads_);
  }
  scene.ground = {frame.ground->height, frame.ground->contact, frame.ground->shadow, &kept.contact};
}

ShellShadow Marcher::shell_shadow_of(const FurFrame& frame, const FurLight& light, float radius,
                                     std::vector<float>& maps) {
  constexpr int samples = 2 * shadow_shells;
  const FurFrame seen = frame_of_light(frame, light, radius);
  MarchScene scene = scene_of(seen, shadow_shell_set(), samples);
  scene.box = {0, 0, scene.width, scene.height};
  maps.assign(shell_map_numbers(scene.width), 1.0f);
  draw_tiles(scene, nullptr,
             [&](const Tile& tile, TileScratch& scratch) { draw_shell_shadow(scene, tile, scratch, maps.data()); });
  return {world_to_clip(seen), scene.width, maps.data()};
}

void Marcher::add_shell_shadows(const FurFrame& frame, MarchScene& scene) {
  const bool any = std::any_of(frame.lights.begin(), frame.lights.end(),
                               [](const FurLight& light) { return light.self_shadow_maps; });
  if (!any) return;
  ShellShadows& kept = kept_->shell_shadows;
  const ShellShadows::Key key{frame.model, meshes_.at(frame.model).changes(), frame.coat, frame.lights,
                              frame.knobs.shadow_resolution};
  const std::span<const ShadowCaster> casters = scene.optics.casters;
  if (kept.key != key) {
    kept.key = key;
    kept.maps.assign(frame.lights.size(), {});
    kept.shadows.assign(frame.lights.size(), {});
    const float radius = radius_of_fur(scene.mesh);
    for (std::size_t i = 0; i < frame.lights.size(); ++i) {
      if (frame.lights[i].self_shadow_maps && casters[i].depths)
        kept.shadows[i] = shell_shadow_of(frame, frame.lights[i], radius, kept.maps[i]);
    }
  }
  kept.casters.assign(casters.begin(), casters.end());
  for (std::size_t i = 0; i < kept.casters.size(); ++i) kept.casters[i].shells = kept.shadows[i];
  scene.optics.casters = kept.casters;
}

void Marcher::add_optics(const FurFrame& frame, const FurMesh& mesh, const Coated& coated, MarchScene& scene) {
  FrameOptics& optics = scene.optics;
  optics.frame = make_frame_block(frame, coated.slices, mesh.has_colours(), scene.height);
  const Look look = wet_look(frame.coat, frame.look);
  Kept& kept = *kept_;
  if (kept.look != look) {
    kept.look = look;
    kept.scattering = scattering_block(look), kept.azimuthal = fit_azimuthal(make_scattering_table(look));
  }
  optics.scattering = kept.scattering, optics.azimuthal = &kept.azimuthal;
  optics.model = static_cast<int>(frame.look.shading), optics.lights = static_cast<int>(frame.lights.size());
  optics.environment = true;
  optics.far_lights = std::all_of(frame.lights.begin(), frame.lights.end(),
                                  [](const FurLight& light) { return light.kind == LightKind::directional; });
  optics.model_colours = optics.frame.skin.w > 0.5f;
  if (!frame.skin.empty()) optics.skin = make_skin_block(frame.skin);
  if (optics.model_colours && !mesh.images().empty()) optics.images = &mesh.images();
  add_pattern(frame, scene), add_tufts(frame, scene), add_paint(frame, scene);
}

MarchScene Marcher::scene_of(const FurFrame& frame, const ShellSet& shells, int samples) {
  const FurMesh& mesh = meshes_.at(frame.model);
  const Coated& coated = coat_of(frame.coat);
  MarchScene scene;
  scene.mesh = mesh.view(), scene.atlas = &coated.atlas;
  scene.width = size_of(frame).x, scene.height = size_of(frame).y;
  scene.shells = shells, scene.samples = samples;
  add_optics(frame, mesh, coated, scene);
  scene.bends = scene.optics.tufts.volume || scene.optics.paint.form;
  scene.reach = 3 * reach_of(frame.model) * scene.optics.frame.tile.x;
  add_camera(frame, scene);
  if (kept_->curves != frame.curves) kept_->curves = frame.curves, kept_->strips = make_strips(frame.curves);
  kept_->shadows.add(frame, mesh.changes(), kept_->strips, threads_, scene);
  if (!scene.optics.casters.empty()) add_shell_shadows(frame, scene);
  scene.varyings = varyings_of(scene);
  if (!frame.eyes.empty() && !eyes_) eyes_ = std::make_unique<EyeCache>();
  if (!frame.eyes.empty()) eyes_->add(frame, scene);
  add_ground(frame, scene);
  return scene;
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
  MarchScene scene = scene_of(frame, shells_of(quality, vertices), quality.samples);
  scene.box = part;
  add_ribbons(frame, scene);
  draw_tiles(scene, times, [&](const Tile& tile, TileScratch& scratch) {
    draw_tile(scene, tile, scratch, picture.rgba.data(), aovs ? aovs->data() : nullptr);
  });
}

FloatImage Marcher::draw_bare(const FurFrame& frame, std::vector<AovPixel>& aovs) {
  const ShellSet skin{{0}, {2}};
  MarchScene scene = scene_of(frame, skin, 1);
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
  return field_overlay(frame, mesh, threads_);
}

}  // namespace pelage
