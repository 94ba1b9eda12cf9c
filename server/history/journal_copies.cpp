// Copies of a scene with its log and pictures: branches in the same journal, and scenes in another one.
#include <algorithm>

#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/journal.h"
#include "server/history/rows.h"
#include "server/history/sqlite.h"

namespace pelage {

// The branch references all pictures of the scene, even those that only later entries name.
Status Journal::branch(const std::string& scene, const std::string& branch, const std::string& name, Revision last,
                       const std::optional<KeyedRequest>& request) {
  const std::lock_guard lock(writing_);
  return change(branch, [&](LogTail& tail) {
    if (Status intact = check_scene_checksum(*writer_, scene); !intact.ok()) return intact;
    Statement row = writer_->prepare(
        "INSERT INTO scenes(id, name, model, up, front, source_is_32_bit,"
        " first_revision, first_groom, raw, fur_patches, subdivisions, creases_and_flips, settings, checksum)"
        " SELECT ?, ?, model, up, front, source_is_32_bit, first_revision, first_groom, raw, fur_patches, subdivisions,"
        " creases_and_flips, settings, checksum"
        " FROM scenes WHERE id = ?");
    if (Status added = row.text(branch).text(name).text(scene).run(); !added.ok()) return added;
    if (Status sealed = update_scene_checksum(*writer_, branch); !sealed.ok()) return sealed;
    Statement entries = writer_->prepare(
        "INSERT INTO entries SELECT ?, revision, kind, argument, chain, commands, settings, hash_low, hash_high, delta,"
        " author FROM entries WHERE scene = ? AND revision <= ?");
    if (Status copied = entries.text(branch).text(scene).number(last).run(); !copied.ok()) return copied;
    Statement uses = writer_->prepare("INSERT INTO picture_uses SELECT ?, picture FROM picture_uses WHERE scene = ?");
    if (Status used = uses.text(branch).text(scene).run(); !used.ok()) return used;
    const Result<std::uint64_t> chain = chain_at(*writer_, branch, last);
    if (!chain) return chain.status();
    tail = {last, *chain};
    return write_request(*writer_, request, branch, last);
  });
}

/// Copies the scene, its pictures and its log up to a revision, inside a transaction of `to`.
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
    if (Status used = add_picture_use(*to.writer_, stored.id, name); !used.ok()) return used;
  }
  const auto copy = [&](const Entry& entry) {
    if (between) between();
    return to.insert_entry(stored.id, entry, encode_delta(entry.delta), tail);
  };
  Status copied = for_each_entry(scene, stored.first_revision, last, copy);
  return copied.ok() && tail.revision != last ? damaged("an entry is missing") : copied;
}

Result<Revision> Journal::copy_scene(const std::string& scene, Revision at_most, Journal& to, const std::string& copy,
                                     const std::string& name, const std::function<void()>& between) const {
  const Revision last = std::min(at_most, last_revision(scene));
  Result<StoredScene> stored = this->scene(scene);
  if (!stored) return stored.status();
  stored->id = copy, stored->name = name;
  const std::lock_guard lock(to.writing_);
  Status copied = to.change(copy, [&](LogTail& tail) { return copy_into(*stored, scene, last, to, tail, between); });
  if (copied.ok()) return last;
  const Result<StoredScene> now = this->scene(scene);
  if (now && now->first_revision == stored->first_revision && stored->first_revision <= last) return copied;
  return failure(Code::conflict, "the scene was removed or got another model while it was copied");
}

Revision Journal::last_revision(const std::string& scene) const {
  const std::lock_guard lock(reading_);
  Statement row = reader_->prepare(
      "SELECT coalesce((SELECT max(revision) FROM entries WHERE scene = ?1), first_revision) FROM scenes WHERE id = "
      "?1");
  const Result<bool> found = row.text(scene).step();
  return found && *found ? row.number_at(0) : 0;
}

}  // namespace pelage
