// Changes of fields as bytes, for the journal and the undo log. Little-endian.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "protocol/base/status.h"
#include "server/fields/field_delta.h"

namespace pelage {

/// For each field that changes: its number, the count, the gaps between vertices as variable-length numbers, then the
/// flips as 32-bit words. A combed vertex takes 9 to 11 bytes.
std::string encode_delta(const FieldDelta& delta);

/// Refused (internal) unless the bytes are a whole delta of rising fields and vertices.
Result<FieldDelta> decode_delta(std::span<const std::byte> bytes);

}  // namespace pelage
