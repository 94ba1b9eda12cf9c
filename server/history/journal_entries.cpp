// The journal's entries; each is chained to the one before it by a checksum.
#include "server/history/checksum.h"
#include "server/history/codec.h"
#include "server/history/journal.h"
#include "server/history/rows.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

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

Status damaged_entry(const Statement& row) {
  return damaged("the entry of revision " + std::to_string(row.number_at(0)));
}

constexpr std::size_t rows_at_a_time = 64, bytes_at_a_time = std::size_t{4} << 20;

}  // namespace

Status Journal::insert_entry(const std::string& scene, const Entry& entry, const std::string& delta, LogTail& tail) {
  Database& database = *writer_;
  if (entry.settings && !entry.settings->skin_texture.empty()) {
    if (Status added = add_picture_use(database, scene, entry.settings->skin_texture); !added.ok()) return added;
  }
  for (const std::string& picture : entry.pictures) {
    if (Status added = add_picture_use(database, scene, picture); !added.ok()) return added;
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
  return write_request(database, entry.request, scene, entry.revision, entry.fields_hash);
}

Status Journal::append(const std::string& scene, std::span<const Entry> entries) {
  std::vector<std::string> deltas;
  for (const Entry& entry : entries) deltas.push_back(encode_delta(entry.delta));
  const std::lock_guard lock(writing_);
  return change(scene, [&](LogTail& tail) {
    Status written;
    for (std::size_t i = 0; written.ok() && i < entries.size(); ++i)
      written = insert_entry(scene, entries[i], deltas[i], tail);
    return written;
  });
}

Result<std::uint64_t> chain_at(Database& database, const std::string& scene, Revision revision) {
  Statement row = database.prepare(
      "SELECT coalesce((SELECT chain FROM entries WHERE scene = ?1 AND revision = ?2),"
      " (SELECT first_revision FROM scenes WHERE id = ?1))");
  const Result<bool> found = row.text(scene).number(revision).step();
  return found ? Result<std::uint64_t>(row.number_at(0)) : found.status();
}

Result<std::vector<Entry>> Journal::next_entries(const std::string& scene, LogTail& tail, Revision last) const {
  const std::string question = std::string("SELECT ") + entry_columns + ", chain, checksum(" + entry_columns +
                               ") FROM entries WHERE scene = ? AND revision > ? AND revision <= ? ORDER BY revision";
  std::vector<Entry> entries;
  std::size_t bytes = 0;
  const std::lock_guard lock(reading_);
  Statement rows = reader_->prepare(question.c_str());
  rows.text(scene).number(tail.revision).number(last);
  while (entries.size() < rows_at_a_time && bytes < bytes_at_a_time) {
    const Result<bool> row = rows.step();
    if (row && !*row) break;
    const std::uint64_t chain = row ? next_chain(tail.chain, rows.number_at(10)) : 0;
    Result<Entry> entry = !row ? row.status() : chain == rows.number_at(9) ? read_entry(rows) : damaged_entry(rows);
    if (entry && entry->revision <= tail.revision) entry = damaged_entry(rows);
    if (!entry && !entries.empty()) break;  // return the intact ones; the next call returns this error
    if (!entry) return entry.status();
    bytes += rows.blob_at(7).size();
    tail = {entry->revision, chain};
    entries.push_back(std::move(*entry));
  }
  return entries;
}

Status Journal::for_each_entry(const std::string& scene, Revision after, Revision last,
                               const std::function<Status(const Entry&)>& use) const {
  std::unique_lock lock(reading_);
  const Result<std::uint64_t> chain = chain_at(*reader_, scene, after);
  lock.unlock();
  if (!chain) return chain.status();
  LogTail tail{after, *chain};
  for (;;) {
    const Result<std::vector<Entry>> entries = next_entries(scene, tail, last);
    if (!entries) return entries.status();
    if (entries->empty()) return {};
    for (const Entry& entry : *entries) {
      if (Status used = use(entry); !used.ok()) return used;
    }
  }
}

Result<std::optional<RequestedChange>> Journal::change_of_request(const std::string& path,
                                                                  const std::string& key) const {
  const std::lock_guard lock(reading_);
  Statement row = reader_->prepare(
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

Result<std::vector<std::string>> Journal::next_changes(const std::string& scene, Revision after, Revision last) const {
  std::vector<std::string> changes;
  std::size_t bytes = 0;
  const std::lock_guard lock(reading_);
  Statement rows = reader_->prepare(
      "SELECT revision, delta FROM entries WHERE scene = ? AND revision > ? AND revision <= ? ORDER BY revision");
  rows.text(scene).number(after).number(last);
  while (after < last && changes.size() < rows_at_a_time && bytes < bytes_at_a_time) {
    const Result<bool> row = rows.step();
    if (!row) return row.status();
    if (!*row || rows.number_at(0) != ++after) return damaged("an entry is missing");
    changes.emplace_back(rows.bytes_at(1));
    bytes += changes.back().size();
  }
  return changes;
}

Status Journal::for_each_change(const std::string& scene, Revision after, Revision last,
                                const std::function<void(const FieldDelta&)>& use) const {
  while (after < last) {
    const Result<std::vector<std::string>> changes = next_changes(scene, after, last);
    if (!changes) return changes.status();
    for (const std::string& change : *changes) {
      const Result<FieldDelta> delta = decode_delta(std::as_bytes(std::span(change)));
      if (!delta) return delta.status();
      use(*delta);
    }
    after += changes->size();
  }
  return {};
}

Result<FieldDelta> Journal::change(const std::string& scene, Revision after, Revision last) const {
  FieldDelta total;
  Status read = for_each_change(scene, after, last, [&](const FieldDelta& delta) { total = compose(total, delta); });
  return read.ok() ? Result<FieldDelta>(std::move(total)) : read;
}

}  // namespace pelage
