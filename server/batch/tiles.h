// Splits frames into tiles, and merges the files of tiles.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "server/batch/job_frames.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the tiles of a frame, whose file and fingerprint must be set. Refused (invalid) if there are more columns or
/// rows than pixels, or if the frame has a crop or a time budget, with which tiles would not fit together.
Result<std::vector<JobTile>> tiles_of(const TileGrid& grid, const JobFrame& frame);

/// If the files of all tiles exist with their fingerprints, writes the frame's file, with the same bytes as without
/// tiles (except the times in an EXR), removes the tiles and returns true. Any number of processes may try at the same
/// time. Fails as write_atomically.
Result<bool> merge_tiles(const JobFrame& frame, const SceneSummary& scene, double fps);

/// Removes the files of the tiles of a complete frame.
void remove_tiles(const JobFrame& frame);

}  // namespace pelage
