#include "server/history/sqlite.h"

#include <sqlite3.h>

#include <iterator>
#include <string>

namespace pelage {

namespace {

Status status_of(sqlite3* database, int code) {
  if (code == SQLITE_OK || code == SQLITE_DONE || code == SQLITE_ROW) return {};
  const std::string message = std::string("the journal cannot be used: ") +
                              (database != nullptr ? sqlite3_errmsg(database) : sqlite3_errstr(code));
  if (code == SQLITE_TOOBIG) return failure(Code::too_large, message);
  if (code == SQLITE_FULL || code == SQLITE_BUSY || code == SQLITE_LOCKED) return failure(Code::unavailable, message);
  return failure(Code::internal, message);
}

}  // namespace

Statement::Statement(sqlite3* database, const char* sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  keep(sqlite3_prepare_v2(database, sql, -1, &statement, nullptr));
  statement_.reset(statement);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

void Statement::keep(int code) {
  if (error_ == SQLITE_OK) error_ = code;
}

Statement& Statement::number(std::uint64_t value) {
  if (statement_) keep(sqlite3_bind_int64(statement_.get(), ++bound_, static_cast<sqlite3_int64>(value)));
  return *this;
}

Statement& Statement::text(std::string_view value) {
  if (statement_) {
    keep(sqlite3_bind_text64(statement_.get(), ++bound_, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8));
  }
  return *this;
}

Statement& Statement::blob(std::string_view bytes) {
  // No copy: the bytes of a model are large, and outlive the statement.
  if (statement_) keep(sqlite3_bind_blob64(statement_.get(), ++bound_, bytes.data(), bytes.size(), SQLITE_STATIC));
  return *this;
}

Statement& Statement::null() {
  if (statement_) keep(sqlite3_bind_null(statement_.get(), ++bound_));
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

bool Statement::null_at(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL; }

Result<Database> Database::open(const std::string& path) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  Database database(raw);
  if (code != SQLITE_OK) return status_of(raw, code);
  return Result<Database>(std::move(database));
}

void Database::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

Status Database::execute(const char* sql) {
  return status_of(database_.get(), sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr));
}

Status Database::transaction(const std::function<Status()>& work) {
  if (Status begun = execute("BEGIN IMMEDIATE"); !begun.ok()) return begun;
  struct RollBack {  // also where `work` throws: an open transaction would refuse every later one
    Database* database;
    ~RollBack() {
      if (database != nullptr) sqlite3_exec(database->database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
  } roll_back{this};
  Status done = work();
  if (done.ok()) done = execute("COMMIT");
  if (done.ok()) roll_back.database = nullptr;
  return done;
}

namespace {

struct Renamed {
  const char* before;
  const char* now;
};

// Names of the contract before 1.0, as logged commands hold them.
constexpr Renamed names_of_version_6[] = {{R"("op":"layer")", R"("op":"edit_layer")"},
                                          {R"("layer":)", R"("edit_layer":)"},
                                          {R"("op":"set_base_picture")", R"("op":"set_skin_texture")"},
                                          {R"("odd_hairs":)", R"("ticking":)"},
                                          {R"("mode":"least")", R"("mode":"min")"},
                                          {R"("mode":"most")", R"("mode":"max")"}};

/// Logged commands are compact JSON: inside a user's text a quote has a backslash before it, so that only names match.
Status rename_in_commands(Database& database, const Renamed& name) {
  const std::string replaced = std::string(", '") + name.before + "', '" + name.now + "')";
  const std::string statements = "UPDATE entries SET commands = replace(commands" + replaced +
                                 ", settings = replace(settings" + replaced +
                                 "; UPDATE scenes SET settings = replace(settings" + replaced;
  return database.execute(statements.c_str());
}

Status to_version_6(Database& database) {
  Status current;
  for (const Renamed& name : names_of_version_6)
    if (current.ok()) current = rename_in_commands(database, name);
  return current.ok() ? database.execute("PRAGMA user_version = 6") : current;
}

// The step from each version to the next, from oldest_upgraded_version on.
constexpr Status (*steps[])(Database&) = {to_version_6};
static_assert(oldest_upgraded_version + std::size(steps) == schema_version);

}  // namespace

Status upgrade(Database& database, std::uint64_t version) {
  Status current;
  for (std::uint64_t from = version; from < schema_version && current.ok(); ++from)
    current = steps[from - oldest_upgraded_version](database);
  return current;
}

}  // namespace pelage
