#include "protocol/json/parse.h"

#include <cctype>
#include <vector>

#include "base/limits.h"

namespace pelage {

namespace {

using nlohmann::json;

/// Builds the tree while the text is parsed, to notice duplicate keys and too deep nesting at once.
class TreeBuilder {
 public:
  json take_root() { return std::move(root_); }
  const Status& failure_found() const { return failure_; }

  bool null() { return insert(nullptr) != nullptr; }
  bool boolean(bool value) { return insert(value) != nullptr; }
  bool number_integer(json::number_integer_t value) { return insert(value) != nullptr; }
  bool number_unsigned(json::number_unsigned_t value) { return insert(value) != nullptr; }
  bool number_float(json::number_float_t value, const std::string&) { return insert(value) != nullptr; }
  bool string(std::string& value) { return insert(std::move(value)) != nullptr; }
  bool binary(json::binary_t&) { return false; }
  bool start_object(std::size_t) { return push(json::object()); }
  bool end_object() { return pop(); }
  bool start_array(std::size_t) { return push(json::array()); }
  bool end_array() { return pop(); }

  bool key(std::string& name) {
    key_ = name;
    if (!stack_.back()->contains(name)) return true;
    failure_ = failure(Code::malformed, "The name \"" + name + "\" is given twice.", pointer() + pointer_step(name),
                       "each name once");
    return false;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    const std::string text = error.what();
    const bool overflow = error.id == 406;
    failure_ = failure(Code::malformed,
                       overflow ? "A number overflows a double, at byte " + std::to_string(position) + "."
                                : "The body is not JSON: " + text.substr(text.find("] ") + 2),
                       pointer(), overflow ? "finite double" : "");
    return false;
  }

 private:
  json* insert(json value) {
    if (stack_.empty()) return &(root_ = std::move(value));
    json& parent = *stack_.back();
    if (parent.is_object()) return &(parent[key_] = std::move(value));
    parent.push_back(std::move(value));
    return &parent.back();
  }

  bool push(json value) {
    if (stack_.size() >= static_cast<std::size_t>(limits::json_depth)) {
      failure_ = failure(Code::malformed, "The body is nested too deeply.", "",
                         "at most " + std::to_string(limits::json_depth) + " levels");
      return false;
    }
    steps_.push_back(step());
    stack_.push_back(insert(std::move(value)));
    return true;
  }

  bool pop() {
    stack_.pop_back();
    steps_.pop_back();
    return true;
  }

  /// Returns the JSON pointer step from the innermost open value to the value that comes next.
  std::string step() const {
    if (stack_.empty()) return {};
    return stack_.back()->is_object() ? pointer_step(key_) : "/" + std::to_string(stack_.back()->size());
  }

  std::string pointer() const {
    std::string text;
    for (const std::string& part : steps_) text += part;
    return text;
  }

  json root_;
  std::vector<json*> stack_;        // the innermost is last; a parent does not move while a child is open
  std::vector<std::string> steps_;  // the JSON pointer step to each open value
  std::string key_;
  Status failure_;
};

}  // namespace

std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char c : key) {
    if (c == '~')
      step += "~0";
    else if (c == '/')
      step += "~1";
    else
      step += c;
  }
  return step;
}

std::string as_json_number(std::string_view text) {
  const auto is_digit = [text](std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
  };
  const std::size_t first = text.starts_with('+') || text.starts_with('-') ? 1 : 0, point = text.find('.');
  if (!is_digit(first) && !(point == first && is_digit(point + 1))) return std::string(text);
  std::string number = text.starts_with('-') ? "-" : "";
  if (point == first) number += '0';
  const bool ends_in_point = point != std::string_view::npos && point + 1 == text.size();
  return number.append(text.substr(first, text.size() - first - (ends_in_point ? 1 : 0)));
}

Result<json> parse_json(std::string_view text) {
  TreeBuilder builder;
  const bool done = json::sax_parse(text.begin(), text.end(), &builder);
  if (!done) return builder.failure_found();
  return builder.take_root();
}

}  // namespace pelage
