#include "server/import_worker/gltf_json.h"

#include <algorithm>

namespace pelage::gltf {

namespace {

/// Returns a member; null if there is none, or if `object` is no object.
const json* find(const json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

}  // namespace

const json& list(const json& object, const char* name) {
  static const json none = json::array();
  const json* found = find(object, name);
  return found && found->is_array() ? *found : none;
}

const json& member(const json& object, const char* name) {
  static const json none = json::object();
  const json* found = find(object, name);
  return found && found->is_object() ? *found : none;
}

std::string text(const json& object, const char* name) {
  const json* found = find(object, name);
  return found && found->is_string() ? found->get<std::string>() : std::string();
}

std::int64_t index(const json& object, const char* name) {
  const json* found = find(object, name);
  return found && found->is_number_unsigned() ? found->get<std::int64_t>() : -1;
}

const json* item(const json& array, std::int64_t number) {
  if (!array.is_array() || number < 0 || number >= static_cast<std::int64_t>(array.size())) return nullptr;
  return &array[static_cast<std::size_t>(number)];
}

std::string printable(std::string word) {
  word.resize(std::min<std::size_t>(word.size(), 200));
  std::replace_if(
      word.begin(), word.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return json::parse(json(word).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

std::string name_of(const json& items, std::int64_t number, const char* kind) {
  const json* found = item(items, number);
  const std::string name = found ? printable(text(*found, "name")) : "";
  return name.empty() ? kind + (" " + std::to_string(number)) : name;
}

}  // namespace pelage::gltf
