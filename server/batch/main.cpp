// pelage-render: the farm node. Draws the frames of a job into files, without a server.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <thread>

#include "base/limits.h"
#include "base/version/version.h"
#include "protocol/json/encode.h"
#include "server/batch/input_file.h"
#include "server/batch/model_files.h"
#include "server/batch/output_file.h"
#include "server/batch/render_job.h"
#include "server/process/signals.h"
#include "server/scene/scene_memory.h"

namespace {

using namespace pelage;

// Exit codes that farms read (docs/farm.md).
constexpr int done = 0, failed = 1, usage = 2, bad_input = 3, no_gl = 4, too_slow = 5, out_of_memory = 33,
              stopped_by_signal = 143;

struct Options {
  std::string job, scene;
  JobPart part;
  DrawOptions draw;
  bool check = false, schema = false;
  int measure = 0;  // number of frames to draw for --measure
};

void declare(CLI::App& app, Options& options) {
  static const std::map<std::string, GlChoice> gl_names{
      {"auto", GlChoice::automatic}, {"none", GlChoice::none}, {"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}};
  app.set_version_flag("--version", version_line("pelage-render"));
  app.add_option("job", options.job, "File of the job, JSON");
  app.add_option("--scene", options.scene, "File of the scene, in place of the job's");
  app.add_option("--frames", options.part.frames,
                 "Part of the job's frames to draw: 1-100, 1-100x5 or 1,4,9; a colon is a step too");
  app.add_option("--tile", options.part.tile,
                 "Number of the tile to draw of each frame, from 1; the job's `tiles` say how many there are")
      ->check(CLI::Range(1, limits::job_tiles * limits::job_tiles));
  app.add_option("--output", options.part.output, "Files to write, in place of the job's, as out/fox.####.png");
  app.add_flag("--skip-existing", options.draw.skip_existing,
               "Leave frames whose file is whole and of the same scene, frame, settings and version");
  app.add_option("--threads", options.draw.threads, "Threads that draw; 0 for all cores")->check(CLI::Range(0, 1024));
  app.add_option_function<std::string>(
         "--gl", [&options](const std::string& name) { options.draw.gl = gl_names.at(name); },
         "what draws: auto (a GPU, else the CPU), none (the CPU), egl or osmesa [auto]")
      ->check(CLI::IsMember(gl_names));
  app.add_option("--device", options.draw.device, "Number of the EGL device that draws, where there are several GPUs")
      ->check(CLI::Range(0, 31));
  app.add_flag("--check", options.check, "Check job and scene and print what would be drawn, as JSON; draw nothing");
  app.add_option("--measure", options.measure, "With --check: draw so many frames for their seconds, and keep none")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--schema", options.schema, "Print the JSON Schema of a job");
  app.footer(
      "Examples:\n"
      "  pelage-render fox.json --frames 1-20\n"
      "  pelage-render fox.json --scene fox.pelage --skip-existing\n"
      "  pelage-render fox.json --frames 12 --tile 3\n"
      "  pelage-render fox.json --check --measure 3\n"
      "Exit codes: 0 done, 1 failed, 2 wrong use, 3 the job or its scene was refused, 4 no GL, 5 a frame passed the "
      "job's max_seconds, 33 out of memory, 143 stopped.");
}

/// True once SIGTERM or SIGINT has arrived; they may arrive several times.
std::atomic<bool> stop_asked{false};

/// Watches for stop signals as long as the program lives.
void watch_stop_signals() {
  std::thread([signals = StopSignals()] {
    for (;;) signals.wait(), stop_asked = true;
  }).detach();
}

bool stopped() { return stop_asked; }

int code_of(const Status& status) {
  if (stopped()) return stopped_by_signal;
  if (status.code == Code::unavailable && status.pointer == limit_pointer) return too_slow;
  switch (status.code) {
    case Code::malformed:
    case Code::not_found:
    case Code::unsupported:
    case Code::invalid: return bad_input;
    case Code::too_large: return out_of_memory;
    default: return failed;
  }
}

int fail(FarmLog& log, const Status& status, int code) {
  log.failed(status);
  return code;
}
int fail(FarmLog& log, const Status& status) { return fail(log, status, code_of(status)); }

/// Returns at most `count` frames, spread over the job's frames.
std::vector<const JobFrame*> probes_of(const std::vector<JobFrame>& frames, int count) {
  std::vector<const JobFrame*> probes;
  const std::size_t wanted = std::min(frames.size(), static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < wanted; ++k) probes.push_back(&frames[(2 * k + 1) * frames.size() / (2 * wanted)]);
  return probes;
}

/// Returns the mean seconds of a frame. The first drawing includes work that all frames share, and does not count.
Result<double> measured_seconds(JobRenderer& renderer, const std::vector<JobFrame>& frames, int count) {
  const std::vector<const JobFrame*> probes = probes_of(frames, count);
  if (const auto first = renderer.measure(*probes.front(), stopped); !first) return first;
  double seconds = 0;
  for (const JobFrame* probe : probes) {
    const Result<double> measured = renderer.measure(*probe, stopped);
    if (!measured) return measured;
    seconds += *measured / static_cast<double>(probes.size());
  }
  return seconds;
}

/// Formats a file that would be drawn, as members of a JSON object.
std::string text_of(const std::string& file, const std::string& fingerprint, int width, int height) {
  return fmt::format("\"file\": {}, \"fingerprint\": \"{}\", \"width\": {}, \"height\": {}", json_text(file),
                     fingerprint, width, height);
}

std::string text_of(const JobFrame& frame) {
  const FrameRequest& request = frame.moment.request;
  const glm::ivec2 size =
      request.crop ? glm::ivec2(request.crop->width, request.crop->height) : glm::ivec2(request.width, request.height);
  std::string tiles;
  for (const JobTile& tile : frame.tiles)
    tiles +=
        (tiles.empty() ? "{" : ", {") + text_of(tile.file, tile.fingerprint, tile.crop.width, tile.crop.height) + "}";
  return fmt::format("{{\"frame\": {}, {}, \"tiles\": [{}]}}", frame.number,
                     text_of(frame.file, frame.fingerprint, size.x, size.y), tiles);
}

int print_check(const RenderJob& job, const Options& options, const JobScene& scene,
                const std::vector<JobFrame>& frames, FarmLog& log) {
  if (Status refused = check_models(scene, frames, stopped); !refused.ok()) return fail(log, refused);
  std::optional<double> seconds;
  if (options.measure > 0) {
    const auto renderer = JobRenderer::start(scene, job.fps, options.draw);
    if (!renderer) return fail(log, renderer.status(), no_gl);
    const Result<double> measured = measured_seconds(**renderer, frames, options.measure);
    if (!measured) return fail(log, measured.status());
    seconds = *measured;
  }
  std::string list;
  for (const JobFrame& frame : frames) list += (list.empty() ? "\n  " : ",\n  ") + text_of(frame);
  fmt::print("{{{}\"fps\": {}, \"frames\": [{}\n]}}\n",
             seconds ? fmt::format("\"seconds_per_frame\": {:.4f}, ", *seconds) : "", job.fps, list);
  return done;
}

/// Adds the name of the job's file to a refusal that points into the job.
Status in_job(const Options& options, const Status& status) {
  return status.pointer.starts_with('/') ? in_file(options.job, status) : status;
}

int render(const Options& options, FarmLog& log) {
  const std::string folder = std::filesystem::path(options.job).parent_path().string();
  const Result<std::string> text = read_file(options.job);
  if (!text) return fail(log, text.status());
  Result<RenderJob> job = decode_job(*text);
  if (!job) return fail(log, in_file(options.job, job.status()));
  if (!options.scene.empty()) job->builtin.reset(), job->scene = std::filesystem::absolute(options.scene).string();
  const Result<JobScene> scene = JobScene::open(*job, folder);
  if (!scene) return fail(log, in_job(options, scene.status()));
  const auto frames = plan_job(*job, options.part, folder, *scene->scene());
  if (!frames) return fail(log, in_job(options, frames.status()));
  if (Status refused = check_folder_writable(frames->front().file); !refused.ok()) return fail(log, refused);
  if (options.check) return print_check(*job, options, *scene, *frames, log);
  DrawOptions draw = options.draw;
  draw.tile = options.part.tile;
  const auto renderer = JobRenderer::start(*scene, job->fps, draw);
  if (!renderer) return fail(log, renderer.status(), no_gl);
  const Result<JobOutcome> outcome = (*renderer)->draw(*frames, log, stopped);
  return outcome ? done : fail(log, outcome.status());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draws the frames of a Pelage job into files."};
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
    if (!options.schema && options.job.empty()) throw CLI::RequiredError("job");
    if (options.measure > 0 && !options.check) throw CLI::RequiresError("--measure", "--check");
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : usage;
  }
  if (options.schema) return fmt::print("{}\n", job_schema()), done;
  limit_arenas();
  watch_stop_signals();
  FarmLog log;
  try {
    return render(options, log);
  } catch (const std::bad_alloc&) {
    return fail(log, failure(Code::too_large, "there is not enough memory for this job"), out_of_memory);
  } catch (const std::exception& error) {
    return fail(log, failure(Code::internal, error.what()), failed);
  }
}
