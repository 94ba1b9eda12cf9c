#include "server/history/sqlite.h"

#include <sqlite3.h>

#include <cstring>
#include <utility>

#include "server/history/checksum.h"

namespace pelage {

namespace {

Status status_of(sqlite3* database, int code) {
  if (code == SQLITE_OK || code == SQLITE_DONE || code == SQLITE_ROW) return {};
  const std::string message = std::string("the journal cannot be used: ") +
                              (database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code));
  if (code == SQLITE_TOOBIG) return failure(Code::too_large, message);
  const bool full = code == SQLITE_FULL ||  // or no room for the shared memory of connections
                    (database != nullptr && sqlite3_extended_errcode(database) == SQLITE_IOERR_SHMSIZE);
  if (full || code == SQLITE_BUSY || code == SQLITE_LOCKED) return failure(Code::unavailable, message);
  return failure(Code::internal, message);
}

}  // namespace

Statement::Statement(sqlite3* database, const char* sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  record_error(sqlite3_prepare_v2(database, sql, -1, &statement, nullptr));
  statement_.reset(statement);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void Statement::record_error(int code) {
  if (error_ == SQLITE_OK) error_ = code;
}

Statement& Statement::number(std::uint64_t value) {
  if (statement_) record_error(sqlite3_bind_int64(statement_.get(), ++bound_, static_cast<sqlite3_int64>(value)));
  return *this;
}

Statement& Statement::text(std::string_view value) {
  if (statement_) {
    record_error(
        sqlite3_bind_text64(statement_.get(), ++bound_, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  }
  return *this;
}

Statement& Statement::blob(std::string_view bytes) {
  // Not copied: the bytes of a model are large, and outlive the statement.
  if (statement_)
    record_error(sqlite3_bind_blob64(statement_.get(), ++bound_, bytes.data(), bytes.size(), SQLITE_STATIC));
  return *this;
}

Statement& Statement::null() {
  if (statement_) record_error(sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

Result<bool> Statement::step() {
  if (error_ != SQLITE_OK) return status_of(database_, error_);
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return status_of(database_, code);
}

Status Statement::run() {
  const Result<bool> row = step();
  return row ? Status{} : row.status();
}

std::uint64_t Statement::number_at(int column) const {
  return static_cast<std::uint64_t>(sqlite3_column_int64(statement_.get(), column));
}

std::string Statement::text_at(int column) const {
  const unsigned char* text = sqlite3_column_text(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return text != nullptr ? std::string(reinterpret_cast<const char*>(text), size) : std::string();
}

std::span<const std::byte> Statement::blob_at(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return {static_cast<const std::byte*>(bytes), bytes != nullptr ? size : 0};
}

std::string_view Statement::bytes_at(int column) const {
  const std::span<const std::byte> bytes = blob_at(column);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

int Statement::columns() const { return sqlite3_column_count(statement_.get()); }

CellKind Statement::kind_at(int column) const {
  switch (sqlite3_column_type(statement_.get(), column)) {
    case SQLITE_INTEGER: return CellKind::integer;
    case SQLITE_FLOAT: return CellKind::real;
    case SQLITE_TEXT: return CellKind::text;
    case SQLITE_BLOB: return CellKind::blob;
    default: return CellKind::null;
  }
}

bool Statement::null_at(int column) const { return kind_at(column) == CellKind::null; }

namespace {

/// Keeps SQLite from running code in a file's schema, because files may be untrusted.
void distrust_schema(sqlite3* database) {
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
}

/// Sets limits far above the needs of the journal's own statements.
void limit_statements(sqlite3* database) {
  constexpr std::pair<int, int> max[] = {{SQLITE_LIMIT_SQL_LENGTH, 100'000}, {SQLITE_LIMIT_COLUMN, 64},
                                         {SQLITE_LIMIT_EXPR_DEPTH, 100},     {SQLITE_LIMIT_COMPOUND_SELECT, 10},
                                         {SQLITE_LIMIT_VDBE_OP, 25'000},     {SQLITE_LIMIT_FUNCTION_ARG, 16},
                                         {SQLITE_LIMIT_ATTACHED, 0},         {SQLITE_LIMIT_VARIABLE_NUMBER, 64},
                                         {SQLITE_LIMIT_TRIGGER_DEPTH, 0},    {SQLITE_LIMIT_WORKER_THREADS, 0}};
  for (const auto& [limit, value] : max) sqlite3_limit(database, limit, value);
}

/// Clears the WAL mode in the two format bytes of a file's header, because an in-memory database has no WAL.
void forget_wal(std::string& bytes) {
  constexpr std::size_t write_format = 18, read_format = 19;
  constexpr char with_wal = 2, without = 1;
  for (const std::size_t at : {write_format, read_format})
    if (bytes.size() > at && bytes[at] == with_wal) bytes[at] = without;
}

}  // namespace

Result<Database> Database::open(const std::string& path) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  Database database(raw);
  if (code != SQLITE_OK) return status_of(raw, code);
  distrust_schema(raw);
  add_checksum(raw);
  return Result<Database>(std::move(database));
}

Result<Database> Database::in_memory() { return open(":memory:"); }

Result<Database> Database::of_bytes(std::string bytes) {
  constexpr std::int64_t upgrade_bytes = std::int64_t{1} << 30;
  Result<Database> database = in_memory();
  if (!database) return database;
  sqlite3* raw = database->database_.get();
  limit_statements(raw);
  forget_wal(bytes);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(bytes.size()));
  if (copy == nullptr) return failure(Code::too_large, "there is not enough memory for it");
  std::memcpy(copy, bytes.data(), bytes.size());
  std::string().swap(bytes);
  constexpr unsigned flags = SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE;
  if (sqlite3_deserialize(raw, "main", copy, size, size, flags) != SQLITE_OK)
    return failure(Code::invalid, "it is no database");
  sqlite3_int64 max = size + upgrade_bytes;
  sqlite3_file_control(raw, "main", SQLITE_FCNTL_SIZE_LIMIT, &max);
  Status configured =
      database->execute("PRAGMA cell_size_check = ON; PRAGMA temp_store = MEMORY; PRAGMA journal_mode = OFF");
  return configured.ok() ? std::move(database) : Result<Database>(configured);
}

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Result<std::uint64_t> Database::number(const char* question) {
  Statement statement = prepare(question);
  const Result<bool> row = statement.step();
  if (!row) return row.status();
  return statement.number_at(0);
}

Status Database::execute(const char* sql) {
  return status_of(database_.get(), sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr));
}

// A commit whose sync failed may be complete in the WAL, where the next start would find it. The next commit overwrites
// it, so this makes a commit that changes nothing.
Status Database::roll_back_failed_commit() {
  if (!failed_commit_) return {};
  const Result<std::uint64_t> version = number("PRAGMA user_version");
  if (!version) return version.status();
  const std::string same = "PRAGMA user_version = " + std::to_string(*version) + "; COMMIT";
  Status taken_back = execute("BEGIN IMMEDIATE");
  if (taken_back.ok()) taken_back = execute(same.c_str());
  if (!taken_back.ok()) static_cast<void>(execute("ROLLBACK"));
  failed_commit_ = !taken_back.ok();
  return taken_back;
}

Status Database::transaction(const std::function<Status()>& work) {
  if (Status clean = roll_back_failed_commit(); !clean.ok()) return clean;
  Status done = try_transaction(work);
  static_cast<void>(roll_back_failed_commit());  // at once, in case of a kill; the next transaction retries
  return done;
}

Status Database::try_transaction(const std::function<Status()>& work) {
  if (Status begun = execute("BEGIN IMMEDIATE"); !begun.ok()) return begun;
  struct RollBack {  // also if `work` throws; a transaction left open would fail every later one
    Database* database;
    ~RollBack() {
      if (database != nullptr) sqlite3_exec(database->database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
  } roll_back{this};
  Status done = work();
  if (!done.ok()) return done;
  done = execute("COMMIT");
  if (done.ok()) roll_back.database = nullptr;
  failed_commit_ = !done.ok();
  return done;
}

}  // namespace pelage
