#include "tests/extremes/row_scene.h"

#include <span>

#include "protocol/json/decode.h"

namespace pelage::testing {

Status carry_out(const std::string& text, Scene& scene, const SceneStore& store) {
  const Result<std::vector<Command>> commands = decode_commands(text);
  if (!commands) return commands.status();
  const Result<CommandAnswer> answer = store.execute(scene, *commands);
  return answer ? Status{} : answer.status();
}

Result<std::shared_ptr<Scene>> scene_of(const Row& row, SceneStore& store) {
  const Result<NewScene> asked = decode_new_scene(row.scene);
  if (!asked) return asked.status();
  Result<std::shared_ptr<Scene>> scene = store.create(*asked);
  if (!scene) return scene;
  if (!row.model.bytes.empty()) {
    ImportOptions options;
    options.format = row.model.format, options.fur = asked->fur;
    const auto loaded = store.load_model(**scene, options, std::as_bytes(std::span(row.model.bytes)));
    if (!loaded) return loaded.status();
  }
  for (const std::string& text : row.commands) {
    if (Status refused = carry_out(text, **scene, store); !refused.ok()) return refused;
  }
  return scene;
}

Result<FrameRequest> request_of(const Row& row) { return decode_frame_request(row.frame); }

}  // namespace pelage::testing
