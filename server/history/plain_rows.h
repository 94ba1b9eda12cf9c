// A journal's rows as plain bytes: the form in which the sandboxed worker hands the content of an untrusted file to the
// server.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

class Database;

/// Returns the names of a database's tables, in order of creation.
Result<std::vector<std::string>> tables_of(Database& database);

/// Refuses (invalid) a database with a cell of another kind than its column's declared type.
Status check_kinds(Database& database);

/// Returns all rows of all tables. A row is a byte with the number of its table, then its cells; a cell is a CellKind
/// byte and 8 bytes that hold the integer, or count the bytes that follow. Native byte order.
Result<std::string> rows_of(Database& database);

/// Inserts such rows into a database with the same tables, while their bytes arrive. It buffers one row.
class RowLoader {
 public:
  /// Makes a loader for `to`, which must outlive it. Fails as the database does.
  static Result<RowLoader> into(Database& to);

  /// Takes the next bytes. Refuses (invalid) bytes that are not rows, and rows that no table accepts.
  Status take(std::string_view bytes);
  /// Ends the input. Refuses (invalid) a truncated last row, and cells of another kind than their column.
  Status finish();

 private:
  struct Table {
    std::string insert;  // SQL with a parameter for each cell
    std::size_t cells = 0;
  };
  explicit RowLoader(Database& to) : to_(&to) {}
  Result<std::size_t> take_row(std::string_view bytes);

  Database* to_;
  std::vector<Table> tables_;
  std::string waiting_;  // the beginning of an incomplete row
};

}  // namespace pelage
