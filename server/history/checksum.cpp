#include "server/history/checksum.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

#include "base/random.h"
#include "server/history/rows.h"

namespace pelage {

namespace {

std::uint64_t with_bytes(std::uint64_t sum, const void* bytes, std::size_t size) {
  sum = mix_bits(sum ^ size);
  for (std::size_t at = 0; at < size; at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, static_cast<const char*>(bytes) + at, std::min<std::size_t>(8, size - at));
    sum = mix_bits(sum ^ word);
  }
  return sum;
}

std::uint64_t with_value(std::uint64_t sum, sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  sum = mix_bits(sum ^ static_cast<std::uint64_t>(type));
  if (type == SQLITE_INTEGER) return mix_bits(sum ^ static_cast<std::uint64_t>(sqlite3_value_int64(value)));
  if (type == SQLITE_NULL) return sum;
  const void* bytes = type == SQLITE_BLOB ? sqlite3_value_blob(value) : sqlite3_value_text(value);
  return with_bytes(sum, bytes, static_cast<std::size_t>(sqlite3_value_bytes(value)));
}

std::uint64_t sum_of(std::span<sqlite3_value*> values) {
  std::uint64_t sum = values.size();
  for (sqlite3_value* value : values) sum = with_value(sum, value);
  return sum;
}

void checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  const std::uint64_t sum = sum_of({values, static_cast<std::size_t>(count)});
  sqlite3_result_int64(context, static_cast<sqlite3_int64>(sum));
}

void chained(sqlite3_context* context, int count, sqlite3_value** values) {
  const auto before = static_cast<std::uint64_t>(sqlite3_value_int64(values[0]));
  const std::uint64_t chain = next_chain(before, sum_of({values + 1, static_cast<std::size_t>(count) - 1}));
  sqlite3_result_int64(context, static_cast<sqlite3_int64>(chain));
}

}  // namespace

void add_checksum(sqlite3* database) {
  constexpr int how = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY;
  sqlite3_create_function(database, "checksum", -1, how, nullptr, checksum, nullptr, nullptr);
  sqlite3_create_function(database, "chained", -1, how, nullptr, chained, nullptr, nullptr);
}

std::uint64_t checksum_of(std::string_view bytes) { return with_bytes(0, bytes.data(), bytes.size()); }

std::uint64_t next_chain(std::uint64_t before, std::uint64_t entry_checksum) {
  return mix_bits(mix_bits(before) ^ entry_checksum);
}

Status check_scene_checksum(Database& database, std::string_view id) {
  const std::string question =
      std::string("SELECT checksum = checksum(") + scene_columns + ") FROM scenes WHERE id = ?";
  Statement row = database.prepare(question.c_str());
  const Result<bool> found = row.text(id).step();
  if (!found) return found.status();
  return *found && row.number_at(0) == 0 ? damaged("the model of a scene") : Status{};
}

Status update_scene_checksum(Database& database, std::string_view id) {
  const std::string update = std::string("UPDATE scenes SET checksum = checksum(") + scene_columns + ") WHERE id = ?";
  return database.prepare(update.c_str()).text(id).run();
}

}  // namespace pelage
