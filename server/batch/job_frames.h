// Plans the frames of a job: the request, the scene's settings, the file and the fingerprint of each.
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

/// A rectangle of a frame that is drawn separately, into a file beside the frame's.
struct JobTile {
  int number = 1;  // from 1, row by row from the top left
  Crop crop;
  std::string file;
  std::string fingerprint;  // of the frame and the rectangle
};

/// What to draw at one moment in time.
struct JobMoment {
  FrameRequest request;
  std::vector<Command> settings;     // commands to run before drawing
  std::optional<ModelMoment> model;  // if the model moves
  // The job's limit on drawing a file. The request has no limit, so that no machine refuses a frame by its estimate.
  std::optional<double> max_seconds = {};
};

struct JobFrame {
  int number = 0;
  JobMoment moment;                            // at the frame's own time
  std::vector<JobMoment> shutter_moments;      // to average, while the shutter is open; empty if not blurred
  std::shared_ptr<const ModelMoments> motion;  // shared by all frames; null if the model does not move
  std::string file;
  std::string fingerprint;     // hash of all inputs of the picture, 32 hex digits
  std::vector<JobTile> tiles;  // empty if the frame is drawn at once
};

/// The part of a job that one process draws.
struct JobPart {
  std::string frames = {};  // "" for all of the job's
  std::string output = {};  // replaces the job's; "" for the job's
  int tile = 0;             // number of the tile of each frame; 0 for all
};

/// Returns the checked frames of the part, in the order in which it lists them. `folder` is the folder of the job's
/// file. Refused (invalid) with a pointer into the job or to the parameter; "/frames" for a frame that the job does not
/// have, "/tiles" for a missing tile. Each frame lists all of its tiles, also if the part is only one.
Result<std::vector<JobFrame>> plan_job(const RenderJob& job, const JobPart& part, const std::string& folder,
                                       const Scene& scene);

}  // namespace pelage
