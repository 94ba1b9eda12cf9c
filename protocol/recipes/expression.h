// Arithmetic expressions in recipes: "fur * 0.5", "-(a + b) / 2".
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

/// Returns whether a text is an expression, and not the name of a variable.
bool is_expression(std::string_view text);

/// Evaluates + - * / and parentheses over numbers and names, which are of letters, digits, _ and dots. Refuses
/// (invalid, without a pointer) anything else, nesting deeper than 32 and results that are not finite, and what
/// `value_of` refuses.
Result<double> evaluate(std::string_view text, const std::function<Result<double>(const std::string& name)>& value_of);

}  // namespace pelage
