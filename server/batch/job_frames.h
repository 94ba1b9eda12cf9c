// What each frame of a job is: its request, the settings of its scene, its file and its fingerprint.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/job.h"
#include "server/batch/model_moments.h"
#include "server/batch/output_pattern.h"
#include "server/scene/scene.h"

namespace pelage {

struct JobFrame {
  int number = 0;
  FrameRequest request;
  std::vector<Command> settings;                // run before it is drawn
  std::optional<ModelMoment> model;             // where the model moves
  std::shared_ptr<const ModelMoments> moments;  // of all frames; null where `model` is none
  std::string file;
  std::string fingerprint;  // of all that the picture follows from, 32 hex digits
};

/// Which part of a job one process draws.
struct JobPart {
  std::string frames = {};  // "" for all of the job's
  std::string output = {};  // in place of the job's; "" for that
};

/// The frames of the part, in the order in which they are named, all of them checked. `folder` is where the job's file
/// lies. Refused (invalid) with the pointer into the job or the parameter; a frame of the part that the job does not
/// have, with "/frames".
Result<std::vector<JobFrame>> plan_job(const RenderJob& job, const JobPart& part, const std::string& folder,
                                       const Scene& scene);

}  // namespace pelage
