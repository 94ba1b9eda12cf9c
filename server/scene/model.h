// From a parsed model to one that a scene can hold.
#pragma once

#include <cstdint>
#include <memory>

#include "protocol/base/status.h"
#include "protocol/commands/scene.h"
#include "server/history/journal.h"
#include "server/scene/scene.h"

namespace pelage {

/// Prepares a model as `how` says (its bytes are not looked at), lays its patches and subdivides it. Fails as prepare
/// and subdivide do, and (invalid, "/fur_patches") where the model has no texture coordinates to lay them by.
Result<std::shared_ptr<const SceneModel>> build_model(const RawModel& raw, const StoredModel& how, std::uint64_t id);

}  // namespace pelage
