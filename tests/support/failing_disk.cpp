#include "tests/support/failing_disk.h"

namespace pelage {

FailingDisk::FailingDisk() : vfs_(*sqlite3_vfs_find(nullptr)) {
  base_ = sqlite3_vfs_find(nullptr);
  syncs_to_fail = 0, is_full = false, during_sync = nullptr;
  vfs_.zName = "failing disk";
  vfs_.xOpen = open;
  sqlite3_vfs_register(&vfs_, 1);
}

int FailingDisk::open(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* opened) {
  const int code = base_->xOpen(base_, name, file, flags, opened);
  if (code != SQLITE_OK) return code;
  // SQLite locks databases and not other files, so the two have methods of their own; both sync and write in the same
  // way.
  sqlite3_io_methods& methods = (flags & SQLITE_OPEN_MAIN_DB) != 0 ? of_databases_ : of_others_;
  real_ = file->pMethods, methods = *real_;
  methods.xSync = sync, methods.xWrite = write;
  file->pMethods = &methods;
  return SQLITE_OK;
}

int FailingDisk::sync(sqlite3_file* file, int flags) {
  if (during_sync) during_sync();
  if (syncs_to_fail == 0) return real_->xSync(file, flags);
  --syncs_to_fail;
  return SQLITE_IOERR_FSYNC;
}

int FailingDisk::write(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 at) {
  return is_full ? SQLITE_FULL : real_->xWrite(file, bytes, size, at);
}

}  // namespace pelage
