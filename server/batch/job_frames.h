// What each frame of a job is: its request, the settings of its scene, its file and its fingerprint.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "server/batch/model_moments.h"
#include "server/batch/output_pattern.h"
#include "server/scene/scene.h"

namespace pelage {

/// A part of a frame that is drawn by itself into a file beside the frame's.
struct JobTile {
  int number = 1;  // from 1, row by row from the top left
  Crop crop;
  std::string file;
  std::string fingerprint;  // of the frame and of the part
};

/// What is drawn at one moment.
struct JobMoment {
  FrameRequest request;
  std::vector<Command> settings;     // run before it is drawn
  std::optional<ModelMoment> model;  // where the model moves
  // The job's limit on drawing a file. The request has none of its own: what a machine expects refuses no frame of a
  // job.
  std::optional<double> max_seconds = {};
};

struct JobFrame {
  int number = 0;
  JobMoment moment;                            // its own
  std::vector<JobMoment> open;                 // moments of the open shutter to average; none where it is sharp
  std::shared_ptr<const ModelMoments> motion;  // of all frames; null where the model stays
  std::string file;
  std::string fingerprint;     // of all that the picture follows from, 32 hex digits
  std::vector<JobTile> tiles;  // that it is drawn in; none where it is drawn at once
};

/// Which part of a job one process draws.
struct JobPart {
  std::string frames = {};  // "" for all of the job's
  std::string output = {};  // in place of the job's; "" for that
  int tile = 0;             // of each frame; 0 for all
};

/// The frames of the part, in the order in which they are named, all of them checked. `folder` is where the job's file
/// lies. Refused (invalid) with the pointer into the job or the parameter; a frame of the part that the job does not
/// have, with "/frames"; a tile, with "/tiles". Each frame names all of its tiles, whatever the part.
Result<std::vector<JobFrame>> plan_job(const RenderJob& job, const JobPart& part, const std::string& folder,
                                       const Scene& scene);

}  // namespace pelage
