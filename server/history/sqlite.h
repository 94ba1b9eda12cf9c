// A thin wrapper of SQLite for the journal: calls return a Status, and statements finalize themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"

struct sqlite3;
struct sqlite3_stmt;

namespace pelage {

/// The storage class of a cell.
enum class CellKind : std::uint8_t { null, integer, real, text, blob };

/// One prepared statement. Errors of binding are returned by step().
class Statement {
 public:
  Statement(sqlite3* database, const char* sql);

  Statement& number(std::uint64_t value);
  Statement& text(std::string_view value);
  Statement& blob(std::string_view bytes);
  Statement& null();

  /// Returns true for a row, false at the end.
  Result<bool> step();
  /// Runs a statement that returns no rows.
  Status run();

  // Columns of the current row, from 0. Texts and blobs are valid until the next step.
  int columns() const;
  CellKind kind_at(int column) const;
  std::uint64_t number_at(int column) const;
  std::string text_at(int column) const;
  std::span<const std::byte> blob_at(int column) const;
  std::string_view bytes_at(int column) const;  // of a blob
  bool null_at(int column) const;

 private:
  void record_error(int code);

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  sqlite3* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  int bound_ = 0;
  int error_ = 0;
};

class Database {
 public:
  /// Opens or creates the file.
  static Result<Database> open(const std::string& path);
  /// Makes an empty database in memory.
  static Result<Database> in_memory();
  /// Opens the bytes of an untrusted file, in memory; changes stay there. The resources of a statement are limited, and
  /// views, triggers and other databases are out of reach. Fails (invalid) if the bytes are no database.
  static Result<Database> of_bytes(std::string bytes);

  Statement prepare(const char* sql) { return {database_.get(), sql}; }
  /// Returns the first column of the first row.
  Result<std::uint64_t> number(const char* question);
  /// Runs several statements without parameters.
  Status execute(const char* sql);
  /// Runs `work` atomically, also with respect to a restart: if the disk fails to sync a commit, the commit is taken
  /// back before any other one is made.
  Status transaction(const std::function<Status()>& work);
  /// Takes back a commit whose sync failed, if there is one. Fails while that is not possible.
  Status roll_back_failed_commit();

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  explicit Database(sqlite3* database) : database_(database) {}

  Status try_transaction(const std::function<Status()>& work);

  std::unique_ptr<sqlite3, Close> database_;
  bool failed_commit_ = false;
};

}  // namespace pelage
