#include "server/history/schema_upgrades.h"

#include <iterator>
#include <string>

#include "server/history/sqlite.h"

namespace pelage {

namespace {

struct Renamed {
  const char* before;
  const char* now;
};

// Names of the contract before 1.0, as logged commands hold them.
constexpr Renamed names_of_version_6[] = {{R"("op":"layer")", R"("op":"edit_layer")"},
                                          {R"("layer":)", R"("edit_layer":)"},
                                          {R"("op":"set_base_picture")", R"("op":"set_skin_texture")"},
                                          {R"("odd_hairs":)", R"("ticking":)"},
                                          {R"("mode":"least")", R"("mode":"min")"},
                                          {R"("mode":"most")", R"("mode":"max")"}};

/// Logged commands are compact JSON: inside a user's text a quote has a backslash before it, so that only names match.
Status rename_in_commands(Database& database, const Renamed& name) {
  const std::string replaced = std::string(", '") + name.before + "', '" + name.now + "')";
  const std::string statements = "UPDATE entries SET commands = replace(commands" + replaced +
                                 ", settings = replace(settings" + replaced +
                                 "; UPDATE scenes SET settings = replace(settings" + replaced;
  return database.execute(statements.c_str());
}

Status to_version_6(Database& database) {
  Status current;
  for (const Renamed& name : names_of_version_6)
    if (current.ok()) current = rename_in_commands(database, name);
  return current.ok() ? database.execute("PRAGMA user_version = 6") : current;
}

/// Before it nobody was named, and no change knew its request.
Status to_version_7(Database& database) {
  return database.execute(
      "ALTER TABLE entries ADD COLUMN author TEXT NOT NULL DEFAULT '';"
      "ALTER TABLE entries ADD COLUMN request_key TEXT NOT NULL DEFAULT '';"
      "CREATE INDEX entries_by_request ON entries(scene, request_key) WHERE request_key <> '';"
      "PRAGMA user_version = 7");
}

/// Before it all creases were the default's, and no part was turned.
Status to_version_8(Database& database) {
  return database.execute(
      "ALTER TABLE scenes ADD COLUMN creases_and_flips TEXT NOT NULL DEFAULT '';"
      "PRAGMA user_version = 8");
}

/// Before it fur had no stiffness and no wind: nothing stored changes, but older programs cannot read what is now.
Status to_version_9(Database& database) { return database.execute("PRAGMA user_version = 9"); }

// The step from each version to the next, from oldest_upgraded_version on.
constexpr Status (*steps[])(Database&) = {to_version_6, to_version_7, to_version_8, to_version_9};
static_assert(oldest_upgraded_version + std::size(steps) == schema_version);

}  // namespace

Status upgrade(Database& database, std::uint64_t version) {
  Status current;
  for (std::uint64_t from = version; from < schema_version && current.ok(); ++from)
    current = steps[from - oldest_upgraded_version](database);
  return current;
}

}  // namespace pelage
