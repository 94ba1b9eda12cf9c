// Encodes field changes, subdivisions, preparation options and pictures for the journal and the undo log.
// Little-endian.
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

/// Encodes a delta: for each changed field its number, the count of vertices, the gaps between vertices as
/// variable-length numbers, then the bit flips as 32-bit words. A combed vertex takes 9 to 11 bytes.
std::string encode_delta(const FieldDelta& delta);

/// Decodes a delta. Fails (internal) unless the bytes are one complete delta with fields and vertices in rising order.
Result<FieldDelta> decode_delta(std::span<const std::byte> bytes);

// Subdivisions of a model.

/// Encodes subdivisions: for each one the count of its runs, then the begin and end of each run, as 32-bit words.
std::string encode_subdivisions(const std::vector<ChosenTriangles>& subdivisions);

/// Decodes subdivisions. Fails (internal) unless the bytes are complete subdivisions with runs in rising order.
Result<std::vector<ChosenTriangles>> decode_subdivisions(std::span<const std::byte> bytes);

/// Encodes the crease angle in degrees, the numbers of flipped parts, then after a slash the numbers of two-sided
/// parts, separated by blanks. "" stands for the defaults. Decoding returns false for text that was not encoded like
/// this.
std::string encode_creases_and_flips(const PrepareOptions& options);
bool decode_creases_and_flips(std::string_view text, PrepareOptions& options);

// Compression of pictures.

/// Returns the number of bytes as a 64-bit integer, followed by a zlib stream of the bytes.
std::string compress_bytes(std::string_view bytes);
/// Inverts compress_bytes. Fails (internal) for anything that it did not make.
Result<std::string> decompress_bytes(std::string_view stored);

}  // namespace pelage
