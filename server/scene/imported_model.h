// Imports model files for a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/scene.h"
#include "server/groom/cancel.h"
#include "server/history/journal.h"
#include "server/import/import.h"
#include "server/scene/model.h"

namespace pelage {

/// Returns import limits that end the import if it is cancelled.
ImportLimits cancellable_limits(const Cancel& cancel);

/// Returns import options with the up and front axes of the model before, unless the caller asked for other axes or
/// that model did not come from a file.
ImportOptions with_axes_of(const SceneModel& before, ImportOptions asked);

struct ImportedModel {
  std::shared_ptr<const SceneModel> model;
  StoredModel stored;
};

/// Reads a model with the program `worker` and prepares it; `id` is the new model's. Refuses (invalid) what
/// import_model and build_model refuse. Throws Cancelled.
Result<ImportedModel> import_for_scene(const std::string& worker, std::uint64_t id, const ImportOptions& options,
                                       std::span<const std::byte> bytes, const Cancel& cancel,
                                       std::vector<ChosenTriangles> subdivisions = {});

}  // namespace pelage
