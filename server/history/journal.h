// The durable log of all scenes: what it has answered ok to is on disk.
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

/// All that it takes to prepare a scene's model and its first groom again, without the code that made them.
struct StoredModel {
  std::string name;  // "creature", "obj", ...
  PrepareOptions prepare = {};
  std::string raw;  // encode_raw_model
  FurPatches fur_patches = FurPatches::overlapping;
  // Carried out one after the other on the prepared model. One without triangles splits nothing: it says that the
  // scene's groom is older than its log, as after a turn.
  std::vector<ChosenTriangles> subdivisions = {};
};

struct StoredScene {
  std::string id, name;
  StoredModel model;
  Revision first_revision = 0;                                    // at which the model came
  FieldDelta first_groom;                                         // from fur upright and of length 0
  std::shared_ptr<const SceneSettings> first_settings = nullptr;  // null: those that a scene of this model begins with
  std::optional<KeyedRequest> request = {};                       // that made it so; not read back
};

/// What a request with a key made of a scene.
struct RequestedChange {
  std::string fingerprint;  // as in KeyedRequest
  std::string scene;
  Revision revision = 0;
  FieldsHash fields_hash;
};

/// What a journal has lost since clients were told of it: entries, or a whole scene if there is no `present`.
struct LostEntries {
  std::string scene;
  Revision told = 0;
  std::optional<Revision> present;
};

/// After every revision.
constexpr Revision newest_revision = std::numeric_limits<std::int64_t>::max();

class Database;

/// Thread-safe. One SQLite file in WAL mode, synced at each change. Readers have a connection beside the writers' one,
/// and wait for no disk that is slow to take a change.
class Journal {
 public:
  /// Fails (internal) when the file is no journal or comes from a newer version.
  static Result<std::unique_ptr<Journal>> open(const std::string& path);
  /// A new journal of the rows (plain_rows.h) that `feed` hands over, all of them or none. Refused (invalid) where they
  /// are none; fails as `feed` does.
  using TakeRows = std::function<Status(std::string_view bytes)>;
  static Result<std::unique_ptr<Journal>> of_rows(const std::string& path,
                                                  const std::function<Status(const TakeRows&)>& feed);
  /// Opens a server's journal in the same way, under a JournalGuard. Fails (unavailable) while another server uses it.
  static Result<std::unique_ptr<Journal>> open_guarded(const std::string& path);
  ~Journal();

  /// Fails (unavailable) while it cannot take changes: its files are gone, its disk has no room, or no commit reaches
  /// the disk. A journal without a guard checks nothing.
  Status health() const;
  /// What it had lost when it was opened.
  const std::vector<LostEntries>& lost() const { return lost_; }

  Status add_scene(const StoredScene& scene);
  /// Puts a new model in place of the old one and its log, whose pictures go, except one that its settings name.
  Status replace_model(const StoredScene& scene);
  /// Replaces all subdivisions of the scene's model, the axes that point up and forward, its first revision, groom and
  /// settings, and empties its log. The rest of the model's source stays, whatever `scene` says of it, and so do the
  /// scene's pictures, one of which its settings may name.
  Status reshape_model(const StoredScene& scene);
  Status rename_scene(const std::string& id, const std::string& name);
  Status remove_scene(const std::string& id);
  /// Fails when the entry's settings or commands name a picture that the journal does not have.
  Status append(const std::string& scene, const Entry& entry) { return append(scene, std::span(&entry, 1)); }
  /// All of them or none.
  Status append(const std::string& scene, std::span<const Entry> entries);
  /// Adds a scene with another one's model and entries up to `last`. `scene` has to be there.
  Status branch(const std::string& scene, const std::string& branch, const std::string& name, Revision last,
                const std::optional<KeyedRequest>& request = {});

  /// Writes the scene with its model, log and pictures into another journal, there under the id `copy` and a name, in
  /// one transaction: everything up to the revision that it returns, at most `at_most`, or nothing. It reads a few
  /// entries at a time, so that it takes little memory, and refuses what is damaged (internal); conflict where the
  /// scene goes or gets another model meanwhile. Others use this journal meanwhile, and wait for `to`. `between` is
  /// called between entries, and ends the copy by throwing.
  Result<Revision> copy_scene(const std::string& scene, Revision at_most, Journal& to, const std::string& copy,
                              const std::string& name, const std::function<void()>& between = {}) const;

  /// Keeps a picture (encode_raw_image, encode_map_picture) under its name, for as long as a scene's log names it. One
  /// that is known stays.
  Status add_picture(const std::string& name, const std::string& bytes);
  bool has_picture(const std::string& name) const;
  /// Returns a picture. Fails (internal) if there is none of that name.
  Result<std::string> picture(const std::string& name) const;

  /// Returns the names of all pictures that the scene's log names.
  Result<std::vector<std::string>> pictures_of(const std::string& scene) const;
  /// Ids of all scenes, in the order they were made in.
  Result<std::vector<std::string>> scene_ids() const;
  /// Returns the name of a scene, also of one that is damaged otherwise.
  Result<std::string> name_of(const std::string& scene) const;
  Result<StoredScene> scene(const std::string& id) const;
  /// Calls `use` with each entry with a revision above `after`, oldest first, until it fails. Fails (internal) at the
  /// first entry that is damaged or that does not follow the one before it. Others use the journal meanwhile.
  Status for_each_entry(const std::string& scene, Revision after,
                        const std::function<Status(const Entry&)>& use) const {
    return for_each_entry(scene, after, newest_revision, use);
  }
  /// Does the same for entries with a revision in (after, last].
  Status for_each_entry(const std::string& scene, Revision after, Revision last,
                        const std::function<Status(const Entry&)>& use) const;
  /// Returns the change made by the request that came to this path with this Idempotency-Key; nothing if the request
  /// changed nothing, or if the scene is gone.
  Result<std::optional<RequestedChange>> change_of_request(const std::string& path, const std::string& key) const;
  /// Returns all entries with a revision above `after`.
  Result<std::vector<Entry>> entries(const std::string& scene, Revision after) const;
  /// Calls `use` with the change of each entry with a revision in (after, last], in order. Fails (internal) when one is
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
  // Some rows at a time, without which those who write would wait for a long log.
  /// The entries after `tail`, which moves to the last of them; none at the end.
  Result<std::vector<Entry>> next_entries(const std::string& scene, LogTail& tail, Revision last) const;
  /// encode_delta of the first changes in (after, last].
  Result<std::vector<std::string>> next_changes(const std::string& scene, Revision after, Revision last) const;

  // All of these need `writing_`.
  /// All of `work`, which moves the tail of the scene's log, or nothing of it.
  Status take(const std::function<Status()>& work);
  Status check_room() const;
  void find_lost();
  void give_room_back();
  Status change(const std::string& scene, const std::function<Status(LogTail&)>& work);
  Status read_tails();
  Status insert_scene(const StoredScene& scene, const std::string& first_groom, LogTail& tail);
  Status insert_picture(const std::string& name, const std::string& bytes);
  /// Inserts an entry. The chain continues from `tail`, which moves to the entry.
  Status insert_entry(const std::string& scene, const Entry& entry, const std::string& delta, LogTail& tail);

  mutable std::mutex writing_;
  mutable std::mutex reading_;  // never held by who writes
  std::unique_ptr<Database> writer_, reader_;
  std::unique_ptr<JournalGuard> guard_;
  LogTails tails_;  // of all scenes
  std::vector<LostEntries> lost_;
};

/// Returns the failure (internal) for an entry that does not fit those before it.
inline Status damaged_journal() {
  return failure(Code::internal, "the journal is damaged: an entry does not fit the ones before it");
}

}  // namespace pelage
