// The journal's pictures, which logs name.
#include "server/history/codec.h"
#include "server/history/journal.h"
#include "server/history/rows.h"
#include "server/history/sqlite.h"

namespace pelage {

namespace {

// Drops the oldest uploads that no log names, so that a client that only uploads does not fill the disk.
constexpr const char* drop_oldest_unused =
    "DELETE FROM pictures WHERE rowid IN (SELECT rowid FROM pictures WHERE name NOT IN (SELECT picture FROM "
    "picture_uses)"
    " ORDER BY rowid DESC LIMIT -1 OFFSET 64)";

}  // namespace

Status Journal::add_picture(const std::string& name, const std::string& bytes) {
  if (has_picture(name)) return {};
  const std::lock_guard lock(writing_);
  return take([&] {
    Status added = insert_picture(name, bytes);
    return added.ok() ? writer_->execute(drop_oldest_unused) : added;
  });
}

Status Journal::insert_picture(const std::string& name, const std::string& bytes) {
  const std::string stored = compress_bytes(bytes);
  return writer_->prepare("INSERT OR IGNORE INTO pictures VALUES(?,?)").text(name).blob(stored).run();
}

bool Journal::has_picture(const std::string& name) const {
  const std::lock_guard lock(reading_);
  const Result<bool> found = reader_->prepare("SELECT 1 FROM pictures WHERE name = ?").text(name).step();
  return found && *found;
}

Result<std::string> Journal::picture(const std::string& name) const {
  const std::lock_guard lock(reading_);
  Statement row = reader_->prepare("SELECT bytes FROM pictures WHERE name = ?");
  const Result<bool> found = row.text(name).step();
  if (!found) return found.status();
  if (!*found) return damaged("a picture is missing");
  return decompress_bytes(row.bytes_at(0));
}

Result<std::vector<std::string>> Journal::pictures_of(const std::string& scene) const {
  const std::lock_guard lock(reading_);
  Statement rows = reader_->prepare("SELECT picture FROM picture_uses WHERE scene = ? ORDER BY picture");
  return texts_of(rows.text(scene));
}

}  // namespace pelage
