// Upgrades of older journals to the current schema.
#pragma once

#include <cstdint>

#include "base/status.h"

namespace pelage {

class Database;

/// Upgrades a journal's tables and rows from `version` (oldest_upgraded_version to schema_version) to schema_version,
/// inside the caller's transaction.
Status upgrade(Database& database, std::uint64_t version);

}  // namespace pelage
