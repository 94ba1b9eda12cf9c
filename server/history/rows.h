// What the journal's rows hold beside numbers and texts, and what several of its files read and write alike.
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

Status damaged(const std::string& what);

/// Settings as the commands that set them; NULL for none.
Statement& bind_settings(Statement& statement, const std::shared_ptr<const SceneSettings>& settings);
Result<std::shared_ptr<const SceneSettings>> settings_at(const Statement& row, int column);

/// The first column of all rows.
Result<std::vector<std::string>> texts_of(Statement& rows);

/// Records what a request made of a scene; if it made several changes, the last one is its answer. Does nothing if
/// there is no request.
Status write_request(Database& database, const std::optional<KeyedRequest>& request, const std::string& scene,
                     Revision revision, const FieldsHash& fields_hash = {});

/// The chain value that the entry after a revision continues from.
Result<std::uint64_t> chain_at(Database& database, const std::string& scene, Revision revision);

/// The scene's log names the picture from now on.
Status keep_picture(Database& database, const std::string& scene, const std::string& picture);
/// Removes the scene's references to pictures, and the pictures that only this scene's log named.
Status leave_pictures(Database& database, const std::string& scene);

}  // namespace pelage
