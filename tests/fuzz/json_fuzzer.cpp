// Any bytes decode to a command or a refusal; what is decoded encodes and decodes to the same thing.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "clients/cli/recipe/gather.h"
#include "clients/cli/recipe/split_steps.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "protocol/recipes/recipe.h"

namespace {

void require(bool held) {
  if (!held) std::abort();
}

void check_commands(std::string_view text) {
  const auto commands = pelage::decode_commands(text);
  if (!commands) return require(!commands.status().message.empty());
  const std::string encoded = pelage::encode(*commands);
  const auto again = pelage::decode_commands(encoded);
  require(again.ok() && pelage::encode(*again) == encoded);
}

void check_frame(std::string_view text) {
  const auto request = pelage::decode_frame_request(text);
  if (!request) return require(!request.status().message.empty());
  const std::string encoded = pelage::encode(*request);
  const auto again = pelage::decode_frame_request(encoded);
  require(again.ok() && pelage::encode(*again) == encoded);
}

void check_history(std::string_view text) {
  if (const auto amendment = pelage::decode_amend(text)) {
    const std::string encoded = pelage::encode(*amendment);
    const auto again = pelage::decode_amend(encoded);
    require(again.ok() && pelage::encode(*again) == encoded);
  }
  if (const auto branch = pelage::decode_branch(text)) {
    const std::string encoded = pelage::encode(*branch);
    const auto again = pelage::decode_branch(encoded);
    require(again.ok() && pelage::encode(*again) == encoded);
  }
}

/// Checks the text as a recipe, and as a file that the recipe includes.
void check_recipe(std::string_view text) {
  (void)pelage::is_recipe(text);
  const auto read = [text](const std::string&) { return pelage::Result<std::string>(std::string(text)); };
  const auto request = pelage::gather_recipe({"main.json", std::string(text)}, read);
  if (!request) return require(!request.status().message.empty());
  const auto nothing = [](const pelage::PickRequest&) {
    return pelage::Result<pelage::PickAnswer>(pelage::PickAnswer{});
  };
  const auto steps = pelage::expand_recipe(*request, {{{-1, -1, -1}, {1, 1, 1}}, nothing});
  require(steps.ok() ? !steps->empty() : !steps.status().message.empty());
}

/// Checks the text as a query, "name=value&name=value".
void check_query(std::string_view text) {
  pelage::Query query;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find('&'));
    const std::size_t equals = std::min(part.find('='), part.size());
    query.emplace_back(part.substr(0, equals), part.substr(std::min(equals + 1, part.size())));
    text.remove_prefix(std::min(part.size() + 1, text.size()));
  }
  const auto frame = pelage::decode_frame_query(query);
  const auto import = pelage::decode_import_query(query);
  require(frame.ok() || !frame.status().message.empty());
  require(import.ok() || !import.status().message.empty());
  const auto map = pelage::decode_map_query(query);
  const auto upload = pelage::decode_map_upload_query(query);
  const auto mesh = pelage::decode_mesh_query(query);
  require(mesh.ok() || !mesh.status().message.empty());
  require(map.ok() || !map.status().message.empty());
  require(upload.ok() || !upload.status().message.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check_commands(text);
  check_frame(text);
  check_history(text);
  check_query(text);
  check_recipe(text);
  (void)pelage::decode_new_scene(text);
  (void)pelage::decode_pick(text);
  (void)pelage::decode_steps(text);
  (void)pelage::decode_revision(text);
  (void)pelage::decode_answer<pelage::SceneList>(text);
  (void)pelage::decode_problem(text);
  (void)pelage::split_steps(text);
  return 0;
}
