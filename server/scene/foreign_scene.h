// Validates a scene from an untrusted file before the server takes it over.
#pragma once

#include "base/status.h"
#include "server/history/journal.h"
#include "server/scene/model.h"

namespace pelage {

/// Refuses (invalid, naming the entry) a scene that commands could not have made. It checks that each picture has the
/// name that its content gives it; that each entry follows the one before it, and its commands are within their limits
/// on this model; that at each revision the fields are in range and have the hash that the entry states. `model` is
/// built from `stored`.
Status check_foreign(const Journal& file, const StoredScene& stored, const SceneModel& model);

}  // namespace pelage
