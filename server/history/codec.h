// Changes of fields as bytes, for the journal and the undo log. Little-endian.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "server/fields/field_delta.h"
#include "server/patches/subdivide.h"
#include "server/surface/prepare.h"

namespace pelage {

/// Encodes a delta. Writes for each field that changes: its number, the count, the gaps between vertices as
/// variable-length numbers, then the flips as 32-bit words. A combed vertex takes 9 to 11 bytes.
std::string encode_delta(const FieldDelta& delta);

/// Refused (internal) unless the bytes are a whole delta of rising fields and vertices.
Result<FieldDelta> decode_delta(std::span<const std::byte> bytes);

// Subdivisions of a model as bytes, for the journal. Little-endian.

/// Encodes subdivisions. Writes for each one the count of its runs, then the begin and end of each run, as 32-bit
/// words.
std::string encode_subdivisions(const std::vector<ChosenTriangles>& subdivisions);

/// Refused (internal) unless the bytes are whole subdivisions of rising runs.
Result<std::vector<ChosenTriangles>> decode_subdivisions(std::span<const std::byte> bytes);

/// Encodes the degrees of creases and the numbers of flipped parts, then after a slash the numbers of two-sided parts,
/// separated by blanks. "" stands for the defaults. Decoding returns false for any other text that was not encoded like
/// this.
std::string encode_creases_and_flips(const PrepareOptions& options);
bool decode_creases_and_flips(std::string_view text, PrepareOptions& options);

// Pictures as they are stored.

/// Returns the number of bytes as 64 bits, then a zlib stream of them.
std::string compress_bytes(std::string_view bytes);
/// Refused (internal) unless they are what compress_bytes made.
Result<std::string> decompress_bytes(std::string_view stored);

}  // namespace pelage
