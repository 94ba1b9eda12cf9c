#include "server/batch/render_job.h"

#include "protocol/base/stopwatch.h"
#include "server/batch/output_file.h"
#include "server/frames/scene_tracer.h"
#include "server/import/import.h"

namespace pelage {

namespace {

constexpr std::size_t trace_memory = std::size_t{16} << 30;

Status stopped_status() { return failure(Code::unavailable, "stopped before the job was done"); }

}  // namespace

JobRenderer::JobRenderer(const JobScene& scene, double fps, const DrawOptions& options,
                         std::unique_ptr<FrameService> frames, std::unique_ptr<YieldGate> gate)
    : job_scene_(scene),
      scene_(scene.scene()),
      summary_(scene_->summary()),
      fps_(fps),
      options_(options),
      gate_(std::move(gate)),
      frames_(std::move(frames)),
      traces_(std::make_unique<SceneTracer>(*frames_, options.threads, trace_memory), *gate_),
      pictures_(*frames_, traces_) {}

Result<std::unique_ptr<JobRenderer>> JobRenderer::start(const JobScene& scene, double fps, const DrawOptions& options) {
  auto gate = std::make_unique<YieldGate>();
  auto frames = FrameService::start(options.gl, options.threads, *gate, options.device);
  if (!frames) return frames.status();
  return std::unique_ptr<JobRenderer>(new JobRenderer(scene, fps, options, std::move(frames).value(), std::move(gate)));
}

Result<RawModel> JobRenderer::load(const ModelMoment& moment) const {
  const Result<std::string> bytes = read_file(moment.file);
  if (!bytes) return bytes.status();
  return import_model(program_folder() + "/pelage-import", moment.format, std::as_bytes(std::span(*bytes)),
                      moment.pose);
}

/// What goes wrong is of the job's model at that moment.
Status JobRenderer::stand(const JobFrame& frame) {
  const auto refused = [&](const Status& status) {
    return failure(status.code, frame.model->file + ": " + status.message, "/motion/model", status.limit);
  };
  if (!moving_) {
    Result<MovingModel> moving = job_scene_.moving_model();
    if (!moving) return moving.status();
    moving_ = std::move(*moving);
  }
  const Result<RawModel> raw = load(*frame.model);
  if (!raw) return refused(raw.status());
  const std::uint64_t id = job_scene_.new_model_id();
  Result<ScenePose> pose = moving_->pose(*raw, scene_->settings()->settings, id);
  if (!pose) return refused(pose.status());
  if (frame.moments->inertia() > 0) {
    Result<BodySwing> swing = swing_of(frame);
    if (!swing) return refused(swing.status());
    pose->swing = std::move(*swing);
  }
  scene_->pose(std::move(*pose));
  if (stands_as_ != 0) frames_->forget(stands_as_);
  stands_as_ = id;
  return {};
}

Result<BodySwing> JobRenderer::swing_of(const JobFrame& frame) {
  if (!history_) {
    const auto name = [moments = frame.moments](int number) { return moments->name_of(number); };
    const auto model = [this, moments = frame.moments](int number) -> Result<RawModel> {
      const Result<ModelMoment> moment = moments->at(number);
      if (!moment) return moment.status();
      return load(*moment);
    };
    history_.emplace(*moving_, fps_, frame.moments->inertia(), PoseHistory::Source{name, model});
  }
  return history_->at(frame.number, frame.request.time.value_or(frame.number / fps_));
}

Result<FrameAnswer> JobRenderer::picture(const JobFrame& frame, const std::function<bool()>& stopped) {
  const Stopwatch passed;
  if (!frame.settings.empty()) {
    const Result<CommandAnswer> set = scene_->execute(frame.settings);
    if (!set) return set.status();
  }
  if (frame.model) {
    if (Status stands = stand(frame); !stands.ok()) return stands;
  }
  return pictures_.frame(scene_, frame.request, stopped, [&](const FrameAnswer& answer) {
    return texts_of(frame, answer, summary_, fps_, passed.milliseconds() / 1e3);
  });
}

Result<double> JobRenderer::measure(const JobFrame& frame, const std::function<bool()>& stopped) {
  const Stopwatch passed;
  const Result<FrameAnswer> answer = picture(frame, stopped);
  if (!answer) return stopped() ? stopped_status() : answer.status();
  return passed.milliseconds() / 1e3;
}

Result<JobOutcome> JobRenderer::draw(const std::vector<JobFrame>& frames, FarmLog& log,
                                     const std::function<bool()>& stopped) {
  JobOutcome outcome;
  const Stopwatch passed;
  for (const JobFrame& frame : frames) {
    if (stopped()) return stopped_status();
    if (options_.skip_existing && is_drawn(frame.file, frame.fingerprint)) {
      log.skipped(frame.file), ++outcome.skipped;
      continue;
    }
    log.begin(frame.number, outcome.drawn + outcome.skipped, frames.size());
    const Result<FrameAnswer> answer = picture(frame, stopped);
    if (!answer) return stopped() ? stopped_status() : answer.status();
    if (Status written = write_whole(frame.file, answer->bytes); !written.ok()) return written;
    log.saved(frame.file), ++outcome.drawn;
  }
  log.done(outcome.drawn, outcome.skipped, passed.milliseconds() / 1e3);
  return outcome;
}

}  // namespace pelage
