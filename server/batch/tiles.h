// Frames in tiles: what each draws, and the whole that they become.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "server/batch/job_frames.h"
#include "server/scene/scene.h"

namespace pelage {

/// The tiles of a frame, whose file and fingerprint are known. Refused (invalid) where they are more than its pixels,
/// and where the frame has a crop, or an end that depends on the machine.
Result<std::vector<JobTile>> tiles_of(const TileGrid& grid, const JobFrame& frame);

/// Writes the frame's file once the files of all tiles are there, with the same bytes as without tiles (of an EXR but
/// for the time), and removes them. Returns whether it did. Any number of processes may try at a time. Fails as
/// write_whole.
Result<bool> merge_tiles(const JobFrame& frame, const SceneSummary& scene, double fps);

/// Removes the tiles of a frame that is whole.
void remove_tiles(const JobFrame& frame);

}  // namespace pelage
