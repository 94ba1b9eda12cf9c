#include "server/frames/fur_view.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/lean_curve.h"
#include "base/random.h"
#include "server/frames/moved_curves.h"
#include "server/frames/shown_fur.h"
#include "server/groom/evaluate.h"
#include "server/scene/eye_view.h"

namespace pelage {

namespace {

FurGuide make_guide(const GuideCurve& curve, const SceneView& scene) {
  const Surface& surface = scene.model.surface;
  FurGuide guide;
  for (const glm::dvec3& point : curve) guide.points.push_back(surface.mesh().to_internal(point));
  guide.normal = surface.normal(surface.nearest(guide.points.front()));
  return guide;
}

}  // namespace

namespace {

/// Returns for each triangle of the model whether it is hidden; empty if none is.
std::vector<bool> hidden_triangles(const SceneView& scene) {
  if (!scene.masked || scene.fields.at_default(Field::mask)) return {};
  const std::span<const float> mask = scene.fields.values(Field::mask);
  const std::vector<glm::uvec3>& triangles = scene.model.surface.mesh().triangles;
  std::vector<bool> hidden(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    hidden[t] = std::max({mask[triangles[t].x], mask[triangles[t].y], mask[triangles[t].z]}) <= 0.5f;
  return std::find(hidden.begin(), hidden.end(), true) == hidden.end() ? std::vector<bool>() : hidden;
}

bool stands_on(const std::vector<bool>& hidden, const SceneView& scene, const glm::dvec3& position) {
  if (hidden.empty()) return false;
  const Surface& surface = scene.model.surface;
  return hidden[surface.nearest(surface.mesh().to_internal(position)).triangle];
}

}  // namespace

FurCurves make_curves(const CurveGroup& group, const SceneView& scene) {
  FurCurves made;
  const std::vector<bool> hidden = hidden_triangles(scene);
  for (const GuideCurve& curve : group.curves)
    if (!stands_on(hidden, scene, curve.front())) made.guides.push_back(make_guide(curve, scene));
  made.width_root = group.width_root, made.width_tip = group.width_tip;
  made.root_colour = group.root_colour, made.tip_colour = group.tip_colour;
  made.fill = group.fill, made.spread = group.spread, made.seed = group.seed;
  return made;
}

namespace {

FurSkinRegion make_region(const SkinRegion& region, const Mesh& mesh) {
  FurSkinRegion made;
  made.centre = mesh.to_internal(region.centre);
  const glm::dmat3 frame = tilted(upright_frame(region.axis), glm::radians(region.turn_degrees));
  const glm::dmat3 shrunk{frame[0] / region.radii.x, frame[1] / region.radii.y, frame[2] / region.radii.z};
  made.to_unit = glm::transpose(shrunk);
  made.softness = region.softness;
  if (region.facing) {
    const SkinFacing& facing = *region.facing;
    made.facing = glm::normalize(facing.direction);
    made.cosine_full = std::cos(glm::radians(facing.angle_degrees)) - 1e-6;  // 180 degrees must cover everything
    made.cosine_none = std::cos(glm::radians(std::min(180.0, facing.angle_degrees + facing.fade_degrees)));
  }
  made.colour = region.colour;
  made.shine = region.shine, made.roughness = region.roughness;
  made.wetness = region.wetness, made.scatter = region.scatter;
  made.bumps = region.bumps;
  return made;
}

}  // namespace

std::vector<FurSkinRegion> make_skin(const std::vector<SkinRegion>& regions, const Mesh& mesh) {
  std::vector<FurSkinRegion> made;
  made.reserve(regions.size());
  for (const SkinRegion& region : regions) made.push_back(make_region(region, mesh));
  return made;
}

namespace {

/// Converts a light. An area light emits by the cosine law: as a spot light from its middle, with a cone of 90 degrees
/// that fades over its whole width.
FurLight make_light(const Light& light, const Mesh& mesh) {
  const double length = glm::length(light.direction);
  const glm::dvec3 direction = length > 0 ? light.direction / length : glm::dvec3(0, -1, 0);
  const bool area = light.kind == LightKind::area;
  const double cone = glm::radians(light.cone_degrees);
  return {.kind = light.kind,
          .direction = glm::vec3(direction),
          .position = glm::vec3(mesh.to_internal(light.position)),
          .radiance = light.colour * static_cast<float>(light.intensity),
          .cone = area ? 0.0f : static_cast<float>(std::cos(cone)),
          .soft_cone = area ? 1.0f : static_cast<float>(std::cos(cone * (1 - light.cone_softness))),
          .angle = static_cast<float>(glm::radians(light.angle_degrees)),
          .radius = static_cast<float>(light.radius),
          .extent = glm::vec2(light.width, light.height),
          .self_shadow_maps = light.self_shadow_maps,
          .cast_shadow = light.cast_shadow,
          .shadow_scale = static_cast<float>(light.shadow_scale)};
}

FurGround make_ground(const Ground& ground, const Mesh& mesh) {
  float lowest = 0.5f;
  for (const glm::vec3& position : mesh.positions) lowest = std::min(lowest, position.y);
  const double height = ground.height ? mesh.to_internal({0, *ground.height, 0}).y : double{lowest};
  return {static_cast<float>(height), static_cast<float>(ground.shadow), static_cast<float>(ground.contact)};
}

FurPaint make_paint(const FieldSet& fields) {
  const auto numbers = [&](Field field) { return std::span(fields.values(field)); };
  return {
      numbers(Field::density),          numbers(Field::width), numbers(Field::curl), numbers(Field::clump),
      numbers(Field::wetness),          numbers(Field::bare),  numbers(Field::mask), fields.colours(Field::root_colour),
      fields.colours(Field::tip_colour)};
}

}  // namespace

std::uint64_t copy_id(const SceneView& scene) {
  std::uint64_t id = scene.copy_id;
  if (scene.skin_texture) {
    std::uint64_t picture = 0;
    const char* digits = scene.settings.skin_texture.data();
    std::from_chars(digits, digits + 16, picture, 16);
    id = mix_bits(id ^ picture);
  }
  const std::vector<bool> hidden = hidden_triangles(scene);
  for (std::size_t t = 0; t < hidden.size(); ++t)
    if (hidden[t]) id = mix_bits(id ^ (t + 1));
  return id;
}

FurTriangles make_fur_triangles(const Mesh& mesh, const PatchMap& patches, bool has_picture,
                                const std::vector<bool>& hidden) {
  FurTriangles patch_triangles;
  patch_triangles.triangles.reserve(patches.patch_triangles.size());
  patch_triangles.corners.reserve(patches.patch_triangles.size());
  for (const PatchTriangle& patch_triangle : patches.patch_triangles) {
    if (!hidden.empty() && hidden[patch_triangle.triangle]) continue;
    patch_triangles.triangles.push_back(mesh.triangles[patch_triangle.triangle]);
    std::array<FurCorner, 3>& corners = patch_triangles.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const PatchPoint& point = patches.points[patch_triangle.points[static_cast<int>(k)]];
      corners[k].tile_uv = point.uv, corners[k].tile_axis = point.axis, corners[k].weight = point.weight;
      const LookCorner look = has_picture ? LookCorner{mesh.texture_uv[patch_triangle.triangle][k], glm::vec3(1), 0}
                              : mesh.corners.empty() ? LookCorner{}
                                                     : mesh.corners[patch_triangle.triangle][k];
      if (!mesh.shading_normals.empty()) corners[k].normal = mesh.shading_normals[patch_triangle.triangle][k];
      corners[k].image_uv = look.uv, corners[k].colour = look.colour, corners[k].image = look.image;
    }
  }
  return patch_triangles;
}

ModelArrays make_arrays(const SceneView& scene) {
  const Mesh& mesh = scene.model.surface.mesh();
  const RawImage* picture = scene.skin_texture;
  ModelArrays arrays{make_fur_triangles(mesh, scene.model.patches, picture != nullptr, hidden_triangles(scene)), {}};
  if (picture) {
    arrays.images.push_back({picture->width, picture->height, picture->rgba});
  } else {
    for (const RawImage& image : mesh.images) arrays.images.push_back({image.width, image.height, image.rgba});
  }
  return arrays;
}

FurModel make_model(const SceneView& scene, const ModelArrays& arrays) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurModel model{copy_id(scene),
                 mesh.positions,
                 mesh.normals,
                 mesh.tangents,
                 arrays.patch_triangles.triangles,
                 arrays.patch_triangles.corners,
                 arrays.images,
                 scene.skin_texture || !mesh.corners.empty(),
                 scene.copy_id};
  if (scene.model.rest) {
    const Mesh& rest = scene.model.rest->surface.mesh();
    model.rest_positions = rest.positions, model.rest_normals = rest.normals;
  }
  return model;
}

std::vector<NamedCoat> visible_coats(const SceneSettings& settings) {
  std::vector<NamedCoat> seen;
  for (const NamedCoat& coat : settings.coats)
    if (!coat.muted) seen.push_back(coat);
  constexpr std::uint32_t apart = 0x9e3779b9;  // keeps coats of the same seed off each other's roots
  for (NamedCoat& coat : seen) coat.coat.seed += static_cast<std::uint32_t>(coat.id) * apart;
  return seen;
}

std::vector<FurFields> make_fields(const SceneView& scene, std::span<const FurSkinRegion> skin,
                                   std::span<const DirtyRange> dirty, const MovedFur* moved) {
  std::vector<FurFields> all;
  for (const NamedCoat& coat : visible_coats(scene.settings)) {
    const FieldSet fields = scene.fields.of_coat(coat.id);  // shares the scene's arrays
    FurFields& made = all.emplace_back(FurFields{fields.direction(), fields.length(), dirty, skin, make_paint(fields)});
    if (moved) made.direction = (*moved)[all.size() - 1];
    made.coat = coat.id;
  }
  return all;
}

UploadCount sync_scene(Renderer& renderer, const SceneView& scene, const std::vector<VertexRange>& dirty,
                       const MovedFur* moved, bool shells) {
  std::vector<DirtyRange> ranges;
  for (const VertexRange& range : dirty) ranges.push_back({range.begin, range.end});
  const std::vector<FurSkinRegion> skin = make_skin(scene.settings.skin, scene.model.surface.mesh());
  std::vector<FurFields> fields = make_fields(scene, skin, ranges, moved);
  for (FurFields& of_coat : fields)
    if (moved) of_coat.still = scene.fields.of_coat(of_coat.coat).direction();
  const std::uint64_t copy = copy_id(scene);
  const bool known = renderer.has(copy);
  if (known && (!shells || renderer.has_shells(copy))) return renderer.update(copy, fields);
  if (!known) renderer.forget(scene.copy_id);  // it has other colours or hidden triangles
  const ModelArrays arrays = make_arrays(scene);
  const FurModel model = make_model(scene, arrays);
  UploadCount count = known ? renderer.update(copy, fields) : renderer.add(model, fields);
  if (shells) count.bytes += renderer.add_shells(model, fields).bytes;
  return count;
}

FurredSkin furred_skin(const SceneView& scene) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurredSkin skin{mesh.positions, mesh.normals, mesh.triangles,
                  scene.fields.of_coat(visible_coats(scene.settings).front().id).length()};
  if (!mesh.triangles.empty())
    skin.patch_triangles =
        static_cast<double>(scene.model.patches.patch_triangles.size()) / static_cast<double>(mesh.triangles.size());
  return skin;
}

FurFrame make_frame(const SceneView& scene, const FrameRequest& request) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurFrame frame;
  frame.model = copy_id(scene);
  frame.coats = visible_coats(scene.settings);
  frame.look = request.look.value_or(scene.settings.look);
  frame.environment = scene.settings.environment;
  if (scene.settings.ground.visible) frame.ground = make_ground(scene.settings.ground, mesh);
  for (const Light& light : scene.settings.lights) frame.lights.push_back(make_light(light, mesh));
  const std::vector<bool> hidden = hidden_triangles(scene);
  for (const Eye& eye : scene.settings.eyes)
    if (!stands_on(hidden, scene, eye.position)) frame.eyes.push_back(make_eye(eye, mesh));
  for (const CurveGroup& group : scene.settings.curves) frame.curves.push_back(make_curves(group, scene));
  if (const std::optional<double> moment = moment_of(scene, request)) {
    for (FurCurves& curves : frame.curves) {
      std::optional<BodyMotion> body;
      if (scene.swing) body = motion_under(curves, scene.model.surface, *scene.swing);
      sway_curves(curves, scene.settings.wind, *moment, body ? &*body : nullptr);
    }
  }
  frame.skin = make_skin(scene.settings.skin, mesh);
  const PlacedCamera camera = place_camera(request.camera, static_cast<double>(request.width) / request.height, mesh);
  frame.camera = {glm::vec3(camera.position), glm::vec3(camera.right), glm::vec3(camera.up), glm::vec3(camera.forward),
                  static_cast<float>(camera.tan_half_fov)};
  frame.width = request.width, frame.height = request.height, frame.crop = request.crop;
  frame.knobs = request.knobs;
  frame.background = request.background, frame.background_colour = request.background_colour;
  frame.exposure = request.exposure, frame.tone_map = request.tone_map;
  frame.overlay = request.overlay;
  const auto shown = std::ranges::find(frame.coats, request.overlay_coat, &NamedCoat::name);
  if (shown != frame.coats.end()) frame.overlay_coat = static_cast<std::size_t>(shown - frame.coats.begin());
  return frame;
}

}  // namespace pelage
