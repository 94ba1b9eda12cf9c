#include "server/history/schema.h"

#include <string>

#include "server/history/schema_upgrades.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

Status refuse_version(std::uint64_t version, std::uint64_t tables) {
  if (version > schema_version)
    return failure(Code::internal, "the journal comes from a newer version of this program");
  if (version == 0 && tables > 0) return failure(Code::internal, "the file in the journal's place is another database");
  if (version == 0 || version >= oldest_upgraded_version) return {};
  return failure(Code::internal,
                 "the journal comes from an older version, whose fields were stored in another way: start that "
                 "version, save the logs of its scenes, and run them on this one with another data folder");
}

}  // namespace

Status prepare_schema(Database& database) {
  const Result<std::uint64_t> version = database.number("PRAGMA user_version");
  if (!version) return version.status();
  const Result<std::uint64_t> tables = database.number("SELECT count(*) FROM sqlite_master");
  if (!tables) return tables.status();
  if (Status refused = refuse_version(*version, *tables); !refused.ok()) return refused;
  if (*version == schema_version) return {};
  return database.transaction([&] {
    Status made = *version == 0 ? database.execute(schema) : upgrade(database, *version);
    if (!made.ok()) return made;
    return database.execute(("PRAGMA user_version = " + std::to_string(schema_version)).c_str());
  });
}

}  // namespace pelage
