// The files that a job's model moves by, read through the confined worker. A refusal names the file ("/motion/model").
#pragma once

#include <functional>
#include <vector>

#include "base/status.h"
#include "server/batch/job_frames.h"
#include "server/batch/job_scene.h"
#include "server/batch/model_moments.h"

namespace pelage {

/// Returns the model at the moment; between two files it is interpolated. Also refused (invalid) where it is not the
/// model at rest elsewhere.
Result<RawModel> read_model(const MovingModel& moving, const ModelMoment& moment);

/// Reads each file that the frames follow from once, an animation at one moment of it. Ends (unavailable) once
/// `stopped` says so.
Status check_models(const JobScene& scene, const std::vector<JobFrame>& frames, const std::function<bool()>& stopped);

}  // namespace pelage
