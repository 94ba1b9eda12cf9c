// Checksums of rows, so that a flipped bit, a lost row or a row of another scene is found when a scene is loaded.
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

/// Adds two functions to SQL: checksum(value, ...), 64 bits of the values with their types, and chained(before, value,
/// ...), which is next_chain of that checksum.
void add_checksum(sqlite3* database);

std::uint64_t checksum_of(std::string_view bytes);

/// The chain of the entry after one of chain `before`. The first entry follows the chain first_revision.
std::uint64_t next_chain(std::uint64_t before, std::uint64_t entry_checksum);

/// Fails (internal) unless the checksum of a scene's row fits: before a part of it is sealed anew.
Status check_seal(Database& database, std::string_view id);
/// Brings the checksum of a scene's row up to its other columns.
Status seal_scene(Database& database, std::string_view id);

}  // namespace pelage
