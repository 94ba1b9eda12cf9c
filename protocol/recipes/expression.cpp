#include "protocol/recipes/expression.h"

#include <cctype>
#include <charconv>
#include <cmath>

namespace pelage {

namespace {

constexpr int max_depth = 32;

bool is_name_byte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

/// Parses the text in one pass. It stores the first refusal, and after it every value is 0.
class Parser {
 public:
  Parser(std::string_view text, const std::function<Result<double>(const std::string&)>& value_of)
      : remaining_(text), value_of_(value_of) {}

  Result<double> parse() {
    const double value = sum();
    if (next() != '\0') refuse("\"" + std::string(remaining_) + "\" is left over.");
    if (!std::isfinite(value)) refuse("It is no finite number.");
    return status_.ok() ? Result<double>(value) : status_;
  }

 private:
  double sum() {
    double value = product();
    for (char c; (c = next()) == '+' || c == '-';) {
      remaining_.remove_prefix(1);
      value += c == '+' ? product() : -product();
    }
    return value;
  }

  double product() {
    double value = factor();
    for (char c; (c = next()) == '*' || c == '/';) {
      remaining_.remove_prefix(1);
      const double other = factor();
      value = c == '*' ? value * other : value / other;
    }
    return value;
  }

  double factor() {
    const char c = next();
    if (c == '-' || c == '(') {
      remaining_.remove_prefix(1);
      if (++depth_ > max_depth) return refuse("It is nested too deeply.");
      const double value = c == '-' ? -factor() : sum();
      --depth_;
      if (c == '(' && next() != ')') return refuse("A \"(\" is not closed.");
      if (c == '(') remaining_.remove_prefix(1);
      return value;
    }
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.' ? number() : name();
  }

  double number() {
    double value = 0;
    const auto [end, error] = std::from_chars(remaining_.data(), remaining_.data() + remaining_.size(), value);
    if (error != std::errc()) return refuse("\"" + std::string(remaining_) + "\" begins with no number.");
    remaining_.remove_prefix(static_cast<std::size_t>(end - remaining_.data()));
    return value;
  }

  double name() {
    std::size_t size = 0;
    while (size < remaining_.size() && is_name_byte(remaining_[size])) ++size;
    if (size == 0) return refuse("A number or a name is missing.");
    const Result<double> value =
        status_.ok() ? value_of_(std::string(remaining_.substr(0, size))) : Result<double>(0.0);
    remaining_.remove_prefix(size);
    if (!value && status_.ok()) status_ = value.status();
    return value ? *value : 0;
  }

  /// Skips blanks and returns the next character; 0 at the end and after a refusal.
  char next() {
    if (!status_.ok()) remaining_ = {};
    remaining_.remove_prefix(std::min(remaining_.find_first_not_of(' '), remaining_.size()));
    return remaining_.empty() ? '\0' : remaining_.front();
  }

  double refuse(const std::string& message) {
    if (status_.ok()) status_ = failure(Code::invalid, message);
    return 0;
  }

  std::string_view remaining_;
  const std::function<Result<double>(const std::string&)>& value_of_;
  int depth_ = 0;
  Status status_;
};

}  // namespace

bool is_expression(std::string_view text) { return text.find_first_of("+-*/()") != std::string_view::npos; }

Result<double> evaluate(std::string_view text, const std::function<Result<double>(const std::string& name)>& value_of) {
  return Parser(text, value_of).parse();
}

}  // namespace pelage
