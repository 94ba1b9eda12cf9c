// From a parsed model to one that a scene can hold.
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

/// A model on its own triangles, before any is split.
struct LaidModel {
  PreparedMesh prepared;
  PatchMap patches;
};

/// Prepares a model as `how` says (its bytes are not looked at) and lays its patches. Fails as prepare does, and
/// (invalid, "/fur_patches") where the model has no texture coordinates to lay them by.
Result<LaidModel> lay_model(const RawModel& raw, const StoredModel& how);

/// Triangles and where the fur's tile lies on them.
struct LaidMesh {
  Mesh mesh;
  PatchMap patches;
};

/// Splits triangles as `how` says. Fails as subdivide does.
Result<LaidMesh> split_triangles(LaidMesh laid, const StoredModel& how);

/// `rest`: SceneModel::rest.
std::shared_ptr<const SceneModel> finish_model(LaidMesh laid, const StoredModel& how, std::uint64_t id,
                                               std::shared_ptr<const SceneModel> rest = {});

/// Lays a model and splits its triangles. Fails as both do.
Result<std::shared_ptr<const SceneModel>> build_model(const RawModel& raw, const StoredModel& how, std::uint64_t id);

/// Returns how many metres the unit of a model's file is, by the format that SceneModel::name says; none where the
/// format does not say it.
std::optional<double> metres_of(const std::string& name);

// A scene's model and fields on finer triangles.

struct SubdividedScene {
  std::shared_ptr<const SceneModel> model;  // null where no triangle was chosen
  FieldSet fields;
};

/// As Scene::subdivide says; `id` is that of the new model. At each level the mask chooses anew, as it is there.
Result<SubdividedScene> subdivide_scene(const SceneModel& model, const FieldSet& fields,
                                        const std::vector<EditLayer>& layers, const Subdivide& how, std::uint64_t id);

}  // namespace pelage
