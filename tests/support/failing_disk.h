// A disk that fails when a test says so, under all files that SQLite opens meanwhile.
#pragma once

#include <sqlite3.h>

#include <atomic>
#include <functional>

namespace pelage {

/// One at a time; databases are opened after it and closed before it goes.
class FailingDisk {
 public:
  FailingDisk();
  ~FailingDisk() { sqlite3_vfs_unregister(&vfs_); }
  FailingDisk(const FailingDisk&) = delete;
  FailingDisk& operator=(const FailingDisk&) = delete;

  // What is done in spite of it: a sync that fails leaves what was written before.
  static inline std::atomic<int> syncs_to_fail{0};
  static inline std::atomic<bool> is_full{false};
  static inline std::function<void()> during_sync = {};  // called in each; set while nothing is written

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
