// The entries of scenes' logs, each chained to the one before it.
#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/journal.h"
#include "server/history/rows.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

/// The last of several changes of a request is what it is answered with.
Status write_request(Database& database, const KeyedRequest& request, const RequestedChange& change) {
  return database.prepare("INSERT OR REPLACE INTO requests VALUES(?,?,?,?,?,?,?)")
      .text(request.path)
      .text(request.key)
      .text(request.fingerprint)
      .text(change.scene)
      .number(change.revision)
      .number(change.fields_hash.low)
      .number(change.fields_hash.high)
      .run();
}

/// The chain goes on from `tail`, which moves to the entry.
Status write_entry(Database& database, const std::string& scene, const Entry& entry, const std::string& delta,
                   LogTail& tail) {
  if (entry.settings && !entry.settings->skin_texture.empty()) {
    if (Status kept = keep_picture(database, scene, entry.settings->skin_texture); !kept.ok()) return kept;
  }
  for (const std::string& picture : entry.pictures) {
    if (Status kept = keep_picture(database, scene, picture); !kept.ok()) return kept;
  }
  Statement insert = database.prepare(
      "INSERT INTO entries(scene, revision, kind, argument, commands, settings, hash_low, hash_high, delta, author,"
      " chain) VALUES(?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,chained(?11,?2,?3,?4,?5,?6,?7,?8,?9,?10)) RETURNING chain");
  insert.text(scene).number(entry.revision).number(static_cast<std::uint64_t>(entry.kind)).number(entry.argument);
  bind_settings(insert.text(entry.commands), entry.settings);
  insert.number(entry.fields_hash.low).number(entry.fields_hash.high).blob(delta).text(entry.author);
  const Result<bool> written = insert.number(tail.chain).step();
  if (!written) return written.status();
  tail = {entry.revision, insert.number_at(0)};
  if (!entry.request) return {};
  return write_request(database, *entry.request, {{}, scene, entry.revision, entry.fields_hash});
}

Result<Entry> read_entry(const Statement& row) {
  Entry entry;
  entry.revision = row.number_at(0);
  const std::uint64_t kind = row.number_at(1);
  if (kind > static_cast<std::uint64_t>(EntryKind::replay)) return damaged("kind of an entry");
  entry.kind = static_cast<EntryKind>(kind);
  entry.argument = row.number_at(2);
  entry.commands = row.text_at(3);
  auto settings = settings_at(row, 4);
  if (!settings) return settings.status();
  entry.settings = std::move(*settings);
  entry.fields_hash = {row.number_at(5), row.number_at(6)};
  Result<FieldDelta> delta = decode_delta(row.blob_at(7));
  if (!delta) return delta.status();
  entry.delta = std::move(*delta);
  entry.author = row.text_at(8);
  return entry;
}

}  // namespace

Status Journal::append(const std::string& scene, std::span<const Entry> entries) {
  std::vector<std::string> deltas;
  for (const Entry& entry : entries) deltas.push_back(encode_delta(entry.delta));
  const std::lock_guard lock(mutex_);
  return change(scene, [&](LogTail& tail) {
    Status written;
    for (std::size_t i = 0; written.ok() && i < entries.size(); ++i)
      written = write_entry(*database_, scene, entries[i], deltas[i], tail);
    return written;
  });
}

/// What the chain of the entry after a revision goes on from.
Result<std::uint64_t> Journal::chain_at(const std::string& scene, Revision revision) const {
  Statement row = database_->prepare(
      "SELECT coalesce((SELECT chain FROM entries WHERE scene = ?1 AND revision = ?2),"
      " (SELECT first_revision FROM scenes WHERE id = ?1))");
  const Result<bool> found = row.text(scene).number(revision).step();
  return found ? Result<std::uint64_t>(row.number_at(0)) : found.status();
}

Status Journal::for_each_entry(const std::string& scene, Revision after,
                               const std::function<Status(const Entry&)>& use) const {
  const std::lock_guard lock(mutex_);
  Result<std::uint64_t> chain = chain_at(scene, after);
  if (!chain) return chain.status();
  const std::string question = std::string("SELECT ") + entry_columns + ", chain, checksum(" + entry_columns +
                               ") FROM entries WHERE scene = ? AND revision > ? ORDER BY revision";
  Statement rows = database_->prepare(question.c_str());
  rows.text(scene).number(after);
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) {
    *chain = next_chain(*chain, rows.number_at(10));
    if (*chain != rows.number_at(9)) return damaged_journal();
    const Result<Entry> entry = read_entry(rows);
    if (!entry) return entry.status();
    if (Status used = use(*entry); !used.ok()) return used;
  }
  return row ? Status{} : row.status();
}

Result<std::optional<RequestedChange>> Journal::change_of_request(const std::string& path,
                                                                  const std::string& key) const {
  const std::lock_guard lock(mutex_);
  Statement row = database_->prepare(
      "SELECT fingerprint, scene, revision, hash_low, hash_high FROM requests WHERE path = ? AND key = ?");
  const Result<bool> found = row.text(path).text(key).step();
  if (!found) return found.status();
  if (!*found) return std::optional<RequestedChange>();
  return std::optional(
      RequestedChange{row.text_at(0), row.text_at(1), row.number_at(2), {row.number_at(3), row.number_at(4)}});
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
