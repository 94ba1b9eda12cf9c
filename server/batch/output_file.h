// Writes the files of a farm atomically, and recognizes them by their metadata.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "renderer/image/image.h"
#include "server/batch/job_frames.h"
#include "server/frames/frame_service.h"

namespace pelage {

/// Writes a file under a temporary name in the same folder, which is made if it is missing, then syncs and renames it.
/// A failure (internal, with the system's reason) leaves no file.
Status write_atomically(const std::string& path, std::string_view bytes);

/// Checks that a file can be made in the path's folder or, if that is missing, in its nearest parent that exists.
/// Leaves no file. Fails as write_atomically.
Status check_folder_writable(const std::string& path);

/// Returns whether the file is a complete picture with this fingerprint.
bool is_drawn(const std::string& path, const std::string& fingerprint);

/// Keys in the metadata of a frame's file.
inline constexpr const char* fingerprint_key = "pelage/fingerprint";
inline constexpr const char* quality_key = "pelage/quality";
inline constexpr const char* render_time_key = "pelage/renderTime";  // seconds; EXR only

/// Returns the metadata of a frame's file. `quality` is the JSON of the knobs that it was drawn with, `scene` the scene
/// before keyframes, `seconds` the drawing time. Only an EXR has the drawing time, the date and the machine; a PNG has
/// the same bytes whenever it is drawn.
std::vector<ImageText> metadata_of(const JobFrame& frame, const std::string& quality, const SceneSummary& scene,
                                   double fps, double seconds);

}  // namespace pelage
