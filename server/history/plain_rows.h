// A journal's rows as plain bytes: the form in which the confined worker hands the content of an untrusted file to the
// server.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

class Database;

/// The names of a database's tables, in the order they were made in.
Result<std::vector<std::string>> tables_of(Database& database);

/// Refused (invalid) unless every cell holds what its column is declared as.
Status check_kinds(Database& database);

/// All rows of all tables: for each the number of its table, then its cells, each a CellKind and eight bytes that are
/// the integer or count the bytes that follow. Native byte order.
Result<std::string> rows_of(Database& database);

/// Puts such rows into the tables of another database with the same tables, as their bytes come in. Holds one row.
class RowLoader {
 public:
  /// Fails as the database does. `to` has to live as long.
  static Result<RowLoader> into(Database& to);

  /// Takes the next bytes. Refused (invalid) where they are no rows, or no table takes them.
  Status take(std::string_view bytes);
  /// Refused (invalid) where the last row is cut off or a cell is of another kind than its column.
  Status finish();

 private:
  struct Table {
    std::string insert;  // with a parameter for each cell
    std::size_t cells = 0;
  };
  explicit RowLoader(Database& to) : to_(&to) {}
  Result<std::size_t> take_row(std::string_view bytes);

  Database* to_;
  std::vector<Table> tables_;
  std::string waiting_;  // the beginning of a row
};

}  // namespace pelage
