// A furry torus that other renderers can draw as well: one light, even light from all around, no ground, and one way to
// scatter light for all strands.
#pragma once

#include <string>

#include "tests/support/furred_model.h"

namespace pelage::bench {

testing::FurredModel peer_torus();

/// Traced in paths, by energy_conserving, unfiltered.
FrameRequest peer_request(int size, int passes, std::uint32_t seed);

/// What another renderer needs, into a folder: scene.json (camera, light, environment, fibre, counts), strands.bin
/// (float32 for each point: x, y, z, radius, then sigma_a per radius by channel) and skin.bin (float32 positions, then
/// uint32 corners). Lengths in sizes. How many strands there are is answered; 0 where files cannot be written.
std::size_t write_peer_scene(const testing::FurredModel& model, const FurFrame& frame, const std::string& folder);

}  // namespace pelage::bench
