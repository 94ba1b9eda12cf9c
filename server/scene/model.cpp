#include "server/scene/model.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/limits.h"
#include "protocol/json/names.h"
#include "server/fields/field_mix.h"
#include "server/scene/digest.h"
#include "server/surface/prepare.h"
#include "server/surface/shading_normals.h"

namespace pelage {

namespace {

Result<PatchMap> lay(const Mesh& mesh, FurPatches how) {
  if (how == FurPatches::own_uvs) {
    Result<PatchMap> own = own_uv_patches(mesh);
    if (own) return own;
    return failure(own.status().code, own.status().message, "/fur_patches", "overlapping | hard");
  }
  PatchMap patches = lay_patches(mesh);
  return how == FurPatches::hard ? with_hard_borders(patches) : std::move(patches);
}

template <class T>
std::string_view bytes_in(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// Returns the id of a mesh: a hash of its placement, triangles, texture coordinates and own colours.
std::string id_of(const Mesh& mesh) {
  std::string parts = digest(bytes_in(mesh.positions)) + digest(bytes_in(mesh.triangles)) +
                      digest(bytes_in(mesh.texture_uv)) + digest(bytes_in(mesh.corners));
  for (const RawImage& image : mesh.images) parts += std::to_string(image.width) + " " + digest(bytes_in(image.rgba));
  const std::vector<double> frame{mesh.centre.x, mesh.centre.y, mesh.centre.z, mesh.size};
  return digest(parts.append(bytes_in(frame)));
}

/// Returns whether the model is built in. Tests compare fur on the built-in plane and cloth with formulas, so their fur
/// stands upright to the rim.
bool is_built_in(const std::string& name) {
  return std::any_of(json_names::builtins.begin(), json_names::builtins.end(),
                     [&](const auto& known) { return known.text == name; });
}

}  // namespace

std::optional<double> metres_of(const std::string& name) {
  return name == "gltf" || name == "glb" ? std::optional(1.0) : std::nullopt;
}

Result<UnsubdividedModel> prepare_model(const RawModel& raw, const StoredModel& how) {
  Result<PreparedMesh> prepared = prepare_with_sources(raw, how.prepare);
  if (!prepared) return prepared.status();
  if (!is_built_in(how.name)) lean_over_rims(prepared->mesh);
  Result<PatchMap> patches = lay(prepared->mesh, how.fur_patches);
  if (!patches) return patches.status();
  return UnsubdividedModel{std::move(*prepared), std::move(*patches)};
}

Result<PatchedMesh> apply_subdivisions(PatchedMesh patched, const StoredModel& how) {
  for (const ChosenTriangles& chosen : how.subdivisions) {
    Result<SubdividedSurface> finer = subdivide(patched.mesh, patched.patches, chosen);
    if (!finer) return finer.status();
    patched = {std::move(finer->mesh), std::move(finer->patches)};
  }
  return patched;
}

std::shared_ptr<const SceneModel> finish_model(PatchedMesh patched, const StoredModel& how, std::uint64_t id,
                                               std::shared_ptr<const SceneModel> rest) {
  std::string mesh_id = id_of(patched.mesh);
  return std::shared_ptr<const SceneModel>(new SceneModel{Surface(std::move(patched.mesh)), std::move(patched.patches),
                                                          id, how.name, how.fur_patches, how.subdivisions,
                                                          std::move(mesh_id), std::move(rest)});
}

Result<std::shared_ptr<const SceneModel>> build_model(const RawModel& raw, const StoredModel& how, std::uint64_t id) {
  Result<UnsubdividedModel> patched = prepare_model(raw, how);
  if (!patched) return patched.status();
  Result<PatchedMesh> split = apply_subdivisions({std::move(patched->prepared.mesh), std::move(patched->patches)}, how);
  if (!split) return split.status();
  return finish_model(std::move(*split), how, id);
}

namespace {

ChosenTriangles choose(const Mesh& mesh, const FieldSet& fields, bool masked) {
  constexpr float chosen_from = 0.5f;
  const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  if (!masked) return {{0, triangles}};
  ChosenTriangles chosen;
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const glm::uvec3 v = mesh.triangles[t];
    const auto mask = [&](std::uint32_t vertex) { return fields.number(Field::mask, vertex); };
    if (std::max({mask(v.x), mask(v.y), mask(v.z)}) <= chosen_from) continue;
    if (!chosen.empty() && chosen.back().end == t)
      ++chosen.back().end;
    else
      chosen.push_back({t, t + 1});
  }
  return chosen;
}

/// Checks the number of triangles, which is known in advance if all triangles are split.
Status check_count(const Mesh& mesh, const Subdivide& how) {
  const double triangles = static_cast<double>(mesh.triangles.size()) * std::pow(4.0, how.levels);
  if (how.masked || triangles <= static_cast<double>(limits::model_triangles)) return {};
  return failure(Code::invalid, "The finer model would have more triangles than a model may have.", "/levels",
                 "at most " + std::to_string(limits::model_triangles) + " triangles");
}

}  // namespace

Result<SubdividedScene> subdivide_scene(const SceneModel& model, const FieldSet& fields,
                                        const std::vector<EditLayer>& layers, const Subdivide& how, std::uint64_t id) {
  if (Status many = check_count(model.surface.mesh(), how); !many.ok()) return many;
  Mesh mesh = model.surface.mesh();
  PatchMap patches = model.patches;
  SubdividedScene subdivided{nullptr, fields};
  std::vector<ChosenTriangles> subdivisions = model.subdivisions;
  for (int level = 0; level < how.levels; ++level) {
    ChosenTriangles chosen = choose(mesh, subdivided.fields, how.masked);
    if (chosen.empty()) return subdivided;
    Result<SubdividedSurface> finer = subdivide(mesh, patches, chosen);
    if (!finer) return failure(finer.status().code, finer.status().message, "/levels", finer.status().limit);
    subdivided.fields = pelage::subdivided(subdivided.fields, mesh, finer->mesh, finer->parents, layers);
    mesh = std::move(finer->mesh), patches = std::move(finer->patches);
    subdivisions.push_back(std::move(chosen));
  }
  std::string mesh_id = id_of(mesh);
  subdivided.model =
      std::shared_ptr<const SceneModel>(new SceneModel{Surface(std::move(mesh)), std::move(patches), id, model.name,
                                                       model.fur_patches, std::move(subdivisions), std::move(mesh_id)});
  return subdivided;
}

}  // namespace pelage
