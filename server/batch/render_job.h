// The batch renderer: draws a job's frames, one after another, to files.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/limits.h"
#include "base/status.h"
#include "protocol/commands/job.h"
#include "renderer/gl/context/context.h"
#include "server/batch/farm_log.h"
#include "server/batch/job_frames.h"
#include "server/batch/job_scene.h"
#include "server/batch/pose_history.h"
#include "server/frames/picture_service.h"

namespace pelage {

struct DrawOptions {
  GlChoice gl = GlChoice::automatic;
  std::optional<int> device = {};  // number of the EGL device, if there are several GPUs
  int threads = 0;                 // 0 for all cores
  bool skip_existing = false;      // skips frames and tiles whose file has their fingerprint
  int tile = 0;                    // number of the tile of each frame; 0 for all
};

/// The pointer in the failure of a frame that takes too long.
inline constexpr const char* limit_pointer = "/frame/max_seconds";

/// Numbers of files, of frames or of their tiles.
struct JobOutcome {
  std::size_t drawn = 0, skipped = 0;
};

/// Draws the frames of a job, one at a time.
class JobRenderer {
 public:
  /// Fails (unavailable) as FrameService::start. The scene must outlive the renderer.
  static Result<std::unique_ptr<JobRenderer>> start(const JobScene& scene, double fps, const DrawOptions& options);

  /// Draws all frames, or their tiles, and reports them in the log. The process that draws the last tile of a frame
  /// writes the frame's file (merge_tiles). Ends at the first failure: unavailable with limit_pointer for a file that
  /// takes longer than the job allows, unavailable once `stopped` returns true. Each file is then complete or missing.
  Result<JobOutcome> draw(const std::vector<JobFrame>& frames, FarmLog& log, const std::function<bool()>& stopped);

  /// Draws one frame without a file, and returns the seconds that it took; those of a frame with tiles are estimated
  /// from the tile in the middle.
  Result<double> measure(const JobFrame& frame, const std::function<bool()>& stopped);

 private:
  JobRenderer(const JobScene& scene, double fps, const DrawOptions& options, std::unique_ptr<FrameService> frames,
              std::unique_ptr<YieldGate> gate);
  /// A region of a frame that has a file of its own: a tile, or the full frame if it has no tiles.
  struct Region {
    const JobFrame& frame;
    const std::string& file;
    std::string fingerprint;
    std::optional<Crop> crop;

    FrameRequest request_at(const JobMoment& moment) const {
      FrameRequest request = moment.request;
      request.crop = crop, request.max_seconds = limits::frame_seconds;
      return request;
    }
  };
  static Region frame_region(const JobFrame& frame);
  static Region tile_region(const JobFrame& frame, const JobTile& tile);
  std::vector<Region> regions_of(const std::vector<JobFrame>& frames) const;
  bool is_there(const Region& region) const;
  /// Writes the file of a region.
  using Save = std::function<Status()>;
  /// Draws a region; fails as drawing all frames does.
  Result<Save> draw(const Region& region, const std::function<bool()>& stopped);
  /// Encodes the file of a region that has been drawn.
  using Encode = std::function<FrameAnswer()>;
  Result<Encode> picture(const Region& region, const std::function<bool()>& stopped);
  /// Draws the mean of the moments at which the shutter is open.
  Result<PictureService::Encode> mean_picture(const Region& region, const FrameRequest& request,
                                              const std::function<bool()>& stopped);
  Result<LinearPicture> blurred(const Region& region, const std::function<bool()>& stopped);

  /// Sets the scene's settings and pose to a moment of the frame.
  Status prepare(const JobFrame& frame, const JobMoment& moment);
  Status set_pose(const JobFrame& frame, const ModelMoment& model);
  Result<BodySwing> swing_of(const JobFrame& frame);

  const JobScene& job_scene_;
  std::shared_ptr<Scene> scene_;
  std::optional<MovingModel> moving_;   // set once a frame's model moves
  std::optional<PoseHistory> history_;  // set once a frame has inertia
  std::uint64_t pose_model_id_ = 0;     // id of the model of the last pose
  const SceneSummary summary_;          // of the scene before keyframes
  const double fps_;
  const DrawOptions options_;
  std::unique_ptr<YieldGate> gate_;
  std::unique_ptr<FrameService> frames_;
  TraceQueue traces_;
  PictureService pictures_;
};

}  // namespace pelage
