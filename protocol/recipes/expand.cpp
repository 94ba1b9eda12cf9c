#include "protocol/recipes/expand.h"

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "protocol/json/parse.h"
#include "protocol/json/reader.h"
#include "protocol/recipes/asserts.h"
#include "protocol/recipes/places.h"

namespace pelage::json_parts {

using nlohmann::json;

namespace {

constexpr const char* step_kinds = "op | commands | use | pick | for | comment";

/// Returns the step without its comment, which is not sent.
json without_comment(const json& step) {
  json copy = json::object();
  for (const auto& [name, member] : step.items())
    if (name != "comment") copy[name] = member;
  return copy;
}

}  // namespace

Result<std::vector<FilledStep>> Expander::expand(Scope& scope) {
  add_steps(scope.file.steps, scope, "/steps");
  if (!filler_.status().ok()) return filler_.status();
  if (steps_.empty()) return refused_in(scope.file, "There are no commands in it.", "/steps", "1 or more");
  return std::move(steps_);
}

void Expander::add_steps(const json& steps, Scope& scope, const std::string& pointer) {
  for (std::size_t k = 0; k < steps.size() && filler_.status().ok(); ++k)
    add_step(steps[k], scope, pointer + "/" + std::to_string(k));
}

void Expander::add_step(const json& step, Scope& scope, const std::string& pointer) {
  if (++count_ > recipe_steps) {
    filler_.refuse(scope, "There are too many steps.", pointer, "at most " + std::to_string(recipe_steps));
    return;
  }
  if (!step.is_object()) {
    filler_.refuse(scope, "A step is an object.", pointer, step_kinds);
    return;
  }
  if (step.size() == 1 && step.contains("comment")) return;
  if (step.contains("use")) return use(step, scope, pointer);
  if (step.contains("pick")) return pick(step, scope, pointer);
  if (step.contains("for")) return loop(step, scope, pointer);
  if (step.contains("op") || step.contains("commands")) return add_commands(step, scope, pointer);
  filler_.refuse(scope, "A step is a command, a batch, a use, a pick, a loop or a comment.", pointer, step_kinds);
}

void Expander::add_commands(const json& step, const Scope& scope, const std::string& pointer) {
  json filled = filler_.fill(without_comment(step), scope, pointer);
  if (!filler_.status().ok()) return;
  Result<std::vector<TouchLimits>> asserts = take_asserts(filled);
  if (!asserts) return filler_.refuse(scope, pointer, asserts.status());
  steps_.push_back({dumped(filled), scope.file.name, scope.file.pointer + pointer, std::move(*asserts)});
}

void Expander::loop(const json& step, Scope& scope, const std::string& pointer) {
  if (!has_only(step, {{"for", json::value_t::object}, {"steps", json::value_t::array}},
                "A loop has \"for\", lists of values by the variable's name, and \"steps\".", scope, pointer))
    return;
  const json lists = filler_.fill(step["for"], scope, pointer + "/for");
  if (!filler_.status().ok()) return;
  for (const auto& [name, list] : lists.items()) {
    if (list.is_array() && !list.empty() && list.size() == lists.front().size()) continue;
    filler_.refuse(scope, "A loop takes lists, one value or more in each and as many in all.",
                   pointer + "/for" + pointer_step(name), "list");
    return;
  }
  if (!lists.empty()) return run_loop(lists, step["steps"], scope, pointer + "/steps");
  filler_.refuse(scope, "A loop has a variable.", pointer + "/for", "1 or more");
}

void Expander::run_loop(const json& lists, const json& steps, Scope& scope, const std::string& pointer) {
  json hidden = json::object();  // values that the loop's variables hide
  for (const auto& [name, list] : lists.items())
    if (scope.given.contains(name)) hidden[name] = scope.given[name];
  for (std::size_t k = 0; k < lists.front().size() && filler_.status().ok(); ++k) {
    for (const auto& [name, list] : lists.items()) scope.given[name] = list[k];
    add_steps(steps, scope, pointer);
  }
  for (const auto& [name, list] : lists.items()) scope.given.erase(name);
  scope.given.update(hidden);
}

void Expander::pick(const json& step, Scope& scope, const std::string& pointer) {
  if (!has_only(step, {{"pick", json::value_t::object}, {"as", json::value_t::string}},
                "A pick says what to pick, and \"as\" what variable the place becomes.", scope, pointer))
    return;
  const std::string name = step["as"].get<std::string>();
  json request = filler_.fill(step["pick"], scope, pointer + "/pick");
  if (!filler_.status().ok()) return;
  if (uses_ == 0 && places_.contains(name) && is_triple(places_[name]))
    request = {{"nearest", filler_.position_at(places_[name])}};
  if (++picks_ > recipe_picks) {
    filler_.refuse(scope, "There are too many picks.", pointer, "at most " + std::to_string(recipe_picks));
    return;
  }
  const Result<json> answer = picked(request);
  if (!answer) return filler_.refuse(scope, pointer + "/pick", answer.status());
  scope.given[name] = filler_.shares_of((*answer)["position"]);
  for (const auto& [member, value] : answer->items()) scope.given[name + "." + member] = value;
}

Result<json> Expander::picked(const json& request) {
  const Result<PickRequest> wanted = decode_pick(dumped(request));
  if (!wanted) return wanted.status();
  const Result<PickAnswer> answer = scene_.pick(*wanted);
  if (!answer) return answer.status();
  if (!answer->hit) return failure(Code::invalid, "The pick finds nothing there.");
  return parse_json(encode(*answer));
}

void Expander::use(const json& step, Scope& scope, const std::string& pointer) {
  for (const auto& [name, member] : step.items()) {
    if (name == "comment" || (name == "use" ? member.is_string() : name == "with" && member.is_object())) continue;
    filler_.refuse(scope, "A use has a name, and \"with\" values for its variables.", pointer + pointer_step(name),
                   "use: text, with: object");
    return;
  }
  const std::string wanted = step["use"].get<std::string>();
  const auto file = scope.file.includes.find(wanted);
  if (file == scope.file.includes.end()) {
    std::vector<std::string_view> known;
    for (const auto& [name, included] : scope.file.includes) known.push_back(name);
    filler_.refuse(scope, "No file that is included is called \"" + wanted + "\".", pointer + "/use",
                   "one of \"include\", without its ending", nearest_name(wanted, known));
    return;
  }
  Scope inner{*file->second, json::object()};
  if (step.contains("with")) inner.given = filler_.fill(step["with"], scope, pointer + "/with");
  if (!filler_.status().ok() || !knows_all(inner, scope, pointer + "/with")) return;
  ++uses_;
  add_steps(inner.file.steps, inner, "/steps");
  --uses_;
}

/// Returns whether the used file has every variable that is given; refuses one that it lacks.
bool Expander::knows_all(const Scope& inner, const Scope& outer, const std::string& pointer) {
  for (const auto& item : inner.given.items()) {
    if (inner.file.variables.contains(item.key())) continue;
    filler_.refuse(outer, inner.file.name + " has no variable \"" + item.key() + "\".",
                   pointer + pointer_step(item.key()), "one of its \"variables\"",
                   nearest_name(item.key(), names_of(inner.file.variables)));
    return false;
  }
  return true;
}

bool Expander::has_only(const json& step, const std::map<std::string, json::value_t>& known, const std::string& message,
                        const Scope& scope, const std::string& pointer) {
  std::string limit;
  for (const auto& [name, type] : known) limit += (limit.empty() ? "" : ", ") + name + ": " + json(type).type_name();
  for (const auto& [name, member] : step.items()) {
    const auto kind = known.find(name);
    if (name == "comment" || (kind != known.end() && kind->second == member.type())) continue;
    filler_.refuse(scope, message, pointer + pointer_step(name), limit);
    return false;
  }
  for (const auto& [name, type] : known) {
    if (step.contains(name)) continue;
    filler_.refuse(scope, message, pointer + pointer_step(name), limit);
    return false;
  }
  return true;
}

}  // namespace pelage::json_parts
