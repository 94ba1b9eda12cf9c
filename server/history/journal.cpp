#include "server/history/journal.h"

#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/plain_rows.h"
#include "server/history/rows.h"
#include "server/history/schema.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

// Full synchronisation: a commit that has returned is on disk. The exclusive lock keeps a second server out.
constexpr const char* pragmas = R"(
  PRAGMA auto_vacuum = INCREMENTAL;
  PRAGMA locking_mode = EXCLUSIVE;
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  PRAGMA foreign_keys = ON;
  BEGIN IMMEDIATE; COMMIT;
)";

// What no log names any more; at the start also what was uploaded and never used.
constexpr const char* drop_unused_pictures =
    "DELETE FROM pictures WHERE name NOT IN (SELECT picture FROM picture_uses)";

/// Binds all that a new model changes about a scene, and its id last.
Status run_with_model(Database& database, Statement statement, const StoredScene& scene,
                      const std::string& first_groom) {
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
  Status written = bind_settings(statement, scene.first_settings).text(scene.id).run();
  return written.ok() ? seal_scene(database, scene.id) : written;
}

}  // namespace

Journal::Journal(std::unique_ptr<Database> database) : database_(std::move(database)) {}
Journal::~Journal() = default;

Result<std::unique_ptr<Journal>> Journal::open(const std::string& path) {
  Result<Database> database = Database::open(path);
  if (!database) return database.status();
  if (Status kept = database->execute(pragmas); !kept.ok()) return kept;
  if (Status good = prepare_schema(*database); !good.ok()) return good;
  if (Status dropped = database->execute(drop_unused_pictures); !dropped.ok()) return dropped;
  std::unique_ptr<Journal> journal(new Journal(std::make_unique<Database>(std::move(*database))));
  if (Status read = journal->read_tails(); !read.ok()) return read;
  return journal;
}

Status Journal::read_tails() {
  Statement rows = database_->prepare(
      "SELECT s.id, coalesce(e.revision, s.first_revision), coalesce(e.chain, s.first_revision) FROM scenes s"
      " LEFT JOIN entries e ON e.scene = s.id"
      " AND e.revision = (SELECT max(revision) FROM entries WHERE scene = s.id)");
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) tails_[rows.text_at(0)] = {rows.number_at(1), rows.number_at(2)};
  return row ? Status{} : row.status();
}

Status Journal::change(const std::string& scene, const std::function<Status(LogTail&)>& work) {
  const auto known = tails_.find(scene);
  LogTail tail = known == tails_.end() ? LogTail{} : known->second;
  Status done = database_->transaction([&] { return work(tail); });
  if (done.ok()) tails_[scene] = tail;
  return done;
}

Result<std::unique_ptr<Journal>> Journal::of_rows(const std::string& path,
                                                  const std::function<Status(const TakeRows&)>& feed) {
  Result<std::unique_ptr<Journal>> journal = open(path);
  if (!journal) return journal;
  Database& database = *(*journal)->database_;
  Status filled = database.transaction([&] {
    Result<RowLoader> loader = RowLoader::into(database);
    if (!loader) return loader.status();
    Status fed = feed([&](std::string_view bytes) { return loader->take(bytes); });
    return fed.ok() ? loader->finish() : fed;
  });
  if (filled.ok()) filled = (*journal)->read_tails();
  return filled.ok() ? std::move(journal) : Result<std::unique_ptr<Journal>>(filled);
}

Status Journal::add_scene(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(mutex_);
  return change(scene.id, [&](LogTail& tail) { return insert_scene(scene, first_groom, tail); });
}

Status Journal::insert_scene(const StoredScene& scene, const std::string& first_groom, LogTail& tail) {
  tail = {scene.first_revision, scene.first_revision};
  Statement insert = database_->prepare(
      "INSERT INTO scenes(name, model, up, front, source_is_32_bit, first_revision,"
      " first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings, id, checksum)"
      " VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,0)");
  insert.text(scene.name);
  return run_with_model(*database_, std::move(insert), scene, first_groom);
}

Status Journal::replace_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(mutex_);
  return change(scene.id, [&](LogTail& tail) {
    tail = {scene.first_revision, scene.first_revision};
    Status cleared = database_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!cleared.ok()) return cleared;
    if (Status unused = leave_pictures(*database_, scene.id); !unused.ok()) return unused;
    Statement update = database_->prepare(
        "UPDATE scenes SET model = ?, up = ?, front = ?, source_is_32_bit = ?, first_revision = ?, first_groom = ?,"
        " raw = ?, fur_patches = ?, subdivisions = ?, creases_and_flips = ?, settings = ? WHERE id = ?");
    return run_with_model(*database_, std::move(update), scene, first_groom);
  });
}

Status Journal::subdivide_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::string subdivisions = encode_subdivisions(scene.model.subdivisions);
  const std::lock_guard lock(mutex_);
  return change(scene.id, [&](LogTail& tail) {
    tail = {scene.first_revision, scene.first_revision};
    Status changed = database_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!changed.ok()) return changed;
    Statement update = database_->prepare(
        "UPDATE scenes SET first_revision = ?, first_groom = ?, subdivisions = ?, settings = ? WHERE id = ?");
    update.number(scene.first_revision).blob(first_groom).blob(subdivisions);
    changed = bind_settings(update, scene.first_settings).text(scene.id).run();
    return changed.ok() ? seal_scene(*database_, scene.id) : changed;
  });
}

Status Journal::remove_scene(const std::string& id) {
  const std::lock_guard lock(mutex_);
  Status removed = database_->transaction([&] {
    if (Status unused = leave_pictures(*database_, id); !unused.ok()) return unused;
    return database_->prepare("DELETE FROM scenes WHERE id = ?").text(id).run();
  });
  if (removed.ok()) tails_.erase(id);
  return removed;
}

// The branch keeps all pictures of the scene, also those that only later entries name.
Status Journal::branch(const std::string& scene, const std::string& branch, const std::string& name, Revision last) {
  const std::lock_guard lock(mutex_);
  return change(branch, [&](LogTail& tail) {
    Statement row = database_->prepare(
        "INSERT INTO scenes(id, name, model, up, front, source_is_32_bit,"
        " first_revision, first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings, checksum)"
        " SELECT ?, ?, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches, subdivisions,"
        " creases_and_flips, settings, checksum"
        " FROM scenes WHERE id = ?");
    if (Status added = row.text(branch).text(name).text(scene).run(); !added.ok()) return added;
    if (Status sealed = seal_scene(*database_, branch); !sealed.ok()) return sealed;
    Statement entries = database_->prepare(
        "INSERT INTO entries SELECT ?, revision, kind, argument, chain, commands, settings, hash_low, hash_high, delta,"
        " author FROM entries WHERE scene = ? AND revision <= ?");
    if (Status copied = entries.text(branch).text(scene).number(last).run(); !copied.ok()) return copied;
    Statement uses = database_->prepare("INSERT INTO picture_uses SELECT ?, picture FROM picture_uses WHERE scene = ?");
    if (Status used = uses.text(branch).text(scene).run(); !used.ok()) return used;
    const Result<std::uint64_t> chain = chain_at(branch, last);
    if (!chain) return chain.status();
    tail = {last, *chain};
    return Status{};
  });
}

/// Inside a change of `to`, up to a revision of this log.
Status Journal::copy_into(const StoredScene& stored, const std::string& scene, Revision last, Journal& to,
                          LogTail& tail, const std::function<void()>& between) const {
  if (Status added = to.insert_scene(stored, encode_delta(stored.first_groom), tail); !added.ok()) return added;
  const Result<std::vector<std::string>> pictures = pictures_of(scene);
  if (!pictures) return pictures.status();
  for (const std::string& name : *pictures) {
    if (between) between();
    const Result<std::string> bytes = picture(name);
    if (!bytes) return bytes.status();
    if (Status added = to.insert_picture(name, *bytes); !added.ok()) return added;
    if (Status used = keep_picture(*to.database_, stored.id, name); !used.ok()) return used;
  }
  const auto copy = [&](const Entry& entry) {
    if (between) between();
    return to.insert_entry(stored.id, entry, encode_delta(entry.delta), tail);
  };
  Status copied = for_each_entry(scene, stored.first_revision, copy, last);
  return copied.ok() && tail.revision != last ? damaged("an entry is missing") : copied;
}

Result<Revision> Journal::copy_scene(const std::string& scene, Journal& to, const std::string& copy,
                                     const std::string& name, const std::function<void()>& between) const {
  const Revision last = last_revision(scene);
  Result<StoredScene> stored = this->scene(scene);
  if (!stored) return stored.status();
  stored->id = copy, stored->name = name;
  const std::lock_guard lock(to.mutex_);
  Status copied = to.change(copy, [&](LogTail& tail) { return copy_into(*stored, scene, last, to, tail, between); });
  if (copied.ok()) return last;
  const Result<StoredScene> now = this->scene(scene);
  if (now && now->first_revision == stored->first_revision && stored->first_revision <= last) return copied;
  return failure(Code::conflict, "the scene was removed or got another model while it was copied");
}

Revision Journal::last_revision(const std::string& scene) const {
  const std::lock_guard lock(mutex_);
  const auto known = tails_.find(scene);
  return known == tails_.end() ? 0 : known->second.revision;
}

Result<std::vector<std::string>> Journal::scene_ids() const {
  const std::lock_guard lock(mutex_);
  Statement rows = database_->prepare("SELECT id FROM scenes ORDER BY number");
  return texts_of(rows);
}

Result<StoredScene> Journal::scene(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const std::string question =
      std::string("SELECT ") + scene_columns + ", checksum, checksum(" + scene_columns + ") FROM scenes WHERE id = ?";
  Statement row = database_->prepare(question.c_str());
  const Result<bool> found = row.text(id).step();
  if (!found) return found.status();
  if (!*found) return failure(Code::not_found, "the journal has no such scene");
  if (row.number_at(12) != row.number_at(13)) return damaged("the model of a scene");
  constexpr auto last_axis = static_cast<std::uint64_t>(Axis::minus_z);
  if (row.number_at(2) > last_axis || row.number_at(3) > last_axis) return damaged("axes of a model");
  if (row.number_at(8) > static_cast<std::uint64_t>(FurPatches::own_uvs)) return damaged("patches of a model");
  Result<FieldDelta> first_groom = decode_delta(row.blob_at(6));
  if (!first_groom) return first_groom.status();
  Result<std::vector<ChosenTriangles>> subdivisions = decode_subdivisions(row.blob_at(9));
  if (!subdivisions) return subdivisions.status();
  auto settings = settings_at(row, 10);
  if (!settings) return settings.status();
  PrepareOptions prepare{static_cast<Axis>(row.number_at(2)), static_cast<Axis>(row.number_at(3)),
                         row.number_at(4) != 0};
  if (!decode_creases_and_flips(row.text_at(11), prepare)) return damaged("creases and flips of a model");
  StoredModel model{row.text_at(1), std::move(prepare), std::string(row.bytes_at(7)),
                    static_cast<FurPatches>(row.number_at(8)), std::move(*subdivisions)};
  return StoredScene{
      id, row.text_at(0), std::move(model), row.number_at(5), std::move(*first_groom), std::move(*settings)};
}

}  // namespace pelage
