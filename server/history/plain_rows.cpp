#include "server/history/plain_rows.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "server/history/sqlite.h"

namespace pelage {

namespace {

constexpr std::size_t cell_head = 1 + sizeof(std::uint64_t);
constexpr std::uint64_t max_cell_bytes = 1'000'000'000;  // the limit of SQLite

Status no_rows() { return failure(Code::invalid, "The rows of the file are damaged."); }

/// A column of a table. Names come from the program's own schema and so need no quotes.
struct Column {
  std::string name, type;
  bool may_be_null = false;
};

Result<std::vector<Column>> columns_of(Database& database, const std::string& table) {
  std::vector<Column> columns;
  Statement rows = database.prepare(("PRAGMA table_info(" + table + ")").c_str());
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step())
    columns.push_back({rows.text_at(1), rows.text_at(2), rows.number_at(3) == 0 && rows.number_at(5) == 0});
  if (!row) return row.status();
  return columns;
}

std::string misfits_of(const Column& column) {
  std::string type = column.type;
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });
  return "typeof(" + column.name + ") NOT IN ('" + type + (column.may_be_null ? "', 'null')" : "')");
}

void put_head(std::string& bytes, CellKind kind, std::uint64_t value) {
  bytes.push_back(static_cast<char>(kind));
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_cell(std::string& bytes, const Statement& row, int column) {
  const CellKind kind = row.kind_at(column);
  if (kind == CellKind::integer) return put_head(bytes, kind, row.number_at(column));
  if (kind == CellKind::text) {
    const std::string text = row.text_at(column);
    put_head(bytes, kind, text.size());
    bytes += text;
    return;
  }
  const auto blob = kind == CellKind::blob ? row.blob_at(column) : std::span<const std::byte>();
  put_head(bytes, kind, blob.size());
  bytes.append(reinterpret_cast<const char*>(blob.data()), blob.size());
}

/// Estimates the bytes of the database's rows; 0 if unknown.
std::size_t bytes_of_pages(Database& database) {
  Statement size = database.prepare("SELECT page_count * page_size * 9 / 8 FROM pragma_page_count, pragma_page_size");
  const Result<bool> row = size.step();
  return row && *row ? size.number_at(0) : 0;
}

struct Cell {
  CellKind kind = CellKind::null;
  std::uint64_t value = 0;  // of an integer
  std::string_view bytes;   // of a text or blob, as far as present
  bool complete = false;
};

/// Reads a cell and removes it from the front.
Result<Cell> take_cell(std::string_view& bytes) {
  if (bytes.size() < cell_head) return Cell{};
  Cell cell{static_cast<CellKind>(bytes.front()), 0, {}, true};
  std::memcpy(&cell.value, bytes.data() + 1, sizeof cell.value);
  bytes.remove_prefix(cell_head);
  if (cell.kind == CellKind::null || cell.kind == CellKind::integer) return cell;
  if (cell.kind != CellKind::text && cell.kind != CellKind::blob) return no_rows();
  if (cell.value > max_cell_bytes) return no_rows();
  cell.complete = cell.value <= bytes.size();
  cell.bytes = bytes.substr(0, cell.value);
  bytes.remove_prefix(cell.bytes.size());
  return cell;
}

/// Reads the cells of a row and removes them from the front; none if the row is incomplete.
Result<std::vector<Cell>> take_cells(std::string_view& bytes, std::size_t count) {
  std::vector<Cell> cells;
  while (cells.size() < count) {
    const Result<Cell> cell = take_cell(bytes);
    if (!cell) return cell.status();
    if (!cell->complete) return std::vector<Cell>();
    cells.push_back(*cell);
  }
  return cells;
}

void bind(Statement& insert, const Cell& cell) {
  switch (cell.kind) {
    case CellKind::integer: insert.number(cell.value); break;
    case CellKind::text: insert.text(cell.bytes); break;
    case CellKind::blob: insert.blob(cell.bytes); break;
    default: insert.null();
  }
}

}  // namespace

Result<std::vector<std::string>> tables_of(Database& database) {
  std::vector<std::string> names;
  Statement rows = database.prepare("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY rowid");
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) names.push_back(rows.text_at(0));
  if (!row) return row.status();
  return names;
}

Status check_kinds(Database& database) {
  const Result<std::vector<std::string>> tables = tables_of(database);
  if (!tables) return tables.status();
  for (const std::string& table : *tables) {
    const Result<std::vector<Column>> columns = columns_of(database, table);
    if (!columns) return columns.status();
    std::string misfits;
    for (const Column& column : *columns) misfits += (misfits.empty() ? "" : " OR ") + misfits_of(column);
    Statement search = database.prepare(("SELECT 1 FROM " + table + " WHERE " + misfits + " LIMIT 1").c_str());
    const Result<bool> found = search.step();
    if (!found) return found.status();
    if (*found) return failure(Code::invalid, "a cell of its table " + table + " is of another kind than its column");
  }
  return {};
}

Result<std::string> rows_of(Database& database) {
  const Result<std::vector<std::string>> tables = tables_of(database);
  if (!tables) return tables.status();
  std::string bytes;
  bytes.reserve(bytes_of_pages(database));
  for (std::size_t t = 0; t < tables->size(); ++t) {
    Statement rows = database.prepare(("SELECT * FROM " + (*tables)[t]).c_str());
    Result<bool> row = rows.step();
    for (; row && *row; row = rows.step()) {
      bytes.push_back(static_cast<char>(t));
      for (int column = 0; column < rows.columns(); ++column) put_cell(bytes, rows, column);
    }
    if (!row) return row.status();
  }
  return bytes;
}

Result<RowLoader> RowLoader::into(Database& to) {
  RowLoader loader(to);
  const Result<std::vector<std::string>> tables = tables_of(to);
  if (!tables) return tables.status();
  for (const std::string& table : *tables) {
    const Result<std::vector<Column>> columns = columns_of(to, table);
    if (!columns) return columns.status();
    std::string parameters;
    for (std::size_t k = 0; k < columns->size(); ++k) parameters += k == 0 ? "?" : ",?";
    loader.tables_.push_back({"INSERT INTO " + table + " VALUES(" + parameters + ")", columns->size()});
  }
  return loader;
}

Status RowLoader::take(std::string_view bytes) {
  waiting_ += bytes;
  std::string_view left = waiting_;
  for (;;) {
    const Result<std::size_t> taken = take_row(left);
    if (!taken) return taken.status();
    if (*taken == 0) break;
    left.remove_prefix(*taken);
  }
  waiting_.erase(0, waiting_.size() - left.size());
  return {};
}

/// Inserts the row at the front into its table and returns its size in bytes; 0 if the row is incomplete.
Result<std::size_t> RowLoader::take_row(std::string_view bytes) {
  if (bytes.empty()) return std::size_t{0};
  const auto number = static_cast<unsigned char>(bytes.front());
  if (number >= tables_.size()) return no_rows();
  const Table& table = tables_[number];
  std::string_view remaining = bytes.substr(1);
  const Result<std::vector<Cell>> cells = take_cells(remaining, table.cells);
  if (!cells) return cells.status();
  if (cells->empty()) return std::size_t{0};
  Statement insert = to_->prepare(table.insert.c_str());
  for (const Cell& cell : *cells) bind(insert, cell);
  const Status put = insert.run();
  if (put.code == Code::unavailable) return put;
  if (!put.ok()) return failure(Code::invalid, "The rows of the file contradict each other: " + put.message);
  return bytes.size() - remaining.size();
}

Status RowLoader::finish() { return waiting_.empty() ? check_kinds(*to_) : no_rows(); }

}  // namespace pelage
