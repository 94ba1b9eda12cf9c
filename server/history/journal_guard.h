// What stands beside the file of a server's journal, so that the server knows when the file system has failed it.
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
  std::uint64_t chain = 0;  // of its last entry; first_revision where there is none
  bool operator==(const LogTail&) const = default;
};
using LogTails = std::map<std::string, LogTail>;  // by the id of the scene

/// Bytes that the disk has to have for a server to be ready, and that the reserve holds.
constexpr std::uint64_t min_room = std::uint64_t{16} << 20;

/// Keeps other servers off the folder of a journal for as long as it lives.
class FolderLock {
 public:
  /// Fails (unavailable) while another server holds the folder of this path, and (internal) where there is none.
  static Result<FolderLock> of(const std::string& path);
  FolderLock(FolderLock&& other) noexcept : folder_(std::exchange(other.folder_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int folder) : folder_(folder) {}
  int folder_;
};

/// Watches the journal at a path, which is open, with its WAL. Not thread-safe. It writes two files beside them:
/// PATH-acknowledged has the ends of all logs as clients were told of them, which is never more than the journal has
/// unless the journal has lost something, and PATH-reserve has min_room bytes to work with when the disk is full.
class JournalGuard {
 public:
  JournalGuard(std::string path, FolderLock lock);
  ~JournalGuard();
  JournalGuard(const JournalGuard&) = delete;
  JournalGuard& operator=(const JournalGuard&) = delete;

  /// Fails (unavailable) once the journal or its WAL is no longer the file at its path: what is written then is lost.
  Status files_are_there() const;
  /// Bytes that the disk has for the journal at a path, without the reserve.
  static std::uint64_t room_at(const std::string& path);
  std::uint64_t room() const { return room_at(path_); }

  /// The ends of logs that clients were told of, as the last server on this folder left them; none where the file is
  /// missing or broken.
  const std::optional<LogTails>& acknowledged() const { return acknowledged_; }
  /// Writes the text without a sync: after a power loss the file may have an older state, which only says less.
  void acknowledge(const std::string& text_of_tails) noexcept;
  static std::string text_of(const LogTails& tails);

  /// Gives the disk the reserve of the journal at a path; false where there was none.
  static bool free_reserve(const std::string& path);
  bool free_reserve() { return free_reserve(path_); }
  /// Takes the reserve where the disk has room for it.
  void take_reserve();

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
