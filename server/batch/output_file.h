// The files of a farm: whole or not there, and known by what they say of themselves.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"
#include "renderer/image/image.h"
#include "server/batch/job_frames.h"
#include "server/frames/frame_service.h"

namespace pelage {

/// Writes a file under a temporary name in the same folder, which is made where it is missing, then syncs and renames
/// it. A failure (internal, with the system's reason) leaves nothing.
Status write_whole(const std::string& path, std::string_view bytes);

/// Returns whether a file can be made in the path's folder, or in the one where that will be made. Leaves nothing;
/// fails as write_whole.
Status try_folder_of(const std::string& path);

/// Returns whether the file is a whole picture with this fingerprint.
bool is_drawn(const std::string& path, const std::string& fingerprint);

/// Keys of what a frame's file says of it.
inline constexpr const char* fingerprint_text = "pelage/fingerprint";
inline constexpr const char* quality_text = "pelage/quality";
inline constexpr const char* render_time_text = "pelage/renderTime";  // seconds; of an EXR

/// What a frame's file says of it. `quality`: the knobs that it was drawn with, JSON. `scene` is as it was before
/// keyframes; `seconds` is what drawing took. An EXR has
/// these, the time and the machine too; a PNG has the same bytes whenever it is drawn.
std::vector<ImageText> texts_of(const JobFrame& frame, const std::string& quality, const SceneSummary& scene,
                                double fps, double seconds);

}  // namespace pelage
