#include "server/history/foreign_rows.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "server/history/plain_rows.h"
#include "server/history/schema.h"
#include "server/history/schema_upgrades.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

// Version 8 was the first to export files; version 9 has the same tables.
constexpr std::uint64_t oldest_exported_version = 8;
constexpr const char* schema_of_version_8 = R"(
  CREATE TABLE scenes(
    number INTEGER PRIMARY KEY, id TEXT NOT NULL UNIQUE, name TEXT NOT NULL,
    model TEXT NOT NULL, up INTEGER NOT NULL, front INTEGER NOT NULL, source_is_32_bit INTEGER NOT NULL,
    first_revision INTEGER NOT NULL, first_groom BLOB NOT NULL, raw BLOB NOT NULL, fur_patches INTEGER NOT NULL,
    subdivisions BLOB NOT NULL, settings TEXT, creases_and_flips TEXT NOT NULL DEFAULT '');
  CREATE TABLE entries(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, revision INTEGER NOT NULL,
    kind INTEGER NOT NULL, argument INTEGER NOT NULL, commands TEXT NOT NULL, settings TEXT,
    hash_low INTEGER NOT NULL, hash_high INTEGER NOT NULL, delta BLOB NOT NULL, author TEXT NOT NULL DEFAULT '',
    request_key TEXT NOT NULL DEFAULT '', PRIMARY KEY(scene, revision));
  CREATE INDEX entries_by_request ON entries(scene, request_key) WHERE request_key <> '';
  CREATE TABLE pictures(name TEXT PRIMARY KEY, bytes BLOB NOT NULL);
  CREATE TABLE picture_uses(
    scene TEXT NOT NULL REFERENCES scenes(id) ON DELETE CASCADE, picture TEXT NOT NULL REFERENCES pictures(name),
    PRIMARY KEY(scene, picture));
)";

Result<std::uint64_t> version_of(Database& file) {
  Statement question = file.prepare("PRAGMA user_version");
  const Result<bool> row = question.step();
  if (!row) return row.status();
  return question.number_at(0);
}

Result<std::vector<std::string>> schema_texts(Database& database) {
  std::vector<std::string> texts;
  Statement rows =
      database.prepare("SELECT type || ' ' || name || ' ' || coalesce(sql, '') FROM sqlite_master ORDER BY 1");
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) texts.push_back(rows.text_at(0));
  if (!row) return row.status();
  return texts;
}

Status check_schema_of(Database& file, const char* tables) {
  Result<Database> own = Database::in_memory();
  if (!own) return own.status();
  if (Status made = own->execute(tables); !made.ok()) return made;
  const Result<std::vector<std::string>> wanted = schema_texts(*own), found = schema_texts(file);
  if (!wanted) return wanted.status();
  if (!found) return found.status();
  return *found == *wanted ? Status{} : failure(Code::invalid, "its tables are not those of a scene");
}

/// Refuses a damaged file. For example, pages that are used twice could expand a small file to many rows.
Status check_pages(Database& file) {
  Statement check = file.prepare("PRAGMA quick_check(1)");
  const Result<bool> row = check.step();
  if (!row) return row.status();
  return check.text_at(0) == "ok" ? Status{} : failure(Code::invalid, "it is damaged: " + check.text_at(0));
}

}  // namespace

Result<std::string> foreign_rows(std::string bytes) {
  Result<Database> file = Database::of_bytes(std::move(bytes));
  if (!file) return file.status();
  const Result<std::uint64_t> version = version_of(*file);
  if (!version) return version.status();
  if (*version > schema_version) return failure(Code::invalid, "it comes from a newer version of this program");
  if (*version < oldest_exported_version) return failure(Code::invalid, "no version of this program exported it");
  const char* tables = *version == schema_version ? schema : schema_of_version_8;
  if (Status same = check_schema_of(*file, tables); !same.ok()) return same;
  if (Status good = check_pages(*file); !good.ok()) return good;
  if (Status good = check_kinds(*file); !good.ok()) return good;
  const Status current = file->transaction([&] { return upgrade(*file, *version); });
  if (!current.ok()) return current;
  return rows_of(*file);
}

}  // namespace pelage
