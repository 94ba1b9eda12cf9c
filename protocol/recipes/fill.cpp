#include "protocol/recipes/fill.h"

#include <cmath>

#include "protocol/json/parse.h"
#include "protocol/json/reader.h"
#include "protocol/recipes/expression.h"
#include "protocol/recipes/places.h"
#include "protocol/recipes/recipe.h"

namespace pelage::json_parts {

using nlohmann::json;

namespace {

constexpr std::size_t bytes_per_value = 16;             // bytes of text that count as one value
constexpr double max_exact_integer = 9007199254740992;  // 2^53

/// {"at": [...]} or {"at": [...], "by": [...]}. A colour ramp has an `at` too, which is a number.
bool is_place(const json& value) {
  return value.is_object() && value.contains("at") && value["at"].is_array() &&
         value.size() == (value.contains("by") ? 2u : 1u);
}

/// Returns a number as JSON. Whole numbers stay whole, as members that are integers need it.
json number_of(double value) {
  if (value == std::floor(value) && std::abs(value) <= max_exact_integer) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace

std::string dumped(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

json Filler::fill(const json& value, const Scope& scope, const std::string& pointer) {
  if (!status_.ok()) return {};
  ++values_;
  if (!within_value_limit(scope, pointer)) return {};
  if (value.is_string()) return fill_text(value.get_ref<const std::string&>(), scope, pointer);
  if (!value.is_structured()) return value;
  json copy = value.is_array() ? json::array() : json::object();
  if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k)
      copy.push_back(fill(value[k], scope, pointer + "/" + std::to_string(k)));
  } else {
    for (const auto& [name, member] : value.items()) {
      values_ += name.size() / bytes_per_value;
      copy[name] = fill(member, scope, pointer + pointer_step(name));
    }
  }
  return is_place(copy) ? place(copy, scope, pointer) : copy;
}

json Filler::refuse(const Scope& scope, const std::string& message, const std::string& pointer, std::string limit,
                    std::string nearest) {
  if (status_.ok()) status_ = refused_in(scope.file, message, pointer, std::move(limit), std::move(nearest));
  return {};
}

void Filler::refuse(const Scope& scope, const std::string& pointer, const Status& why) {
  if (!status_.ok()) return;
  status_ = why;
  status_.message.insert(0, scope.file.name + ": ");
  status_.pointer.insert(0, scope.file.pointer + pointer);
}

json Filler::fill_text(const std::string& text, const Scope& scope, const std::string& pointer) {
  values_ += text.size() / bytes_per_value;
  std::string filled;
  std::size_t at = 0;
  for (std::size_t begin; (begin = text.find("${", at)) != std::string::npos;) {
    const std::size_t end = text.find('}', begin);
    if (end == std::string::npos) return refuse(scope, "A \"${\" is not closed.", pointer, "${name}");
    const json value = variable_or_expression(text.substr(begin + 2, end - begin - 2), scope, pointer);
    if (begin == 0 && end + 1 == text.size()) return value;
    if (value.is_structured())
      return refuse(scope, "A list or an object cannot stand within a text.", pointer, "text or number");
    filled += text.substr(at, begin - at) + (value.is_string() ? value.get<std::string>() : dumped(value));
    at = end + 1;
    if (filled.size() > recipe_text_bytes)
      return refuse(scope, "The text is too long.", pointer, "at most " + std::to_string(recipe_text_bytes) + " bytes");
  }
  filled += text.substr(at);
  values_ += filled.size() / bytes_per_value;
  return filled;
}

/// Returns the variable of this name, which may be such as "a-b"; any other text is evaluated as an expression.
json Filler::variable_or_expression(const std::string& text, const Scope& scope, const std::string& pointer) {
  const bool is_variable = scope.given.contains(text) || scope.file.variables.contains(text);
  return is_variable || !is_expression(text) ? variable(text, scope, pointer) : expression(text, scope, pointer);
}

json Filler::variable(const std::string& name, const Scope& scope, const std::string& pointer) {
  if (const auto given = scope.given.find(name); given != scope.given.end()) return count(*given, scope, pointer);
  const auto own = scope.file.variables.find(name);
  if (own == scope.file.variables.end()) {
    std::vector<std::string_view> known = names_of(scope.file.variables);
    for (const std::string_view given_name : names_of(scope.given)) known.push_back(given_name);
    return refuse(scope, "There is no variable \"" + name + "\".", pointer, "one of \"variables\"",
                  nearest_name(name, known));
  }
  if (depth_ == recipe_variable_depth)
    return refuse(scope, "Variables are made of one another too deeply or in a circle.", pointer,
                  "at most " + std::to_string(recipe_variable_depth) + " deep");
  ++depth_;
  json value = fill(*own, scope, "/variables" + pointer_step(name));
  --depth_;
  return value;
}

json Filler::expression(const std::string& text, const Scope& scope, const std::string& pointer) {
  const auto value_of = [&](const std::string& name) -> Result<double> {
    const json value = variable(name, scope, pointer);
    if (!status_.ok()) return status_;
    if (value.is_number()) return value.get<double>();
    return failure(Code::invalid, "\"" + name + "\" is no number.");
  };
  const Result<double> value = evaluate(text, value_of);
  if (value) return number_of(*value);
  return refuse(scope, "\"" + text + "\" cannot be worked out. " + value.status().message, pointer,
                "+ - * / ( ) of numbers and variables");
}

/// Counts a value that is filled in already, each time that it is copied.
json Filler::count(const json& value, const Scope& scope, const std::string& pointer) {
  values_ += 1 + (value.is_primitive() && !value.is_string()
                      ? 0
                      : dumped(value).size() / (value.is_string() ? bytes_per_value : 2));
  return within_value_limit(scope, pointer) ? value : json();
}

bool Filler::within_value_limit(const Scope& scope, const std::string& pointer) {
  if (values_ <= recipe_values) return true;
  refuse(scope, "The steps are too much with their variables filled in.", pointer,
         "at most " + std::to_string(recipe_values) + " values");
  return false;
}

json Filler::place(const json& place, const Scope& scope, const std::string& pointer) {
  if (!is_triple(place["at"]) || (place.contains("by") && !is_triple(place["by"])))
    return refuse(scope, "A place is three shares of the model's box.", pointer, "[x, y, z]");
  json shares = place["at"];
  for (std::size_t k = 0; k < 3 && place.contains("by"); ++k)
    shares[k] = shares[k].get<double>() + place["by"][k].get<double>();
  return position_at(shares);
}

json Filler::position_at(const json& shares) const {
  json position = json::array();
  for (int k = 0; k < 3; ++k) {
    const double part = shares[static_cast<std::size_t>(k)].get<double>();
    position.push_back(box_.min[k] + part * (box_.max[k] - box_.min[k]));
  }
  return position;
}

json Filler::shares_of(const json& position) const {
  json shares = json::array();
  for (int k = 0; k < 3; ++k) {
    const double side = box_.max[k] - box_.min[k];
    shares.push_back(side > 0 ? (position[static_cast<std::size_t>(k)].get<double>() - box_.min[k]) / side : 0.0);
  }
  return shares;
}

}  // namespace pelage::json_parts
