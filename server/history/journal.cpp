#include "server/history/journal.h"

#include <algorithm>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "server/history/codec.h"
#include "server/history/schema_upgrades.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

// Full synchronisation: a commit that has returned is on disk. The exclusive lock keeps a second server out.
constexpr const char* how_to_keep = R"(
  PRAGMA locking_mode = EXCLUSIVE;
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  PRAGMA foreign_keys = ON;
  BEGIN IMMEDIATE; COMMIT;
)";

constexpr const char* schema = R"(
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
  PRAGMA user_version = 8;
)";

// What no log names any more; at the start also what was uploaded and never used.
constexpr const char* drop_unused_pictures =
    "DELETE FROM pictures WHERE name NOT IN (SELECT picture FROM picture_uses)";

Status damaged(const char* what) { return failure(Code::internal, std::string("the journal is damaged: ") + what); }

Result<std::uint64_t> number_of(Database& database, const char* question) {
  Statement statement = database.prepare(question);
  const Result<bool> row = statement.step();
  if (!row) return row.status();
  return statement.number_at(0);
}

/// Makes the tables of a new journal, and refuses what is none or of another version.
Status check_schema(Database& database) {
  const Result<std::uint64_t> version = number_of(database, "PRAGMA user_version");
  if (!version) return version.status();
  const Result<std::uint64_t> tables = number_of(database, "SELECT count(*) FROM sqlite_master");
  if (!tables) return tables.status();
  if (*version > schema_version)
    return failure(Code::internal, "the journal comes from a newer version of this program");
  if (*version == 0 && *tables > 0)
    return failure(Code::internal, "the file in the journal's place is another database");
  if (*version > 0 && *version < oldest_upgraded_version) {
    return failure(Code::internal,
                   "the journal comes from an older version, whose fields were stored in another way: start that "
                   "version, save the logs of its scenes, and run them on this one with another data folder");
  }
  return database.transaction([&] {
    if (*version == 0) return database.execute(schema);
    Status current = upgrade(database, *version);
    return current.ok() ? database.execute(drop_unused_pictures) : current;
  });
}

std::string settings_text(const SceneSettings& settings) { return encode(commands_of(settings)); }

Result<std::shared_ptr<const SceneSettings>> settings_from(const std::string& text) {
  const Result<std::vector<Command>> commands = decode_commands(text);
  if (!commands) return damaged("settings");
  SceneSettings settings;
  for (const Command& command : *commands) settings = with_setting(settings, command).value_or(settings);
  return std::make_shared<const SceneSettings>(std::move(settings));
}

Statement& bind_settings(Statement& statement, const std::shared_ptr<const SceneSettings>& settings) {
  return settings ? statement.text(settings_text(*settings)) : statement.null();
}

/// Binds all that a new model changes about a scene, and its id last.
Status run_with_model(Statement statement, const StoredScene& scene, const std::string& first_groom) {
  const std::string subdivisions = encode_subdivisions(scene.model.subdivisions);
  statement.text(scene.model.name)
      .number(static_cast<std::uint64_t>(scene.model.prepare.up))
      .number(static_cast<std::uint64_t>(scene.model.prepare.front))
      .number(scene.model.prepare.source_is_32_bit)
      .number(scene.first_revision)
      .blob(first_groom)
      .blob(scene.model.raw)
      .number(static_cast<std::uint64_t>(scene.model.fur_patches))
      .blob(subdivisions)
      .text(encode_creases_and_flips(scene.model.prepare));
  return bind_settings(statement, scene.first_settings).text(scene.id).run();
}

/// The scene's log no longer names pictures; those that only it named go.
Status leave_pictures(Database& database, const std::string& scene) {
  constexpr const char* only_here =
      "SELECT picture FROM picture_uses GROUP BY picture HAVING min(scene) = ?1 AND max(scene) = ?1";
  std::vector<std::string> names;
  Statement rows = database.prepare(only_here);
  rows.text(scene);
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) names.push_back(rows.text_at(0));
  if (!row) return row.status();
  Status left = database.prepare("DELETE FROM picture_uses WHERE scene = ?").text(scene).run();
  for (std::size_t i = 0; left.ok() && i < names.size(); ++i) {
    left = database.prepare("DELETE FROM pictures WHERE name = ?").text(names[i]).run();
  }
  return left;
}

/// The scene's log names the picture from now on.
Status keep_picture(Database& database, const std::string& scene, const std::string& picture) {
  Statement use = database.prepare("INSERT OR IGNORE INTO picture_uses VALUES(?,?)");
  return use.text(scene).text(picture).run();
}

Status write_entry(Database& database, const std::string& scene, const Entry& entry, const std::string& delta) {
  if (entry.settings && !entry.settings->skin_texture.empty()) {
    if (Status kept = keep_picture(database, scene, entry.settings->skin_texture); !kept.ok()) return kept;
  }
  for (const std::string& picture : entry.pictures) {
    if (Status kept = keep_picture(database, scene, picture); !kept.ok()) return kept;
  }
  Statement insert = database.prepare("INSERT INTO entries VALUES(?,?,?,?,?,?,?,?,?,?,?)");
  insert.text(scene).number(entry.revision).number(static_cast<std::uint64_t>(entry.kind)).number(entry.argument);
  insert.text(entry.commands);
  if (entry.settings)
    insert.text(settings_text(*entry.settings));
  else
    insert.null();
  insert.number(entry.fields_hash.low).number(entry.fields_hash.high).blob(delta);
  return insert.text(entry.author).text(entry.request_key).run();
}

Result<Entry> read_entry(const Statement& row) {
  Entry entry;
  entry.revision = row.number_at(0);
  const std::uint64_t kind = row.number_at(1);
  if (kind > static_cast<std::uint64_t>(EntryKind::replay)) return damaged("kind of an entry");
  entry.kind = static_cast<EntryKind>(kind);
  entry.argument = row.number_at(2);
  entry.commands = row.text_at(3);
  if (!row.null_at(4)) {
    auto settings = settings_from(row.text_at(4));
    if (!settings) return settings.status();
    entry.settings = *settings;
  }
  entry.fields_hash = {row.number_at(5), row.number_at(6)};
  Result<FieldDelta> delta = decode_delta(row.blob_at(7));
  if (!delta) return delta.status();
  entry.delta = std::move(*delta);
  entry.author = row.text_at(8);
  return entry;
}

}  // namespace

Journal::Journal(std::unique_ptr<Database> database) : database_(std::move(database)) {}
Journal::~Journal() = default;

Result<std::unique_ptr<Journal>> Journal::open(const std::string& path) {
  Result<Database> database = Database::open(path);
  if (!database) return database.status();
  if (Status kept = database->execute(how_to_keep); !kept.ok()) return kept;
  if (Status good = check_schema(*database); !good.ok()) return good;
  return std::unique_ptr<Journal>(new Journal(std::make_unique<Database>(std::move(*database))));
}

Status Journal::add_scene(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(mutex_);
  Statement insert = database_->prepare(
      "INSERT INTO scenes(name, model, up, front, source_is_32_bit, first_revision,"
      " first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings, id)"
      " VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.text(scene.name);
  return run_with_model(std::move(insert), scene, first_groom);
}

Status Journal::replace_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(mutex_);
  return database_->transaction([&] {
    Status cleared = database_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!cleared.ok()) return cleared;
    if (Status unused = leave_pictures(*database_, scene.id); !unused.ok()) return unused;
    return run_with_model(database_->prepare("UPDATE scenes SET model = ?, up = ?, front = ?, source_is_32_bit = ?,"
                                             " first_revision = ?, first_groom = ?, raw = ?, fur_patches = ?,"
                                             " subdivisions = ?, creases_and_flips = ?, settings = ? WHERE id = ?"),
                          scene, first_groom);
  });
}

Status Journal::subdivide_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::string subdivisions = encode_subdivisions(scene.model.subdivisions);
  const std::lock_guard lock(mutex_);
  return database_->transaction([&] {
    Status changed = database_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!changed.ok()) return changed;
    Statement update = database_->prepare(
        "UPDATE scenes SET first_revision = ?, first_groom = ?, subdivisions = ?, settings = ? WHERE id = ?");
    update.number(scene.first_revision).blob(first_groom).blob(subdivisions);
    return bind_settings(update, scene.first_settings).text(scene.id).run();
  });
}

Status Journal::remove_scene(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return database_->transaction([&] {
    if (Status unused = leave_pictures(*database_, id); !unused.ok()) return unused;
    return database_->prepare("DELETE FROM scenes WHERE id = ?").text(id).run();
  });
}

Status Journal::append(const std::string& scene, std::span<const Entry> entries) {
  std::vector<std::string> deltas;
  for (const Entry& entry : entries) deltas.push_back(encode_delta(entry.delta));
  const std::lock_guard lock(mutex_);
  return database_->transaction([&] {
    Status written;
    for (std::size_t i = 0; written.ok() && i < entries.size(); ++i)
      written = write_entry(*database_, scene, entries[i], deltas[i]);
    return written;
  });
}

// The branch keeps all pictures of the scene, also those that only later entries name.
Status Journal::branch(const std::string& scene, const std::string& branch, const std::string& name, Revision last) {
  const std::lock_guard lock(mutex_);
  return database_->transaction([&] {
    Statement row = database_->prepare(
        "INSERT INTO scenes(id, name, model, up, front, source_is_32_bit,"
        " first_revision, first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings)"
        " SELECT ?, ?, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches, subdivisions,"
        " creases_and_flips, settings"
        " FROM scenes WHERE id = ?");
    if (Status added = row.text(branch).text(name).text(scene).run(); !added.ok()) return added;
    Statement entries = database_->prepare(
        "INSERT INTO entries SELECT ?, revision, kind, argument, commands, settings, hash_low, hash_high, delta,"
        " author, '' FROM entries WHERE scene = ? AND revision <= ?");
    if (Status copied = entries.text(branch).text(scene).number(last).run(); !copied.ok()) return copied;
    return database_->prepare("INSERT INTO picture_uses SELECT ?, picture FROM picture_uses WHERE scene = ?")
        .text(branch)
        .text(scene)
        .run();
  });
}

Status Journal::use_picture(const std::string& scene, const std::string& picture) {
  const std::lock_guard lock(mutex_);
  return keep_picture(*database_, scene, picture);
}

Status Journal::copy_into(const StoredScene& stored, const std::string& scene, Journal& to) const {
  const Result<std::vector<std::string>> pictures = pictures_of(scene);
  if (!pictures) return pictures.status();
  for (const std::string& name : *pictures) {
    const Result<std::string> bytes = picture(name);
    if (!bytes) return bytes.status();
    if (Status added = to.add_picture(name, *bytes); !added.ok()) return added;
    if (Status used = to.use_picture(stored.id, name); !used.ok()) return used;
  }
  return for_each_entry(scene, 0, [&](const Entry& entry) { return to.append(stored.id, entry); });
}

Status Journal::copy_scene(const std::string& scene, Journal& to, const std::string& copy,
                           const std::string& name) const {
  Result<StoredScene> stored = this->scene(scene);
  if (!stored) return stored.status();
  stored->id = copy, stored->name = name;
  if (Status added = to.add_scene(*stored); !added.ok()) return added;
  Status copied = copy_into(*stored, scene, to);
  if (!copied.ok()) static_cast<void>(to.remove_scene(copy));  // the copy's failure is the one to tell
  return copied;
}

Status Journal::add_picture(const std::string& name, const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  return database_->prepare("INSERT OR IGNORE INTO pictures VALUES(?,?)").text(name).blob(bytes).run();
}

bool Journal::has_picture(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const Result<bool> found = database_->prepare("SELECT 1 FROM pictures WHERE name = ?").text(name).step();
  return found && *found;
}

Result<std::string> Journal::picture(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  Statement row = database_->prepare("SELECT bytes FROM pictures WHERE name = ?");
  const Result<bool> found = row.text(name).step();
  if (!found) return found.status();
  if (!*found) return damaged("a picture is missing");
  const std::span<const std::byte> bytes = row.blob_at(0);
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

namespace {

Result<std::vector<std::string>> texts_of(Statement& rows) {
  std::vector<std::string> texts;
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) texts.push_back(rows.text_at(0));
  if (!row) return row.status();
  return texts;
}

}  // namespace

Result<std::vector<std::string>> Journal::pictures_of(const std::string& scene) const {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare("SELECT picture FROM picture_uses WHERE scene = ? ORDER BY picture");
  return texts_of(rows.text(scene));
}

Result<std::vector<std::string>> Journal::scene_ids() const {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare("SELECT id FROM scenes ORDER BY number");
  return texts_of(rows);
}

Result<StoredScene> Journal::scene(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  Statement row = database_->prepare(
      "SELECT name, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches,"
      " subdivisions, settings, creases_and_flips FROM scenes WHERE id = ?");
  const Result<bool> found = row.text(id).step();
  if (!found) return found.status();
  if (!*found) return failure(Code::not_found, "the journal has no such scene");
  constexpr auto last_axis = static_cast<std::uint64_t>(Axis::minus_z);
  if (row.number_at(2) > last_axis || row.number_at(3) > last_axis) return damaged("axes of a model");
  if (row.number_at(8) > static_cast<std::uint64_t>(FurPatches::own_uvs)) return damaged("patches of a model");
  Result<FieldDelta> first_groom = decode_delta(row.blob_at(6));
  if (!first_groom) return first_groom.status();
  Result<std::vector<ChosenTriangles>> subdivisions = decode_subdivisions(row.blob_at(9));
  if (!subdivisions) return subdivisions.status();
  std::shared_ptr<const SceneSettings> settings;
  if (!row.null_at(10)) {
    auto stored = settings_from(row.text_at(10));
    if (!stored) return stored.status();
    settings = *stored;
  }
  const std::span<const std::byte> raw = row.blob_at(7);
  PrepareOptions prepare{static_cast<Axis>(row.number_at(2)), static_cast<Axis>(row.number_at(3)),
                         row.number_at(4) != 0};
  if (!decode_creases_and_flips(row.text_at(11), prepare)) return damaged("creases and flips of a model");
  StoredModel model{row.text_at(1), std::move(prepare),
                    std::string(reinterpret_cast<const char*>(raw.data()), raw.size()),
                    static_cast<FurPatches>(row.number_at(8)), std::move(*subdivisions)};
  return StoredScene{
      id, row.text_at(0), std::move(model), row.number_at(5), std::move(*first_groom), std::move(settings)};
}

Status Journal::for_each_entry(const std::string& scene, Revision after,
                               const std::function<Status(const Entry&)>& use) const {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare(
      "SELECT revision, kind, argument, commands, settings, hash_low, hash_high, delta, author"
      " FROM entries WHERE scene = ? AND revision > ? ORDER BY revision");
  rows.text(scene).number(after);
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) {
    const Result<Entry> entry = read_entry(rows);
    if (!entry) return entry.status();
    if (Status used = use(*entry); !used.ok()) return used;
  }
  return row ? Status{} : row.status();
}

Result<std::optional<RequestedChange>> Journal::change_of_request(const std::string& scene,
                                                                  const std::string& key) const {
  if (key.empty()) return std::optional<RequestedChange>();
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare(
      "SELECT revision, hash_low, hash_high FROM entries WHERE scene = ? AND request_key = ? AND request_key <> ''"
      " ORDER BY revision DESC LIMIT 1");
  const Result<bool> row = rows.text(scene).text(key).step();
  if (!row) return row.status();
  if (!*row) return std::optional<RequestedChange>();
  return std::optional(RequestedChange{rows.number_at(0), {rows.number_at(1), rows.number_at(2)}});
}

Result<std::vector<Entry>> Journal::entries(const std::string& scene, Revision after) const {
  std::vector<Entry> entries;
  Status read = for_each_entry(scene, after, [&](const Entry& entry) { return entries.push_back(entry), Status{}; });
  return read.ok() ? Result<std::vector<Entry>>(std::move(entries)) : read;
}

Status Journal::for_each_change(const std::string& scene, Revision after, Revision last,
                                const std::function<void(const FieldDelta&)>& use) const {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare(
      "SELECT delta FROM entries WHERE scene = ? AND revision > ? AND revision <= ? ORDER BY revision");
  rows.text(scene).number(after).number(last);
  Revision read = after;
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step(), ++read) {
    const Result<FieldDelta> delta = decode_delta(rows.blob_at(0));
    if (!delta) return delta.status();
    use(*delta);
  }
  if (!row) return row.status();
  return read == last ? Status{} : damaged("an entry is missing");
}

Result<FieldDelta> Journal::change(const std::string& scene, Revision after, Revision last) const {
  FieldDelta total;
  Status read = for_each_change(scene, after, last, [&](const FieldDelta& delta) { total = compose(total, delta); });
  return read.ok() ? Result<FieldDelta>(std::move(total)) : read;
}

}  // namespace pelage
