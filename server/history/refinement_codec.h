// Refinements of a model as bytes, for the journal. Little-endian.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "protocol/base/status.h"
#include "server/patches/subdivide.h"

namespace pelage {

/// For each refinement the count of its runs, then where each begins and ends, as 32-bit words.
std::string encode_refinements(const std::vector<ChosenTriangles>& refinements);

/// Refused (internal) unless the bytes are whole refinements of rising runs.
Result<std::vector<ChosenTriangles>> decode_refinements(std::span<const std::byte> bytes);

}  // namespace pelage
