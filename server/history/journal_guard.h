// Guards a server's journal with files beside it, to detect that the file system failed: lost commits, replaced files,
// a full disk.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/status.h"
#include "protocol/commands/answers.h"

namespace pelage {

/// The end of a scene's log.
struct LogTail {
  Revision revision = 0;
  std::uint64_t chain = 0;  // chain value of its last entry; first_revision if there is none
  bool operator==(const LogTail&) const = default;
};
using LogTails = std::map<std::string, LogTail>;  // by id of the scene

/// Bytes that must be free on the disk for a server to be ready; also the size of the reserve.
constexpr std::uint64_t min_free_bytes = std::uint64_t{16} << 20;

/// Locks the folder of a journal against other servers, as long as this object lives.
class FolderLock {
 public:
  /// Locks the folder of a path. Fails (unavailable) while another server holds it, (internal) if it does not exist.
  static Result<FolderLock> of(const std::string& path);
  FolderLock(FolderLock&& other) noexcept : folder_(std::exchange(other.folder_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int folder) : folder_(folder) {}
  int folder_;
};

/// Watches an open journal and its WAL. Not thread-safe. It writes two files beside them. PATH-acknowledged holds the
/// ends of all logs as acknowledged to clients; the journal has at least these, unless it has lost something.
/// PATH-reserve occupies min_free_bytes, which are freed to work with when the disk is full.
class JournalGuard {
 public:
  JournalGuard(std::string path, FolderLock lock);
  ~JournalGuard();
  JournalGuard(const JournalGuard&) = delete;
  JournalGuard& operator=(const JournalGuard&) = delete;

  /// Fails (unavailable) once the journal or its WAL is no longer the file at its path, because then writes are lost.
  Status files_in_place() const;
  /// Returns the free bytes of the disk for the journal at a path, without the reserve.
  static std::uint64_t free_space_at(const std::string& path);
  std::uint64_t free_space() const { return free_space_at(path_); }

  /// Returns the ends of logs that were acknowledged to clients, as the last server on this folder left them; nothing
  /// if the file is missing or damaged.
  const std::optional<LogTails>& acknowledged() const { return acknowledged_; }
  /// Writes the text without a sync. After a power loss the file may hold an older state, which only acknowledges less.
  void acknowledge(const std::string& text_of_tails) noexcept;
  static std::string text_of(const LogTails& tails);

  /// Deletes the reserve of the journal at a path, to free its bytes; returns false if there was none.
  static bool free_reserve(const std::string& path);
  bool free_reserve() { return free_reserve(path_); }
  /// Allocates the reserve if the disk has room for it.
  void allocate_reserve();

 private:
  struct File {
    dev_t device = 0;
    ino_t number = 0;
    bool operator==(const File&) const = default;
  };
  static std::optional<File> file_at(const std::string& path);

  const std::string path_;
  const FolderLock lock_;
  std::optional<File> journal_, wal_;
  std::optional<LogTails> acknowledged_;
  int tails_file_ = -1;
};

}  // namespace pelage
