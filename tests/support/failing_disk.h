// A disk that fails on demand, below all files that SQLite opens while it exists.
#pragma once

#include <sqlite3.h>

#include <atomic>
#include <functional>

namespace pelage {

/// Only one may exist at a time. Databases are opened after it is made, and closed before it is destroyed.
class FailingDisk {
 public:
  FailingDisk();
  ~FailingDisk() { sqlite3_vfs_unregister(&vfs_); }
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  // Faults to inject. A sync that fails leaves on disk what was written before.
  static inline std::atomic<int> syncs_to_fail{0};
  static inline std::atomic<bool> is_full{false};
  static inline std::function<void()> during_sync = {};  // called in each sync; set it while nothing is written

 private:
  static int open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* opened);
  static int sync(sqlite3_file* file, int flags);
  static int write(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 at);

  static inline sqlite3_vfs* base_ = nullptr;
  static inline const sqlite3_io_methods* real_ = nullptr;
  static inline sqlite3_io_methods of_databases_{}, of_others_{};
  sqlite3_vfs vfs_;
};

}  // namespace pelage
