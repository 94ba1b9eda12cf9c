// State and recent changes of a scene, for clients that follow it.
#include <algorithm>

#include "protocol/json/decode.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

constexpr std::size_t changes_at_a_time = 256;

/// Returns the ops in the JSON text of an entry's commands, each once.
std::vector<std::string> ops_of(const std::string& commands) {
  std::vector<std::string> ops;
  if (commands.empty()) return ops;
  const Result<std::vector<Command>> decoded = decode_commands(commands);
  if (!decoded) return ops;
  for (const Command& command : *decoded) {
    if (std::find(ops.begin(), ops.end(), op_of(command)) == ops.end()) ops.emplace_back(op_of(command));
  }
  return ops;
}

}  // namespace

SceneNews Scene::news(std::optional<Revision> after) const {
  SceneNews news;
  std::vector<LoggedChange> logged;
  {
    const std::lock_guard lock(mutex_);
    news.now = {present_->revision, history_.first_revision(), history_.undo_steps(), history_.redo_steps(),
                present_->model->mesh_id};
    if (after && *after >= news.now.first_revision && *after <= news.now.revision)
      logged = history_.changes_after(*after, changes_at_a_time);
  }
  for (LoggedChange& change : logged) {  // without the lock, because decoding a long stroke takes time
    change.event.ops = ops_of(change.commands);
    news.changes.push_back(std::move(change.event));
  }
  return news;
}

}  // namespace pelage
