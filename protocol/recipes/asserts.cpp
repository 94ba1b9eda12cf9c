#include "protocol/recipes/asserts.h"

#include "protocol/json/parse.h"
#include "protocol/json/reader.h"

namespace pelage::json_parts {

using nlohmann::json;

namespace {

constexpr const char* assert_limit = "{\"min_vertices\": count, \"max_vertices\": count}";

Result<TouchLimits> limits_in(const json& value) {
  if (!value.is_object() || value.empty())
    return failure(Code::invalid, "An assert says how many vertices a command touches.", "", assert_limit);
  TouchLimits limits;
  for (const auto& [name, member] : value.items()) {
    if (name != "min_vertices" && name != "max_vertices")
      return failure(Code::invalid, "\"" + name + "\" is not known here.", pointer_step(name), assert_limit,
                     nearest_name(name, {"min_vertices", "max_vertices"}));
    if (!member.is_number_unsigned())
      return failure(Code::invalid, "It is no count of vertices.", pointer_step(name), "0 or more");
    (name == "min_vertices" ? limits.min_vertices : limits.max_vertices) = member.get<std::uint64_t>();
  }
  return limits;
}

/// Moves the assert of a command, if it has one, to `asserts`.
Status take_assert(json& command, std::size_t number, const std::string& pointer, std::vector<TouchLimits>& asserts) {
  if (!command.is_object() || !command.contains("assert")) return {};
  Result<TouchLimits> limits = limits_in(command["assert"]);
  if (!limits) {
    Status bad = limits.status();
    bad.pointer.insert(0, pointer + "/assert");
    return bad;
  }
  limits->command = number;
  asserts.push_back(*limits);
  command.erase("assert");
  return {};
}

}  // namespace

Result<std::vector<TouchLimits>> take_asserts(json& step) {
  std::vector<TouchLimits> asserts;
  if (!step.contains("commands") || !step["commands"].is_array()) {
    if (Status bad = take_assert(step, 0, "", asserts); !bad.ok()) return bad;
    return asserts;
  }
  if (step.contains("assert"))
    return failure(Code::invalid, "In a batch an assert belongs to one of its commands.", "/assert", "beside an op");
  json& commands = step["commands"];
  for (std::size_t k = 0; k < commands.size(); ++k)
    if (Status bad = take_assert(commands[k], k, "/commands/" + std::to_string(k), asserts); !bad.ok()) return bad;
  return asserts;
}

}  // namespace pelage::json_parts
