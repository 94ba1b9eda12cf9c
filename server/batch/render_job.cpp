#include "server/batch/render_job.h"

#include <fmt/format.h>

#include <atomic>
#include <future>
#include <memory>
#include <utility>

#include "base/stopwatch.h"
#include "protocol/json/encode.h"
#include "server/batch/input_file.h"
#include "server/batch/model_files.h"
#include "server/batch/output_file.h"
#include "server/batch/tiles.h"
#include "server/frames/scene_tracer.h"

namespace pelage {

namespace {

constexpr std::size_t trace_memory = std::size_t{16} << 30;

Status stopped_status() { return failure(Code::unavailable, "stopped before the job was done"); }

Status passed_limit(int frame, double seconds) {
  return with_next(failure(Code::unavailable, fmt::format("frame {} takes longer than the job allows", frame),
                           limit_pointer, fmt::format("{} seconds", seconds)),
                   "draw it on a faster node, or allow it more seconds");
}

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
  const auto gl = [options] { return select_context(options.gl, options.threads, options.device); };
  auto frames = FrameService::start(gl, options.threads, *gate);
  if (!frames) return frames.status();
  return std::unique_ptr<JobRenderer>(new JobRenderer(scene, fps, options, std::move(frames).value(), std::move(gate)));
}

Status JobRenderer::set_pose(const JobFrame& frame, const ModelMoment& model) {
  if (!moving_) {
    Result<MovingModel> moving = job_scene_.moving_model();
    if (!moving) return moving.status();
    moving_ = std::move(*moving);
  }
  const Result<RawModel> raw = read_model(*moving_, model);
  if (!raw) return raw.status();
  const std::uint64_t id = job_scene_.new_model_id();
  Result<ScenePose> pose = moving_->pose(*raw, scene_->settings()->settings, id);
  if (!pose) return in_file(model.file, failure(pose.status().code, pose.status().message, "/motion/model"));
  if (frame.motion->inertia() > 0) {
    Result<BodySwing> swing = swing_of(frame);
    if (!swing) return swing.status();
    pose->swing = std::move(*swing);
  }
  scene_->pose(std::move(*pose));
  if (pose_model_id_ != 0) frames_->forget(pose_model_id_);
  pose_model_id_ = id;
  return {};
}

Result<BodySwing> JobRenderer::swing_of(const JobFrame& frame) {
  if (!history_) {
    const auto name = [moments = frame.motion](int number) { return moments->name_of(number); };
    const auto model = [this, moments = frame.motion](int number) -> Result<RawModel> {
      const Result<ModelMoment> moment = moments->at(number);
      if (!moment) return moment.status();
      return read_model(*moving_, *moment);
    };
    history_.emplace(*moving_, fps_, frame.motion->inertia(), PoseHistory::Source{name, model});
  }
  return history_->at(frame.number, frame.moment.request.time.value_or(frame.number / fps_));
}

JobRenderer::Region JobRenderer::frame_region(const JobFrame& frame) {
  return {frame, frame.file, frame.fingerprint, frame.moment.request.crop};
}

JobRenderer::Region JobRenderer::tile_region(const JobFrame& frame, const JobTile& tile) {
  return {frame, tile.file, tile.fingerprint, tile.crop};
}

std::vector<JobRenderer::Region> JobRenderer::regions_of(const std::vector<JobFrame>& frames) const {
  std::vector<Region> regions;
  for (const JobFrame& frame : frames) {
    if (frame.tiles.empty()) regions.push_back(frame_region(frame));
    for (const JobTile& tile : frame.tiles) {
      if (options_.tile == 0 || options_.tile == tile.number) regions.push_back(tile_region(frame, tile));
    }
  }
  return regions;
}

Status JobRenderer::prepare(const JobFrame& frame, const JobMoment& moment) {
  if (!moment.settings.empty()) {
    const Result<CommandAnswer> set = scene_->execute(moment.settings);
    if (!set) return set.status();
  }
  return moment.model ? set_pose(frame, *moment.model) : Status{};
}

Result<LinearPicture> JobRenderer::blurred(const Region& region, const std::function<bool()>& stopped) {
  MeanPicture mean(linear_aovs(region.frame.moment.request), static_cast<int>(region.frame.shutter_moments.size()));
  for (const JobMoment& moment : region.frame.shutter_moments) {
    if (Status ready = prepare(region.frame, moment); !ready.ok()) return ready;
    Result<LinearPicture> linear = pictures_.draw_linear(scene_, region.request_at(moment), stopped);
    if (!linear) return linear;
    mean.add(std::move(*linear));
  }
  return std::move(mean).take();
}

Result<JobRenderer::Encode> JobRenderer::picture(const Region& region, const std::function<bool()>& stopped) {
  const Stopwatch passed;
  const JobFrame& frame = region.frame;
  const auto texts_after = [this, &frame, fingerprint = region.fingerprint](const FrameAnswer& answer, double seconds) {
    std::vector<ImageText> texts = metadata_of(frame, encode(answer.knobs), summary_, fps_, seconds);
    for (ImageText& text : texts) {
      if (text.key == fingerprint_key) text.value = fingerprint;
    }
    return texts;
  };
  const FrameRequest request = region.request_at(frame.moment);
  Result<PictureService::Encode> drawn = failure(Code::internal, "not drawn");
  if (!frame.shutter_moments.empty()) {
    drawn = mean_picture(region, request, stopped);
  } else if (Status ready = prepare(frame, frame.moment); !ready.ok()) {
    return ready;
  } else {
    drawn = pictures_.begin_frame(scene_, request, stopped);
  }
  if (!drawn) return drawn.status();
  return Encode([drawn = std::move(*drawn), texts_after, seconds = passed.seconds()] {
    return drawn([&](const FrameAnswer& answer) { return texts_after(answer, seconds); });
  });
}

Result<PictureService::Encode> JobRenderer::mean_picture(const Region& region, const FrameRequest& request,
                                                         const std::function<bool()>& stopped) {
  const Result<LinearPicture> mean = blurred(region, stopped);
  Result<DrawnFrame> finished = mean ? frames_->finish(*mean, request) : mean.status();
  if (!finished) return finished.status();
  return PictureService::Encode(
      [this, request, picture = std::make_shared<DrawnFrame>(std::move(*finished))](const FileTexts& texts) {
        return frames_->encode(std::move(*picture), request, texts);
      });
}

Result<double> JobRenderer::measure(const JobFrame& frame, const std::function<bool()>& stopped) {
  const Stopwatch passed;
  const bool tiled = !frame.tiles.empty();
  const Result<Encode> drawn =
      picture(tiled ? tile_region(frame, frame.tiles[frame.tiles.size() / 2]) : frame_region(frame), stopped);
  if (!drawn) return stopped() ? stopped_status() : drawn.status();
  static_cast<void>((*drawn)());
  return passed.milliseconds() / 1e3 * (tiled ? static_cast<double>(frame.tiles.size()) : 1);
}

bool JobRenderer::is_there(const Region& region) const {
  const JobFrame& frame = region.frame;
  if (frame.tiles.empty() || !is_drawn(frame.file, frame.fingerprint)) return is_drawn(region.file, region.fingerprint);
  remove_tiles(frame);  // left by a process that was killed before it could remove them
  return true;
}

Result<JobRenderer::Save> JobRenderer::draw(const Region& region, const std::function<bool()>& stopped) {
  const Stopwatch passed;
  const std::optional<double>& limit = region.frame.moment.max_seconds;
  const auto too_slow = [&] { return limit && passed.seconds() > *limit; };
  const Result<Encode> drawn = picture(region, [&] { return stopped() || too_slow(); });
  if (!drawn && stopped()) return stopped_status();
  if (!drawn && drawn.status().code == Code::unavailable && too_slow())
    return passed_limit(region.frame.number, *limit);
  if (!drawn) return drawn.status();
  return Save([drawn = *drawn, &file = region.file] { return write_atomically(file, drawn().bytes); });
}

Result<JobOutcome> JobRenderer::draw(const std::vector<JobFrame>& frames, FarmLog& log,
                                     const std::function<bool()>& stopped) {
  JobOutcome outcome;
  const Stopwatch passed;
  const std::vector<Region> regions = regions_of(frames);
  std::future<Status> saved;  // saves the previous file while the next one is drawn
  std::atomic<bool> failed{false};
  const auto wait = [&] { return saved.valid() ? saved.get() : Status{}; };
  const auto ends = [&] { return stopped() || failed; };
  for (const Region& region : regions) {
    if (ends()) {
      Status before = wait();
      return before.ok() ? stopped_status() : before;
    }
    if (options_.skip_existing && is_there(region)) {
      log.skipped(region.file), ++outcome.skipped;
    } else {
      log.begin(region.frame.number, outcome.drawn + outcome.skipped, regions.size());
      const Result<Save> drawn = draw(region, ends);
      if (Status before = wait(); !before.ok()) return before;
      if (!drawn) return drawn.status();
      saved = std::async(std::launch::async, [&log, &failed, &file = region.file, save = *drawn] {
        const Status written = save();
        if (written.ok()) log.saved(file);
        failed = !written.ok();
        return written;
      });
      ++outcome.drawn;
    }
    if (region.frame.tiles.empty()) continue;
    if (Status before = wait(); !before.ok()) return before;
    const Result<bool> merged = merge_tiles(region.frame, summary_, fps_);
    if (!merged) return merged.status();
    if (*merged) log.saved(region.frame.file);
  }
  if (Status before = wait(); !before.ok()) return before;
  log.done(outcome.drawn, outcome.skipped, passed.milliseconds() / 1e3);
  return outcome;
}

}  // namespace pelage
