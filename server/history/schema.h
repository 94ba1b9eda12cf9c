// The SQL schema of a journal, both for new journals and for comparison with an untrusted file.
#pragma once

#include <cstdint>

#include "base/status.h"

namespace pelage {

class Database;

// Version of the schema that this program writes, and the oldest that it upgrades.
constexpr std::uint64_t schema_version = 10;
constexpr std::uint64_t oldest_upgraded_version = 5;

/// The statements that create an empty journal of schema_version, as sqlite_master stores them. `checksum` covers the
/// other columns of a scene except its number and id; `chain` covers those of an entry and all earlier entries of the
/// scene (server/history/checksum.h). Pictures are compressed (compress_bytes). `requests` holds the requests with an
/// Idempotency-Key that changed something.
constexpr const char* schema = R"(
  CREATE TABLE scenes(
    number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
    model TEXT NOT NULL, up INTEGER NOT NULL, front INTEGER NOT NULL, source_is_32_bit INTEGER NOT NULL,
    first_revision INTEGER NOT NULL, first_groom BLOB NOT NULL, raw BLOB NOT NULL, fur_patches INTEGER NOT NULL,
    subdivisions BLOB NOT NULL, settings TEXT, creases_and_flips TEXT NOT NULL, checksum INTEGER NOT NULL);
  CREATE TABLE entries(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, revision INTEGER NOT NULL,
    kind INTEGER NOT NULL, argument INTEGER NOT NULL, chain INTEGER NOT NULL, commands TEXT NOT NULL, settings TEXT,
    hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL, delta BLOB NOT NULL, author TEXT NOT NULL,
    PRIMARY KEY(scene, revision));
  CREATE TABLE pictures(name TEXT PRIMARY KEY, bytes BLOB NOT NULL);
  CREATE TABLE picture_uses(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, picture TEXT NOT NULL REFERENCES pictures(name),
    PRIMARY KEY(scene, picture));
  CREATE TABLE requests(
    path TEXT NOT NULL, key TEXT NOT NULL, fingerprint TEXT NOT NULL,
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, revision INTEGER NOT NULL,
    hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL, PRIMARY KEY(path, key));
  CREATE INDEX requests_by_scene ON requests(scene);
)";

/// Creates the tables of a new journal, or upgrades an older one. Fails (internal) for a file that is not a journal or
/// has an unsupported version.
Status prepare_schema(Database& database);

}  // namespace pelage
