// Builds the model of a scene from a parsed file: prepares the mesh, lays out the fur's patches, subdivides.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/status.h"
#include "protocol/commands/scene.h"
#include "server/history/journal.h"
#include "server/scene/scene.h"
#include "server/surface/prepare.h"

namespace pelage {

/// A prepared model before any triangle is subdivided.
struct UnsubdividedModel {
  PreparedMesh prepared;
  PatchMap patches;
};

/// Prepares a model as `how` says and lays out its fur patches; how.raw is not read. Fails as prepare does, and
/// (invalid, "/fur_patches") if the patches are to follow texture coordinates that the model does not have.
Result<UnsubdividedModel> prepare_model(const RawModel& raw, const StoredModel& how);

/// A mesh, and the patches that map the fur's tile onto it.
struct PatchedMesh {
  Mesh mesh;
  PatchMap patches;
};

/// Subdivides triangles as how.subdivisions says. Fails as subdivide does.
Result<PatchedMesh> apply_subdivisions(PatchedMesh patched, const StoredModel& how);

/// Makes a scene's model from its mesh. `rest` becomes SceneModel::rest.
std::shared_ptr<const SceneModel> finish_model(PatchedMesh patched, const StoredModel& how, std::uint64_t id,
                                               std::shared_ptr<const SceneModel> rest = {});

/// Combines prepare_model, apply_subdivisions and finish_model. Fails as they do.
Result<std::shared_ptr<const SceneModel>> build_model(const RawModel& raw, const StoredModel& how, std::uint64_t id);

/// Returns the number of metres per unit of a model's file, from its format (SceneModel::name); nothing if the format
/// does not define it.
std::optional<double> metres_of(const std::string& name);

// Subdivision of a scene's model together with its fields.

struct SubdividedScene {
  std::shared_ptr<const SceneModel> model;  // null if no triangle was chosen
  FieldSet fields;
};

/// Subdivides as described at Scene::subdivide; `id` is that of the new model. The mask, itself subdivided, is
/// evaluated again at each level to choose the triangles.
Result<SubdividedScene> subdivide_scene(const SceneModel& model, const FieldSet& fields,
                                        const std::vector<EditLayer>& layers, const Subdivide& how, std::uint64_t id);

}  // namespace pelage
