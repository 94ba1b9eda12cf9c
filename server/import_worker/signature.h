// Recognizes files by their first bytes, whatever their names.
#pragma once

#include <string_view>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

/// Refuses (invalid) bytes that are recognized as something else than a model of that format: another format, a
/// picture, an archive, a web page. The reason says what they are and what to do with them. Bytes that are not
/// recognized pass.
Status check_signature(ModelFormat format, std::string_view bytes);

/// Returns the text without the byte order mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace pelage
