#include "server/history/rows.h"

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

Status damaged(const std::string& detail) { return failure(Code::internal, "the journal is damaged: " + detail); }

Statement& bind_settings(Statement& statement, const std::shared_ptr<const SceneSettings>& settings) {
  return settings ? statement.text(encode(commands_of(*settings))) : statement.null();
}

Result<std::shared_ptr<const SceneSettings>> settings_at(const Statement& row, int column) {
  if (row.null_at(column)) return std::shared_ptr<const SceneSettings>();
  const Result<std::vector<Command>> commands = decode_commands(row.text_at(column));
  if (!commands) return damaged("settings");
  SceneSettings settings;
  for (const Command& command : *commands) settings = with_setting(settings, command).value_or(settings);
  return std::make_shared<const SceneSettings>(std::move(settings));
}

Result<std::vector<std::string>> texts_of(Statement& rows) {
  std::vector<std::string> texts;
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) texts.push_back(rows.text_at(0));
  if (!row) return row.status();
  return texts;
}

Status write_request(Database& database, const std::optional<KeyedRequest>& request, const std::string& scene,
                     Revision revision, const FieldsHash& fields_hash) {
  if (!request) return {};
  return database.prepare("INSERT OR REPLACE INTO requests VALUES(?,?,?,?,?,?,?)")
      .text(request->path)
      .text(request->key)
      .text(request->fingerprint)
      .text(scene)
      .number(revision)
      .number(fields_hash.low)
      .number(fields_hash.high)
      .run();
}

Status add_picture_use(Database& database, const std::string& scene, const std::string& picture) {
  Statement use = database.prepare("INSERT OR IGNORE INTO picture_uses VALUES(?,?)");
  return use.text(scene).text(picture).run();
}

Status remove_picture_uses(Database& database, const std::string& scene) {
  constexpr const char* only_here =
      "SELECT picture FROM picture_uses GROUP BY picture HAVING min(scene) = ?1 AND max(scene) = ?1";
  std::vector<std::string> names;
  Statement rows = database.prepare(only_here);
  rows.text(scene);
  Result<bool> row = rows.step();
  for (; row && *row; row = rows.step()) names.push_back(rows.text_at(0));
  if (!row) return row.status();
  Status left = database.prepare("DELETE FROM picture_uses WHERE scene = ?").text(scene).run();
  for (std::size_t i = 0; left.ok() && i < names.size(); ++i) {
    left = database.prepare("DELETE FROM pictures WHERE name = ?").text(names[i]).run();
  }
  return left;
}

}  // namespace pelage
