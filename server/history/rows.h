// Helpers that several files of the journal share: settings, requests and picture references in rows.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/settings.h"
#include "server/history/history.h"
#include "server/history/sqlite.h"

namespace pelage {

Status damaged(const std::string& detail);

/// Binds settings, stored as the JSON of the commands that set them; NULL for none.
Statement& bind_settings(Statement& statement, const std::shared_ptr<const SceneSettings>& settings);
Result<std::shared_ptr<const SceneSettings>> settings_at(const Statement& row, int column);

/// Returns the first column of all rows.
Result<std::vector<std::string>> texts_of(Statement& rows);

/// Stores the change that a request made; of several changes the last one counts. Does nothing without a request.
Status write_request(Database& database, const std::optional<KeyedRequest>& request, const std::string& scene,
                     Revision revision, const FieldsHash& fields_hash = {});

/// Returns the chain value at a revision, from which the next entry continues.
Result<std::uint64_t> chain_at(Database& database, const std::string& scene, Revision revision);

/// Records that the scene's log names the picture.
Status add_picture_use(Database& database, const std::string& scene, const std::string& picture);
/// Removes the scene's references to pictures, and the pictures that only this scene's log named.
Status remove_picture_uses(Database& database, const std::string& scene);

}  // namespace pelage
