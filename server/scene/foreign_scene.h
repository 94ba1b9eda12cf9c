// A scene that a stranger's file brings, before it becomes one of the server's.
#pragma once

#include "base/status.h"
#include "server/history/journal.h"
#include "server/scene/model.h"

namespace pelage {

/// Refused (invalid), saying which entry, unless the scene is one that commands could have made: pictures are what
/// their names say; each entry follows those before it and its commands are within their limits on this model; fields
/// stay in their ranges at each revision, and have the hash that the entry says. `model` is built of `stored`.
Status check_foreign(const Journal& file, const StoredScene& stored, const SceneModel& model);

}  // namespace pelage
