#include "server/history/journal.h"

#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/plain_rows.h"
#include "server/history/rows.h"
#include "server/history/schema.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

// Full synchronisation: a commit that has returned is on disk.
constexpr const char* writer_pragmas = R"(
  PRAGMA auto_vacuum = INCREMENTAL;
  PRAGMA journal_mode = WAL;
  PRAGMA synchronous = FULL;
  PRAGMA foreign_keys = ON;
  PRAGMA journal_size_limit = 16777216;
  BEGIN IMMEDIATE; COMMIT;
)";

// A reader sees a commit once it is on disk, and not earlier.
constexpr const char* reader_pragmas = "PRAGMA query_only = ON; PRAGMA busy_timeout = 5000";

// Drops the pictures that no log names. It runs at start, when it also drops uploads that were never used.
constexpr const char* drop_unused_pictures =
    "DELETE FROM pictures WHERE name NOT IN (SELECT picture FROM picture_uses)";

/// Binds all columns that a new model changes, then the scene's id; runs the statement, seals the row and stores the
/// request.
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
  if (written.ok()) written = update_scene_checksum(database, scene.id);
  return written.ok() ? write_request(database, scene.request, scene.id, scene.first_revision) : written;
}

/// Drops the references to the pictures of the scene's log, except to one that its settings name.
Status change_pictures(Database& database, const StoredScene& scene) {
  const std::string used = scene.first_settings ? scene.first_settings->skin_texture : "";
  if (used.empty()) return remove_picture_uses(database, scene.id);
  constexpr const char* others = "DELETE FROM picture_uses WHERE scene = ? AND picture <> ?";
  return database.prepare(others).text(scene.id).text(used).run();
}

}  // namespace

Journal::Journal(std::unique_ptr<Database> writer, std::unique_ptr<Database> reader)
    : writer_(std::move(writer)), reader_(std::move(reader)) {}
Journal::~Journal() = default;

Result<std::unique_ptr<Journal>> Journal::open(const std::string& path) {
  Result<Database> writer = Database::open(path);
  if (!writer) return writer.status();
  if (Status executed = writer->execute(writer_pragmas); !executed.ok()) return executed;
  if (Status good = prepare_schema(*writer); !good.ok()) return good;
  static_cast<void>(writer->execute(drop_unused_pictures));  // a failure must not prevent the start
  Result<Database> reader = Database::open(path);
  if (!reader) return reader.status();
  if (Status executed = reader->execute(reader_pragmas); !executed.ok()) return executed;
  std::unique_ptr<Journal> journal(
      new Journal(std::make_unique<Database>(std::move(*writer)), std::make_unique<Database>(std::move(*reader))));
  if (Status read = journal->read_tails(); !read.ok()) return read;
  return journal;
}

/// Reads the end of each scene's log. It stays empty for a scene whose rows cannot be read; loading the scene reports
/// the error.
Status Journal::read_tails() {
  const Result<std::vector<std::string>> ids = scene_ids();
  if (!ids) return ids.status();
  for (const std::string& id : *ids) {
    Statement row = writer_->prepare(
        "SELECT coalesce(e.revision, s.first_revision), coalesce(e.chain, s.first_revision) FROM scenes s"
        " LEFT JOIN entries e ON e.scene = s.id AND e.revision = (SELECT max(revision) FROM entries WHERE scene = s.id)"
        " WHERE s.id = ?");
    LogTail& tail = tails_[id];
    if (const Result<bool> found = row.text(id).step(); found && *found) tail = {row.number_at(0), row.number_at(1)};
  }
  return {};
}

Status Journal::change(const std::string& scene, const std::function<Status(LogTail&)>& work) {
  const auto [tail_entry, fresh] = tails_.try_emplace(scene);
  const LogTail before = tail_entry->second;
  const auto roll_back = [&, at = tail_entry, made = fresh] {
    at->second = before;
    if (made) tails_.erase(at);
  };
  std::string acknowledged;  // made before the commit, after which nothing may fail
  Status done;
  try {
    done = take([&, at = tail_entry] {
      Status worked = work(at->second);
      if (worked.ok() && guard_) acknowledged = JournalGuard::text_of(tails_);
      return worked;
    });
  } catch (...) {
    roll_back();
    throw;
  }
  if (!done.ok()) roll_back();
  if (done.ok() && guard_) guard_->acknowledge(acknowledged);
  return done;
}

Result<std::unique_ptr<Journal>> Journal::from_rows(const std::string& path,
                                                    const std::function<Status(const TakeRows&)>& feed) {
  Result<std::unique_ptr<Journal>> journal = open(path);
  if (!journal) return journal;
  Database& database = *(*journal)->writer_;
  Status filled = database.transaction([&] {
    Result<RowLoader> loader = RowLoader::into(database);
    if (!loader) return loader.status();
    Status fed = feed([&](std::string_view bytes) { return loader->take(bytes); });
    return fed.ok() ? loader->finish() : fed;
  });
  if (filled.ok()) filled = (*journal)->read_tails();
  return filled.ok() ? std::move(journal) : Result<std::unique_ptr<Journal>>(filled);
}

/// Commits a transaction only if the journal's files are still where the next start looks for them.
Status Journal::take(const std::function<Status()>& work) {
  Status done = writer_->transaction([&] {
    Status worked = work();
    return worked.ok() && guard_ ? guard_->files_in_place() : worked;
  });
  if (done.code != Code::unavailable || !guard_) return done;
  Status free_space = check_free_space();
  return free_space.ok() ? done : free_space;
}

Status Journal::check_free_space() const {
  const std::uint64_t free_space = guard_->free_space() >> 20, needed = min_free_bytes >> 20;
  if (free_space >= needed) return {};
  return failure(Code::unavailable, "The disk of the data folder has " + std::to_string(free_space) + " MiB left.", "",
                 "at least " + std::to_string(needed) + " MiB");
}

Result<std::unique_ptr<Journal>> Journal::open_guarded(const std::string& path) {
  Result<FolderLock> lock = FolderLock::of(path);
  if (!lock) return lock.status();
  auto journal = open(path);
  const bool full = JournalGuard::free_space_at(path) < min_free_bytes;
  if (!journal && full && JournalGuard::free_reserve(path)) journal = open(path);
  if (!journal) return journal;
  (*journal)->guard_ = std::make_unique<JournalGuard>(path, std::move(*lock));
  (*journal)->find_lost();
  return journal;
}

void Journal::find_lost() {
  for (const auto& [scene, acknowledged] : guard_->acknowledged().value_or(LogTails{})) {
    const auto present = tails_.find(scene);
    if (present == tails_.end()) {
      lost_.push_back({scene, acknowledged.revision, {}});
    } else if (present->second.revision < acknowledged.revision) {
      lost_.push_back({scene, acknowledged.revision, present->second.revision});
    }
  }
  guard_->acknowledge(JournalGuard::text_of(tails_));
}

// Does not wait for the lock: its holder is in a transaction, which checks the same.
Status Journal::health() const {
  if (!guard_) return {};
  if (Status there = guard_->files_in_place(); !there.ok()) return there;
  if (const std::unique_lock lock(writing_, std::try_to_lock); lock) {
    if (Status clean = writer_->roll_back_failed_commit(); !clean.ok()) return clean;
  }
  return check_free_space();
}

Status Journal::add_scene(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(writing_);
  return change(scene.id, [&](LogTail& tail) { return insert_scene(scene, first_groom, tail); });
}

Status Journal::insert_scene(const StoredScene& scene, const std::string& first_groom, LogTail& tail) {
  tail = {scene.first_revision, scene.first_revision};
  Statement insert = writer_->prepare(
      "INSERT INTO scenes(name, model, up, front, source_is_32_bit, first_revision,"
      " first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings, id, checksum)"
      " VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,0)");
  insert.text(scene.name);
  return run_with_model(*writer_, std::move(insert), scene, first_groom);
}

Status Journal::replace_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::lock_guard lock(writing_);
  return change(scene.id, [&](LogTail& tail) {
    tail = {scene.first_revision, scene.first_revision};
    Status cleared = writer_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!cleared.ok()) return cleared;
    if (Status unused = change_pictures(*writer_, scene); !unused.ok()) return unused;
    Statement update = writer_->prepare(
        "UPDATE scenes SET model = ?, up = ?, front = ?, source_is_32_bit = ?, first_revision = ?, first_groom = ?,"
        " raw = ?, fur_patches = ?, subdivisions = ?, creases_and_flips = ?, settings = ? WHERE id = ?");
    return run_with_model(*writer_, std::move(update), scene, first_groom);
  });
}

Status Journal::reshape_model(const StoredScene& scene) {
  const std::string first_groom = encode_delta(scene.first_groom);
  const std::string subdivisions = encode_subdivisions(scene.model.subdivisions);
  const PrepareOptions& prepare_options = scene.model.prepare;
  const std::lock_guard lock(writing_);
  return change(scene.id, [&](LogTail& tail) {
    tail = {scene.first_revision, scene.first_revision};
    if (Status intact = check_scene_checksum(*writer_, scene.id); !intact.ok()) return intact;
    Status changed = writer_->prepare("DELETE FROM entries WHERE scene = ?").text(scene.id).run();
    if (!changed.ok()) return changed;
    Statement update = writer_->prepare(
        "UPDATE scenes SET up = ?, front = ?, first_revision = ?, first_groom = ?, subdivisions = ?, settings = ?"
        " WHERE id = ?");
    update.number(static_cast<std::uint64_t>(prepare_options.up))
        .number(static_cast<std::uint64_t>(prepare_options.front));
    update.number(scene.first_revision).blob(first_groom).blob(subdivisions);
    changed = bind_settings(update, scene.first_settings).text(scene.id).run();
    if (changed.ok()) changed = update_scene_checksum(*writer_, scene.id);
    return changed.ok() ? write_request(*writer_, scene.request, scene.id, scene.first_revision) : changed;
  });
}

Status Journal::rename_scene(const std::string& id, const std::string& name) {
  const std::lock_guard lock(writing_);
  return take([&] {
    if (Status intact = check_scene_checksum(*writer_, id); !intact.ok()) return intact;
    Status named = writer_->prepare("UPDATE scenes SET name = ? WHERE id = ?").text(name).text(id).run();
    return named.ok() ? update_scene_checksum(*writer_, id) : named;
  });
}

Status Journal::remove_scene(const std::string& id) {
  const std::lock_guard lock(writing_);
  const auto remove = [&] {
    return take([&] {
      if (Status unused = remove_picture_uses(*writer_, id); !unused.ok()) return unused;
      return writer_->prepare("DELETE FROM scenes WHERE id = ?").text(id).run();
    });
  };
  LogTails left = tails_;
  left.erase(id);
  if (guard_) guard_->acknowledge(JournalGuard::text_of(left));  // first, so that a kill in between looks like no loss
  Status removed = remove();
  if (removed.code == Code::unavailable && guard_ && guard_->free_reserve()) removed = remove();
  if (removed.ok()) tails_ = std::move(left);
  if (!removed.ok() && guard_) guard_->acknowledge(JournalGuard::text_of(tails_));
  if (removed.ok()) return_unused_pages();
  if (guard_) guard_->allocate_reserve();
  return removed;
}

/// Returns unused pages to the disk. A failure is retried when the next scene is removed. Works in steps, because each
/// step first writes the moved pages to the WAL.
void Journal::return_unused_pages() {
  const auto unused_pages = [&] {
    const Result<std::uint64_t> count = writer_->number("PRAGMA freelist_count");
    return count ? *count : 0;
  };
  bool shrinks = guard_ != nullptr;
  while (shrinks) {
    const std::uint64_t before = unused_pages();
    shrinks = writer_->execute("PRAGMA incremental_vacuum(1000); PRAGMA wal_checkpoint(TRUNCATE)").ok() &&
              unused_pages() < before;
  }
}

Result<std::vector<std::string>> Journal::scene_ids() const {
  const std::lock_guard lock(reading_);
  Statement rows = reader_->prepare("SELECT id FROM scenes ORDER BY number");
  return texts_of(rows);
}

Result<std::string> Journal::name_of(const std::string& scene) const {
  const std::lock_guard lock(reading_);
  Statement row = reader_->prepare("SELECT name FROM scenes WHERE id = ?");
  const Result<bool> found = row.text(scene).step();
  return found ? Result<std::string>(row.text_at(0)) : found.status();
}

Result<StoredScene> Journal::scene(const std::string& id) const {
  const std::lock_guard lock(reading_);
  const std::string question =
      std::string("SELECT ") + scene_columns + ", checksum, checksum(" + scene_columns + ") FROM scenes WHERE id = ?";
  Statement row = reader_->prepare(question.c_str());
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
