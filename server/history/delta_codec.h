// Changes of fields as octets, for the journal. Little-endian.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "protocol/base/status.h"
#include "server/fields/field_set.h"

namespace pelage {

/// The count, the gaps between vertices as variable-length numbers, then `before` and `after` as 32-bit words.
std::string encode_delta(const FieldDelta& delta);

/// Refused (internal) unless the octets are a whole delta of rising vertices.
Result<FieldDelta> decode_delta(std::span<const std::byte> octets);

}  // namespace pelage
