#include "server/batch/job_frames.h"

#include <cmath>
#include <optional>
#include <unordered_map>
#include <variant>

#include "base/version/version.h"
#include "protocol/json/animation.h"
#include "protocol/json/encode.h"
#include "server/batch/frame_range.h"
#include "server/batch/tiles.h"
#include "server/batch/turntable.h"
#include "server/scene/digest.h"

namespace pelage {

namespace {

/// Returns the revisions from the scene's first one to its present one, without those that were undone.
std::vector<Revision> revisions_of(const Scene& scene) {
  std::vector<Revision> revisions;
  const std::vector<LogEntry> log = scene.log();
  revisions.push_back(log.empty() ? scene.summary().revision : log.front().revision - 1);
  for (const LogEntry& entry : log) {
    if (entry.in_effect) revisions.push_back(entry.revision);
  }
  return revisions;
}

/// Returns a text with all inputs of the scene's pictures, except the requests.
std::string identity_of(const Scene& scene) {
  const SceneSummary summary = scene.summary();
  std::string identity = std::string(version()) + "\n" + summary.model_id + "\n" + summary.fur_patches + "\n" +
                         to_hex(summary.fields_hash) + "\n";
  identity += encode(SettingsAnswer{.settings = scene.snapshot()->view().settings});
  return identity;
}

std::string identity_of(const JobMoment& moment) {
  std::string text = encode(moment.request) + "\n";
  for (const Command& command : moment.settings) text += encode(command) + "\n";
  if (moment.model) text += moment.model->digest + "\n" + moment.model->pose + "\n";
  return text;
}

Status check_blur(const FrameRequest& request) {
  const auto refused = [](const char* pointer, const char* limit) {
    return failure(Code::invalid, "A frame with motion_blur is the mean of several pictures.", pointer, limit);
  };
  if (request.budget_ms) return refused("/frame/budget_ms", "quality or max_error");
  if (request.overlay != Overlay::none) return refused("/frame/overlay", "none");
  if (request.knobs.trace.shutter > 0) return refused("/frame/quality/trace/shutter", "0");
  return {};
}

/// Sets the tracing of picture `k` of the `count` pictures whose mean is a frame: together they have the requested
/// passes, noise and seconds. Each has another seed.
void share_passes(int count, int k, Tracing& trace) {
  trace.passes = (trace.passes + count - 1) / count;
  trace.noise = std::min(1.0, trace.noise * std::sqrt(count));
  trace.seconds /= count;
  trace.seed += static_cast<std::uint32_t>(k);
}

/// Plans frames one by one.
class Planner {
 public:
  Planner(const RenderJob& job, const Scene& scene, Animation animation, OutputPattern pattern,
          std::shared_ptr<const ModelMoments> moments)
      : job_(job),
        scene_(scene),
        animation_(std::move(animation)),
        pattern_(std::move(pattern)),
        moments_(std::move(moments)),
        model_(scene.model()),
        identity_(identity_of(scene)) {
    settings_ = scene.snapshot()->view().settings;
    if (!job.time_lapse) return;
    revisions_ = revisions_of(scene);
    identity_ += encode(Log{scene.log()});
  }

  /// The position of a frame in the job.
  struct FramePosition {
    std::size_t index = 0, count = 1;  // number of frames before it, and of all frames
    double spacing = 1;                // mean difference of the numbers of adjacent frames
  };

  Result<JobFrame> frame(int number, const FramePosition& position) const {
    Result<JobMoment> own = moment(number, static_cast<double>(position.index) / static_cast<double>(position.count));
    if (!own) return own.status();
    if (job_.time_lapse) own->request.revision = revision_at(position.index, position.count);
    JobFrame frame{.number = number,
                   .moment = std::move(*own),
                   .shutter_moments = {},
                   .motion = moments_,
                   .file = pattern_.file(number),
                   .fingerprint = {},
                   .tiles = {}};
    if (Status opened = open_shutter(frame, position); !opened.ok()) return opened;
    const Result<std::string> swing = moments_ ? moments_->identity_of_swing(number) : std::string();
    if (!swing) return swing.status();
    frame.fingerprint = fingerprint_of(frame, *swing);
    if (job_.tiles) {
      Result<std::vector<JobTile>> tiles = tiles_of(*job_.tiles, frame);
      if (!tiles) return tiles.status();
      frame.tiles = std::move(*tiles);
    }
    return frame;
  }

 private:
  Status take_format(FrameRequest& request) const {
    if (request.progressive)
      return failure(Code::invalid, "A file holds one picture; ask for the quality `reference` instead.",
                     "/frame/progressive", "not in a job");
    if (request.revision && job_.time_lapse)
      return failure(Code::invalid, "A time lapse chooses the revisions.", "/frame/revision", "without time_lapse");
    const bool exr = pattern_.format() == FrameFormat::exr, deep = request.format == FrameFormat::png16;
    if ((exr && request.format != FrameFormat::exr && request.format != FrameFormat::png) ||
        (!exr && request.format != FrameFormat::png && !deep))
      return failure(Code::invalid, "The format does not fit the ending of `output`.", "/frame/format",
                     exr ? "exr" : "png or png16");
    if (exr) request.format = FrameFormat::exr;
    request.view.clear();
    return {};
  }

  /// Returns what to draw at a time in frames. `share` is the part of the turntable's turn that has passed, [0, 1).
  Result<JobMoment> moment(double number, double share) const {
    Result<AnimatedFrame> animated = animation_.at(number);
    if (!animated) return animated.status();
    std::optional<double>& time = animated->request.time;
    if (!time) time = number / job_.fps;
    if (Status format = take_format(animated->request); !format.ok()) return format;
    if (job_.turntable) apply_turntable(*animated, share);
    JobMoment made{.request = std::move(animated->request), .settings = std::move(animated->settings), .model = {}};
    if (animation_.limits_seconds()) made.max_seconds = made.request.max_seconds;
    made.request.max_seconds = FrameRequest().max_seconds;  // keeps it out of the fingerprint
    if (!moments_) return made;
    Result<ModelMoment> model = moments_->at(number);
    if (!model) return model.status();
    made.model = std::move(*model);
    return made;
  }

  Status open_shutter(JobFrame& frame, const FramePosition& position) const {
    if (!job_.motion_blur) return {};
    const MotionBlur& blur = *job_.motion_blur;
    if (Status refused = check_blur(frame.moment.request); !refused.ok()) return refused;
    for (int k = 0; k < blur.samples; ++k) {
      const double later = blur.shutter * ((k + 0.5) / blur.samples - 0.5);
      const double index = static_cast<double>(position.index) + later / position.spacing;
      Result<JobMoment> made = moment(frame.number + later, index / static_cast<double>(position.count));
      if (!made) return made.status();
      share_passes(blur.samples, k, made->request.knobs.trace);
      frame.shutter_moments.push_back(std::move(*made));
    }
    return {};
  }

  void apply_turntable(AnimatedFrame& frame, double share) const {
    const bool model_turns = job_.turntable->turns == Turning::model;
    const double degrees = (model_turns ? -1 : 1) * job_.turntable->degrees * share;
    FrameRequest& request = frame.request;
    const double aspect = static_cast<double>(request.width) / request.height;
    request.camera = turned_camera(request.camera, aspect, model_->surface.mesh(), degrees);
    if (!model_turns) return;
    SceneSettings now = settings_;
    for (const Command& command : frame.settings) {
      if (const auto* lights = std::get_if<SetLights>(&command)) now.lights = lights->lights;
      if (const auto* environment = std::get_if<SetEnvironment>(&command)) now.environment = environment->environment;
    }
    frame.settings.emplace_back(SetLights{turned_lights(now.lights, request.camera.target, degrees)});
    frame.settings.emplace_back(SetEnvironment{turned_environment(now.environment, degrees)});
  }

  /// Returns the revision of a time lapse's frame. The last frame shows the last revision.
  Revision revision_at(std::size_t index, std::size_t count) const {
    const double share = count > 1 ? static_cast<double>(index) / static_cast<double>(count - 1) : 1;
    return revisions_[static_cast<std::size_t>(std::lround(share * static_cast<double>(revisions_.size() - 1)))];
  }

  std::string fingerprint_of(const JobFrame& frame, const std::string& swing) const {
    std::string text = identity_ + "\n" + identity_of(frame.moment) + swing;
    for (const JobMoment& moment : frame.shutter_moments) text += "\n" + identity_of(moment);
    return digest(text);
  }

  const RenderJob& job_;
  const Scene& scene_;
  const Animation animation_;
  const OutputPattern pattern_;
  const std::shared_ptr<const ModelMoments> moments_;
  const std::shared_ptr<const SceneModel> model_;
  SceneSettings settings_;
  std::vector<Revision> revisions_;
  std::string identity_;
};

Result<std::vector<JobFrame>> plan_frames(const Planner& planner, const std::vector<int>& all,
                                          const std::vector<int>& wanted, const std::string& range) {
  std::unordered_map<int, std::size_t> order;
  for (std::size_t index = 0; index < all.size(); ++index) order[all[index]] = index;
  Planner::FramePosition position{.count = all.size()};
  if (all.size() > 1 && all.back() != all.front())
    position.spacing = (all.back() - all.front()) / static_cast<double>(all.size() - 1);
  std::vector<JobFrame> frames;
  for (const int number : wanted) {
    const auto found = order.find(number);
    if (found == order.end())
      return failure(Code::invalid, "The job has no frame " + std::to_string(number) + ".", "/frames", range);
    position.index = found->second;
    Result<JobFrame> frame = planner.frame(number, position);
    if (!frame) return frame.status();
    frames.push_back(std::move(frame).value());
  }
  return frames;
}

}  // namespace

Result<std::vector<JobFrame>> plan_job(const RenderJob& original_job, const JobPart& part, const std::string& folder,
                                       const Scene& scene) {
  RenderJob job = original_job;
  if (!part.output.empty()) job.output = part.output;
  if (job.time_lapse && job.turntable && job.turntable->turns == Turning::model)
    return failure(Code::invalid, "A time lapse shows each revision in its own lights, which cannot turn.",
                   "/turntable/turns", "camera");
  if (job.time_lapse && job.motion)
    return failure(Code::invalid, "A time lapse shows a model at rest.", "/motion", "without time_lapse");
  if (job.time_lapse && job.motion_blur)
    return failure(Code::invalid, "A time lapse has no motion to blur.", "/motion_blur", "without time_lapse");
  const int tile_count = job.tiles ? job.tiles->columns * job.tiles->rows : 0;
  if (part.tile < 0 || part.tile > tile_count)
    return failure(Code::invalid, "The job has no tile " + std::to_string(part.tile) + ".", "/tiles",
                   tile_count > 0 ? "[1, " + std::to_string(tile_count) + "]" : "a job with tiles");
  const Result<std::vector<int>> all = parse_frames(job.frames);
  if (!all) return all.status();
  const Result<std::vector<int>> wanted = part.frames.empty() ? all : parse_frames(part.frames);
  if (!wanted) {  // parse_frames points at the job's frames
    Status refused = wanted.status();
    refused.pointer = "--frames";
    return refused;
  }
  Result<OutputPattern> pattern =
      OutputPattern::create(job.output, part.output.empty() ? folder : ".", all->size() > 1);
  if (!pattern) return pattern.status();
  Result<Animation> animation = Animation::create(job, scene.settings()->settings);
  if (!animation) return animation.status();
  std::shared_ptr<const ModelMoments> moments;
  if (job.motion) {
    Result<ModelMoments> made = ModelMoments::create(*job.motion, job.fps, folder);
    if (!made) return made.status();
    moments = std::make_shared<const ModelMoments>(std::move(*made));
  }
  return plan_frames(Planner(job, scene, std::move(*animation), std::move(*pattern), std::move(moments)), *all, *wanted,
                     job.frames);
}

}  // namespace pelage
