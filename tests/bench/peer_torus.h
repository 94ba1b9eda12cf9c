// A furry torus that other renderers can draw as well: one light, a uniform environment, no ground, and the same fibre
// parameters for all strands.
#pragma once

#include <string>

#include "tests/support/furred_model.h"

namespace pelage::bench {

testing::FurredModel peer_torus();

/// A frame traced with path transport and the energy_conserving model, unfiltered.
FrameRequest peer_request(int size, int passes, std::uint32_t seed);

/// Writes what another renderer needs into a folder: scene.json (camera, light, environment, fibre, counts),
/// strands.bin (float32 for each point: x, y, z, radius, then sigma_a per radius for each channel) and skin.bin
/// (float32 positions, then uint32 vertex indices of the triangles). Lengths are in model sizes. Returns the number of
/// strands, or 0 if the files cannot be written.
std::size_t write_peer_scene(const testing::FurredModel& model, const FurFrame& frame, const std::string& folder);

}  // namespace pelage::bench
