// Numbers, words and lines of text formats. Numbers are rounded correctly to double, whatever the locale.
#pragma once

#include <optional>
#include <string_view>

namespace pelage {

/// The whole word as a number, with an optional sign; also "nan" and "inf". Overflow is an infinity, underflow 0.
std::optional<double> to_number(std::string_view word);

/// Takes the next word, ended by blanks or line ends, off the text; empty at the end.
std::string_view take_word(std::string_view& text);

/// Takes the next line, ended by LF, CR or both, off the text.
std::string_view take_line(std::string_view& text);

}  // namespace pelage
