// Sums and products of numbers, as recipes write them: "fur * 0.5", "-(a + b) / 2".
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Returns whether a text is an expression, and not the name of a variable.
bool is_expression(std::string_view text);

/// + - * / and parentheses over numbers and names: letters, digits, _ and dots. Refused (invalid, without a pointer)
/// where it is no such thing, deeper than 32 or not finite, and as `value_of` refuses.
Result<double> evaluate(std::string_view text, const std::function<Result<double>(const std::string& name)>& value_of);

}  // namespace pelage
