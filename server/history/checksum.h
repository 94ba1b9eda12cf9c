// Checksums of rows, which detect a flipped bit, a lost row or a row of another scene when a scene is loaded.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/status.h"
#include "server/history/sqlite.h"

struct sqlite3;

namespace pelage {

/// The columns of a scene and of an entry that their checksums cover, in order.
constexpr const char* scene_columns =
    "name, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches, subdivisions, settings, "
    "creases_and_flips";
constexpr const char* entry_columns =
    "revision, kind, argument, commands, settings, hash_low, hash_high, delta, author";

/// Registers two SQL functions: checksum(value, ...), a 64-bit checksum of the values and their types, and
/// chained(before, value, ...), which is next_chain of `before` and that checksum.
void add_checksum(sqlite3* database);

std::uint64_t checksum_of(std::string_view bytes);

/// Returns the chain value of an entry whose predecessor has the chain value `before`. For the first entry of a scene
/// that is first_revision.
std::uint64_t next_chain(std::uint64_t before, std::uint64_t entry_checksum);

/// Fails (internal) if the checksum of a scene's row does not match. To be called before a part of the row is changed
/// and sealed again.
Status check_scene_checksum(Database& database, std::string_view id);
/// Updates the checksum of a scene's row from its other columns.
Status update_scene_checksum(Database& database, std::string_view id);

}  // namespace pelage
