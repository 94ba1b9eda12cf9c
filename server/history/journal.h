// The durable log of all scenes. A call that returned ok is on disk.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/scene.h"
#include "server/fields/field_set.h"
#include "server/history/history.h"
#include "server/history/journal_guard.h"
#include "server/patches/subdivide.h"
#include "server/surface/prepare.h"

namespace pelage {

/// The source of a scene's model, from which it can be prepared again without the code that made it.
struct StoredModel {
  std::string name;  // "creature", "obj", ...
  PrepareOptions prepare = {};
  std::string raw;  // encode_raw_model
  FurPatches fur_patches = FurPatches::overlapping;
  // Applied in order to the prepared model. An element without triangles splits nothing: it marks that the scene's
  // groom is older than its log, as after a turn.
  std::vector<ChosenTriangles> subdivisions = {};
};

struct StoredScene {
  std::string id, name;
  StoredModel model;
  Revision first_revision = 0;                                    // revision at which the model was set
  FieldDelta first_groom;                                         // difference from upright fur of length 0
  std::shared_ptr<const SceneSettings> first_settings = nullptr;  // null: the model's default settings
  std::optional<KeyedRequest> request = {};                       // the request that made this state; not read back
};

/// The change that a request with a key made.
struct RequestedChange {
  std::string fingerprint;  // as in KeyedRequest
  std::string scene;
  Revision revision = 0;
  FieldsHash fields_hash;
};

/// Entries that the journal had acknowledged to clients and lost since; the whole scene if there is no `present`.
struct LostEntries {
  std::string scene;
  Revision acknowledged = 0;
  std::optional<Revision> present;
};

/// A revision above all others.
constexpr Revision newest_revision = std::numeric_limits<std::int64_t>::max();

class Database;

/// Thread-safe. One SQLite file in WAL mode, synced at each change. Readers have a connection of their own, so they do
/// not wait for a slow disk that takes a change.
class Journal {
 public:
  /// Opens or creates a journal. Fails (internal) if the file is not a journal or comes from a newer version.
  static Result<std::unique_ptr<Journal>> open(const std::string& path);
  /// Makes a new journal from the rows (plain_rows.h) that `feed` delivers, all of them or none. Refuses (invalid)
  /// bytes that are not rows of a journal; fails as `feed` does.
  using TakeRows = std::function<Status(std::string_view bytes)>;
  static Result<std::unique_ptr<Journal>> from_rows(const std::string& path,
                                                    const std::function<Status(const TakeRows&)>& feed);
  /// Opens a server's journal as `open` does, under a JournalGuard. Fails (unavailable) while another server uses it.
  static Result<std::unique_ptr<Journal>> open_guarded(const std::string& path);
  ~Journal();

  /// Fails (unavailable) while the journal cannot take changes: its files are gone, its disk is full, or commits do not
  /// reach the disk. A journal without a guard is always healthy.
  Status health() const;
  /// Returns what the journal had lost when it was opened.
  const std::vector<LostEntries>& lost() const { return lost_; }

  Status add_scene(const StoredScene& scene);
  /// Replaces the scene's model and settings, and empties its log. Pictures of the old log are dropped, except the one
  /// that the new settings name.
  Status replace_model(const StoredScene& scene);
  /// Replaces the subdivisions of the scene's model, its up and front axes, first revision, first groom and settings,
  /// and empties its log. The other parts of the model's source stay, whatever `scene` says, and so do the scene's
  /// pictures, one of which its settings may name.
  Status reshape_model(const StoredScene& scene);
  Status rename_scene(const std::string& id, const std::string& name);
  Status remove_scene(const std::string& id);
  /// Appends an entry. Fails if its settings or commands name a picture that the journal does not have.
  Status append(const std::string& scene, const Entry& entry) { return append(scene, std::span(&entry, 1)); }
  /// Appends all of the entries or none.
  Status append(const std::string& scene, std::span<const Entry> entries);
  /// Adds a scene `branch` with the model of `scene` and its entries up to `last`. `scene` must exist.
  Status branch(const std::string& scene, const std::string& branch, const std::string& name, Revision last,
                const std::optional<KeyedRequest>& request = {});

  /// Copies the scene with its model, log and pictures to another journal, there under the id `copy` and a name, in one
  /// transaction. It copies the log up to at most `at_most` and returns the last revision copied. It reads a few
  /// entries at a time, to use little memory. Fails (internal) if the scene is damaged, with conflict if it is removed
  /// or gets another model meanwhile. This journal stays usable meanwhile; users of `to` wait. `between` is called
  /// between entries, and can end the copy by throwing.
  Result<Revision> copy_scene(const std::string& scene, Revision at_most, Journal& to, const std::string& copy,
                              const std::string& name, const std::function<void()>& between = {}) const;

  /// Stores a picture (encode_raw_image, encode_map_picture) under its name, for as long as a scene's log names it. A
  /// picture of a known name is not replaced.
  Status add_picture(const std::string& name, const std::string& bytes);
  bool has_picture(const std::string& name) const;
  /// Returns a picture. Fails (internal) if there is none of that name.
  Result<std::string> picture(const std::string& name) const;

  /// Returns the names of all pictures that the scene's log names.
  Result<std::vector<std::string>> pictures_of(const std::string& scene) const;
  /// Returns the ids of all scenes, in order of creation.
  Result<std::vector<std::string>> scene_ids() const;
  /// Returns the name of a scene, even if the scene is damaged otherwise.
  Result<std::string> name_of(const std::string& scene) const;
  Result<StoredScene> scene(const std::string& id) const;
  /// Calls `use` with each entry with a revision above `after`, oldest first, until it fails. Fails (internal) at the
  /// first entry that is damaged or does not follow the one before it. The journal stays usable meanwhile.
  Status for_each_entry(const std::string& scene, Revision after,
                        const std::function<Status(const Entry&)>& use) const {
    return for_each_entry(scene, after, newest_revision, use);
  }
  /// Does the same for entries with a revision in (after, last].
  Status for_each_entry(const std::string& scene, Revision after, Revision last,
                        const std::function<Status(const Entry&)>& use) const;
  /// Returns the change made by the request with this path and Idempotency-Key; nothing if the request changed nothing,
  /// or if the scene is gone.
  Result<std::optional<RequestedChange>> change_of_request(const std::string& path, const std::string& key) const;
  /// Returns all entries with a revision above `after`.
  Result<std::vector<Entry>> entries(const std::string& scene, Revision after) const;
  /// Calls `use` with the change of each entry with a revision in (after, last], in order. Fails (internal) if one is
  /// missing or damaged.
  Status for_each_change(const std::string& scene, Revision after, Revision last,
                         const std::function<void(const FieldDelta&)>& use) const;
  /// Returns the changes in (after, last] as one change.
  Result<FieldDelta> change(const std::string& scene, Revision after, Revision last) const;

 private:
  Journal(std::unique_ptr<Database> writer, std::unique_ptr<Database> reader);
  Status copy_into(const StoredScene& stored, const std::string& scene, Revision last, Journal& to, LogTail& tail,
                   const std::function<void()>& between) const;
  Revision last_revision(const std::string& scene) const;
  // These read some rows at a time, so that nobody waits for a whole long log.
  /// Returns the next entries after `tail`, and moves `tail` to the last of them; none at the end.
  Result<std::vector<Entry>> next_entries(const std::string& scene, LogTail& tail, Revision last) const;
  /// Returns the first changes in (after, last], as encode_delta wrote them.
  Result<std::vector<std::string>> next_changes(const std::string& scene, Revision after, Revision last) const;

  // The caller of these must hold `writing_`.
  /// Runs `work` in a transaction that also checks that the journal's files are in place.
  Status take(const std::function<Status()>& work);
  Status check_free_space() const;
  void find_lost();
  void return_unused_pages();
  Status change(const std::string& scene, const std::function<Status(LogTail&)>& work);
  Status read_tails();
  Status insert_scene(const StoredScene& scene, const std::string& first_groom, LogTail& tail);
  Status insert_picture(const std::string& name, const std::string& bytes);
  /// Inserts an entry, whose chain value follows from that of `tail`, and moves `tail` to the entry.
  Status insert_entry(const std::string& scene, const Entry& entry, const std::string& delta, LogTail& tail);

  mutable std::mutex writing_;
  mutable std::mutex reading_;  // writers never hold it
  std::unique_ptr<Database> writer_, reader_;
  std::unique_ptr<JournalGuard> guard_;
  LogTails tails_;  // of all scenes
  std::vector<LostEntries> lost_;
};

/// Returns the error (internal) for an entry that does not fit those before it.
inline Status damaged_journal() {
  return failure(Code::internal, "the journal is damaged: an entry does not fit the ones before it");
}

}  // namespace pelage
