#pragma once

#include <cstdint>

#include "protocol/base/status.h"

namespace pelage {

class Database;

// Version of the store's schema that this program writes, and the oldest that it upgrades.
constexpr std::uint64_t schema_version = 9;
constexpr std::uint64_t oldest_upgraded_version = 5;

/// Brings a store's tables and logged commands from `version` (oldest_upgraded_version to schema_version) to
/// schema_version, inside the caller's transaction.
Status upgrade(Database& database, std::uint64_t version);

}  // namespace pelage
