#include "clients/cli/recipe/asserts.h"

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
    (name == "min_vertices" ? limits.min : limits.max) = member.get<std::size_t>();
  }
  return limits;
}

Status take_assert(json& command, std::optional<TouchLimits>& to, const std::string& pointer) {
  if (!command.is_object() || !command.contains("assert")) return {};
  const Result<TouchLimits> limits = limits_in(command["assert"]);
  if (!limits) {
    Status bad = limits.status();
    bad.pointer.insert(0, pointer + "/assert");
    return bad;
  }
  to = *limits;
  command.erase("assert");
  return {};
}

}  // namespace

Status take_asserts(json& step, std::vector<std::optional<TouchLimits>>& asserts) {
  const bool is_batch = step.contains("commands") && step["commands"].is_array();
  if (is_batch && step.contains("assert"))
    return failure(Code::invalid, "In a batch an assert belongs to one of its commands.", "/assert", "beside an op");
  asserts.resize(is_batch ? step["commands"].size() : 1);
  bool any = false;
  for (std::size_t k = 0; k < asserts.size(); ++k) {
    json& command = is_batch ? step["commands"][k] : step;
    const std::string pointer = is_batch ? "/commands/" + std::to_string(k) : "";
    if (Status bad = take_assert(command, asserts[k], pointer); !bad.ok()) return bad;
    any = any || asserts[k];
  }
  if (!any) asserts.clear();
  return {};
}

}  // namespace pelage::json_parts
