// What a frame of marched fur is drawn from, made of the frame, its model and what is kept.
#include "renderer/marched/march_scene.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "renderer/coat/strand_tile.h"
#include "renderer/marched/fur_hull.h"
#include "renderer/marched/hair_ribbons.h"
#include "renderer/marched/marcher.h"
#include "renderer/marched/marcher_kept.h"
#include "renderer/pattern/tufts.h"
#include "renderer/upload/blocks.h"

namespace pelage {

namespace {

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

}  // namespace

void Marcher::add_pattern(const FurFrame& frame, MarchScene& scene) {
  if (!has_pattern(frame.coat)) return;
  const PatternBlock block = make_pattern_block(frame.coat);
  Kept& kept = *kept_;
  if (kept.model != frame.model || kept.pattern != block) {
    kept.model = frame.model, kept.pattern = block;
    const FurMesh& mesh = meshes_.at(frame.model);
    kept.volume = make_surface_volume(mesh.surface(), [&](const RestPosePoint& middle) {
      return glm::vec4(pattern_weights(block, middle.place, middle.normal), 1);
    });
    kept.variation.clear();
    for (const glm::vec3& place : mesh.rest_places()) kept.variation.push_back(pattern_variation(block, place));
  }
  scene.mesh.variation = kept.variation;
  scene.optics.pattern = {block.colour, block.inner_colour, block.belly_colour,
                          block.axis.w, kept.volume.origin, 1.0f / (glm::vec3(kept.volume.size) * kept.volume.cell),
                          &kept.volume};
}

void Marcher::add_tufts(const FurFrame& frame, MarchScene& scene) {
  const Tufts& tufts = frame.coat.tufts;
  if (!(tufts.gather > 0)) return;
  Kept& kept = *kept_;
  const float longest = longest_pull(tufts);
  if (kept.tufted != frame.model || kept.tufts != tufts) {
    kept.tufted = frame.model, kept.tufts = tufts;
    kept.tuft_volume = make_surface_volume(meshes_.at(frame.model).surface(), [&](const RestPosePoint& middle) {
      const TuftPlace tuft = tuft_at(tufts, middle);
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

MarchScene Marcher::scene_of(const FurFrame& frame, const Coated& coated, const ShellSet& shells, int samples) {
  const FurMesh& mesh = meshes_.at(frame.model);
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
  if (!frame.eyes.empty()) scene.optics.eyes = eyes_->of(frame);
  for (std::size_t k = 0; k < frame.eyes.size(); ++k)
    scene.eyes.push_back(eye_camera(scene.optics.eyes.block.eyes[k], frame.camera, scene.optics.frame.world_to_clip,
                                    {scene.width, scene.height}));
  add_ground(frame, scene);
  return scene;
}

}  // namespace pelage
