// Reads the files with the poses of a job's model, through the confined worker. A refusal names the file
// ("/motion/model").
#pragma once

#include <functional>
#include <vector>

#include "base/status.h"
#include "server/batch/job_frames.h"
#include "server/batch/job_scene.h"
#include "server/batch/model_moments.h"

namespace pelage {

/// Returns the model at the moment, interpolated if that is between two files. Also refused (invalid) if the file does
/// not have another pose of the scene's model (MovingModel::check).
Result<RawModel> read_model(const MovingModel& moving, const ModelMoment& moment);

/// Checks each file that the frames depend on by reading it once; of an animation it reads only one moment. Fails
/// (unavailable) once `stopped` returns true.
Status check_models(const JobScene& scene, const std::vector<JobFrame>& frames, const std::function<bool()>& stopped);

}  // namespace pelage
