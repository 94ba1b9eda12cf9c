// Models of files, as a scene takes them.
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

/// An import that ends once nobody waits for it.
ImportLimits ended_by(const Cancel& cancel);

/// A new version of a file stands as the one before does, unless other axes are asked for.
ImportOptions standing_as(const SceneModel& before, ImportOptions asked);

struct ImportedModel {
  std::shared_ptr<const SceneModel> model;
  StoredModel stored;
};

/// Reads a model by the program `worker` and prepares it; `id` is the one that it gets. Refused (invalid) as
/// import_model and build_model refuse. Throws Cancelled.
Result<ImportedModel> import_for_scene(const std::string& worker, std::uint64_t id, const ImportOptions& options,
                                       std::span<const std::byte> bytes, const Cancel& cancel,
                                       std::vector<ChosenTriangles> subdivisions = {});

}  // namespace pelage
