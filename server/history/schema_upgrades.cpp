#include "server/history/schema_upgrades.h"

#include <functional>
#include <iterator>
#include <string>

#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/schema.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

struct Renamed {
  const char* before;
  const char* now;
};

// JSON names before 1.0 of the contract, as found in logged commands.
constexpr Renamed names_of_version_6[] = {{R"("op":"layer")", R"("op":"edit_layer")"},
                                          {R"("layer":)", R"("edit_layer":)"},
                                          {R"("op":"set_base_picture")", R"("op":"set_skin_texture")"},
                                          {R"("odd_hairs":)", R"("ticking":)"},
                                          {R"("mode":"least")", R"("mode":"min")"},
                                          {R"("mode":"most")", R"("mode":"max")"}};

/// Renames a JSON key or value in logged commands. They are compact JSON, in which quotes inside a user's text are
/// escaped, so that only names match.
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
  return current;
}

/// Adds authors; changes made before version 7 have none.
Status to_version_7(Database& database) {
  return database.execute(
      "ALTER TABLE entries ADD COLUMN author TEXT NOT NULL DEFAULT '';"
      "ALTER TABLE entries ADD COLUMN request_key TEXT NOT NULL DEFAULT '';"
      "CREATE INDEX entries_by_request ON entries(scene, request_key) WHERE request_key <> ''");
}

/// Adds creases and flipped parts. Before version 8 all creases had the default angle, and no part was flipped.
Status to_version_8(Database& database) {
  return database.execute("ALTER TABLE scenes ADD COLUMN creases_and_flips TEXT NOT NULL DEFAULT ''");
}

/// Version 9 added stiffness and wind, which change nothing in stored rows. New journals of that version also stored 8
/// as their version.
Status to_version_9(Database&) { return {}; }

// Version 10 added checksums of rows, compression of pictures, and fingerprints of requests. Older request keys are
// dropped, because their requests are unknown. The tables are created anew, so that the text of a schema is the same
// whichever version made the journal.
constexpr const char* put_aside =
    "ALTER TABLE picture_uses RENAME TO old_picture_uses; ALTER TABLE pictures RENAME TO old_pictures;"
    "DROP INDEX entries_by_request; ALTER TABLE entries RENAME TO old_entries; ALTER TABLE scenes RENAME TO old_scenes";
/// Calls `use` with each row of a query.
Status for_each_row(Database& database, const std::string& question,
                    const std::function<Status(const Statement&)>& use) {
  Statement rows = database.prepare(question.c_str());
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) {
    if (Status used = use(rows); !used.ok()) return used;
  }
  return row ? Status{} : row.status();
}

Status compress_pictures(Database& database) {
  return for_each_row(database, "SELECT name, bytes FROM old_pictures", [&](const Statement& row) {
    const std::string bytes = compress_bytes(row.bytes_at(1));
    return database.prepare("INSERT INTO pictures VALUES(?,?)").text(row.text_at(0)).blob(bytes).run();
  });
}

Status take_scenes(Database& database) {
  const std::string columns = std::string("id, ") + scene_columns;
  const std::string insert = "INSERT INTO scenes(number, " + columns + ", checksum) SELECT number, " + columns +
                             ", checksum(" + scene_columns + ") FROM old_scenes";
  return database.execute(insert.c_str());
}

Status take_entries(Database& database) {
  const std::string columns = std::string("scene, ") + entry_columns;
  const std::string insert = "INSERT INTO entries(" + columns + ", chain) SELECT " + columns +
                             ", ? FROM old_entries WHERE scene = ? AND revision = ?";
  const std::string question =
      std::string("SELECT scene, revision, checksum(") + entry_columns +
      "), (SELECT first_revision FROM old_scenes WHERE id = scene) FROM old_entries ORDER BY scene, revision";
  std::string scene;
  std::uint64_t chain = 0;
  return for_each_row(database, question, [&](const Statement& row) {
    if (row.text_at(0) != scene) scene = row.text_at(0), chain = row.number_at(3);
    chain = next_chain(chain, row.number_at(2));
    return database.prepare(insert.c_str()).number(chain).text(scene).number(row.number_at(1)).run();
  });
}

Status take_picture_uses(Database& database) {
  return database.execute(
      "INSERT INTO picture_uses SELECT scene, picture FROM old_picture_uses;"
      "DROP TABLE old_picture_uses; DROP TABLE old_pictures; DROP TABLE old_entries; DROP TABLE old_scenes");
}

Status to_version_10(Database& database) {
  Status current = database.execute(put_aside);
  if (current.ok()) current = database.execute(schema);
  for (const auto& take : {take_scenes, take_entries, compress_pictures, take_picture_uses})
    if (current.ok()) current = take(database);
  return current;
}

// The upgrades from each version to the next, starting at oldest_upgraded_version.
constexpr Status (*steps[])(Database&) = {to_version_6, to_version_7, to_version_8, to_version_9, to_version_10};
static_assert(oldest_upgraded_version + std::size(steps) == schema_version);

}  // namespace

Status upgrade(Database& database, std::uint64_t version) {
  Status current;
  for (std::uint64_t from = version; from < schema_version && current.ok(); ++from)
    current = steps[from - oldest_upgraded_version](database);
  return current;
}

}  // namespace pelage
