// pelaged: the render server.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "base/caught.h"
#include "base/limits.h"
#include "base/temporary_name.h"
#include "base/version/version.h"
#include "renderer/picture_files/picture_files.h"
#include "server/frames/calibrate.h"
#include "server/frames/frame_planner.h"
#include "server/frames/frame_service.h"
#include "server/frames/scene_tracer.h"
#include "server/http/http_server.h"
#include "server/import/import.h"
#include "server/log/server_log.h"
#include "server/process/signals.h"
#include "server/scene/scene_memory.h"
#include "server/scene/scene_store.h"

namespace {

using namespace pelage;

/// Ends the program with code 0 unless it is destroyed within `time` after begin(). It is constructed before all
/// objects whose destructors may wait, so that it outlives them. By then all changes that were acknowledged are on
/// disk, and nobody waits for the work that is still running.
class StopDeadline {
 public:
  /// 1 s after the transport disconnects the clients that still wait (ReceptionLimits), which cancels their work.
  static constexpr std::chrono::seconds time{9};

  void begin() {
    thread_ = std::jthread([](const std::stop_token& ended) {
      std::mutex mutex;
      std::condition_variable_any passed;
      std::unique_lock lock(mutex);
      passed.wait_for(lock, ended, time, [] { return false; });
      if (ended.stop_requested()) return;
      std::fputs("pelaged: stopped, and cut off what had not ended\n", stdout);
      std::fflush(stdout);
      _exit(0);
    });
  }

 private:
  std::jthread thread_;
};

// Exit codes of all programs of the project.
constexpr int failed = 1, usage = 2, no_gl = 4;

constexpr std::size_t min_memory = std::size_t{1} << 20, max_memory = std::size_t{1} << 50;
constexpr std::size_t suspended_share =
    4;  // pictures that are set aside may take 1 / suspended_share of --trace-memory more
constexpr std::size_t coat_share = 4;  // baked coats take at most 1 / coat_share of --memory

struct Options {
  std::string listen = "127.0.0.1:8080";
  std::string port_file;
  std::string data = "pelage-data";
  GlChoice gl = GlChoice::automatic;
  std::optional<int> device;  // number of the EGL device, if there are several GPUs
  int threads = 0;
  std::size_t memory = 0;   // bytes of open scenes and coats; 0 for half of the machine's memory
  double trace_memory = 4;  // GiB
  std::string token;
  std::vector<std::string> hosts;
  bool calibrate = false;
  std::string calibration;
  LogFormat log_format = LogFormat::text;
  LogLevel log_level = LogLevel::info;

  std::string calibration_file() const { return calibration.empty() ? data + "/calibration.json" : calibration; }
};

template <class T>
CLI::Option* add_choice(CLI::App& app, const char* name, T& choice, const std::map<std::string, T>& words,
                        const char* description) {
  return app
      .add_option_function<std::string>(
          name, [&choice, words](const std::string& word) { choice = words.at(word); }, description)
      ->check(CLI::IsMember(words));
}

void declare(CLI::App& app, Options& options) {
  app.set_version_flag("--version", version_line("pelaged"));
  app.add_option("--listen", options.listen, "ADDRESS:PORT; port 0 picks a free one")->capture_default_str();
  app.add_option("--port-file", options.port_file, "File that the port is written to, by rename");
  app.add_option("--data", options.data, "Folder of the journal")->capture_default_str();
  add_choice(
      app, "--gl", options.gl,
      {{"auto", GlChoice::automatic}, {"none", GlChoice::none}, {"egl", GlChoice::egl}, {"osmesa", GlChoice::osmesa}},
      "what draws beside the CPU: auto (a GPU where there is one), none, egl or osmesa [auto]; a software GL draws "
      "shells "
      "alone");
  app.add_option("--device", options.device, "Number of the EGL device that draws, where there are several GPUs")
      ->check(CLI::Range(0, 31));
  app.add_option("--threads", options.threads, "Threads that draw, and as many that trace; 0 for all cores")
      ->check(CLI::Range(0, 1024));
  app.add_option("--memory", options.memory,
                 "Bytes that open scenes and coats may take, as in 4G [a half of the machine's]")
      ->transform(CLI::AsSizeValue(false))
      ->check(CLI::Range(min_memory, max_memory));
  app.add_option("--trace-memory", options.trace_memory,
                 "GiB for traced strands and their picture, and a quarter more for those that wait for their turn")
      ->check(CLI::Range(0.0625, 1024.0))
      ->capture_default_str();
  app.add_option("--token", options.token, "Bearer token that requests need; required beyond loopback addresses")
      ->envname("PELAGE_TOKEN");
  app.add_flag("--calibrate", options.calibrate,
               "Measure what frames cost on this machine, store it for the next start, and end");
  app.add_option("--calibration", options.calibration, "File of that [calibration.json in the folder of --data]");
  add_choice(app, "--log-format", options.log_format, {{"text", LogFormat::text}, {"json", LogFormat::json}},
             "Form of the lines on the standard error, one for each request: text or json [text]");
  add_choice(
      app, "--log-level", options.log_level,
      {{"info", LogLevel::info}, {"warning", LogLevel::warning}, {"error", LogLevel::error}, {"off", LogLevel::off}},
      "Lowest level of those lines: info, warning (refusals), error (failures) or off [info]");
  app.add_option("--host", options.hosts, "Name that requests may address beside the loopback ones; may be repeated");
}

bool split_address(const std::string& text, HttpOptions& http) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) return false;
  http.host = text.substr(0, colon);
  if (http.host.size() > 2 && http.host.front() == '[' && http.host.back() == ']') {
    http.host = http.host.substr(1, http.host.size() - 2);
  }
  const std::string digits = text.substr(colon + 1);
  if (digits.empty() || digits.size() > 5 || digits.find_first_not_of("0123456789") != std::string::npos) return false;
  http.port = std::stoi(digits);
  return http.port <= 65535;
}

/// Writes the port to a file by rename, so that readers see no file or a complete one.
bool write_port(const std::string& path, int port) {
  const std::string temporary = temporary_beside(path);
  std::ofstream(temporary) << port << "\n" << std::flush;
  return std::rename(temporary.c_str(), path.c_str()) == 0;
}

/// Prints a refusal in the form that the client uses, too.
void complain(const Status& status) {
  fmt::print(stderr, "pelaged: {}\n", status.message);
  if (!status.pointer.empty()) fmt::print(stderr, "  field:   {}\n", status.pointer);
  if (!status.limit.empty()) fmt::print(stderr, "  limit:   {}\n", status.limit);
  if (!status.next.empty()) fmt::print(stderr, "  next:    {}\n", status.next);
}

int fail(int code, const Status& status) {
  complain(status);
  return code;
}

/// Returns half of the memory that this process may use: the machine's memory, or less if a container sets a limit.
std::size_t default_memory() {
  std::size_t bytes =
      static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    std::size_t limit = 0;
    if (std::ifstream(file) >> limit && limit >= min_memory) bytes = std::min(bytes, limit);  // "max" is no number
  }
  return bytes / 2;
}

/// Plans frames by the stored calibration, or else by the defaults. A calibration that cannot be used is reported, a
/// missing one only if its file was given on the command line.
void plan_frames(FrameService& frames, const Options& options) {
  Result<Calibration> stored = read_calibration(options.calibration_file(), frames.description(), frames.threads());
  if (stored) return frames.set_calibration(std::move(stored).value());
  if (stored.status().code == Code::not_found && options.calibration.empty()) return;
  complain(with_next(stored.status(), "frames are planned by the defaults; `pelage calibrate` measures this machine"));
}

/// Loads the libraries for picture files while no client waits; otherwise the first JPEG or EXR would take .3 s longer.
void load_picture_files() {
  const Status loaded = caught([] { return picture_files(), Status{}; });
  if (!loaded.ok()) complain(with_next(loaded, "build or install all programs in one folder"));
}

int serve(const Options& options, const HttpOptions& http) {
  if (!options.port_file.empty()) std::remove(options.port_file.c_str());  // left by an earlier server
  const StopSignals signals;
  StopDeadline deadline;
  YieldGate gate;
  const std::size_t memory = options.memory ? options.memory : default_memory();
  const auto gl = [&options] { return select_context(options.gl, options.threads, options.device); };
  const auto frames = FrameService::start(gl, options.threads, gate, memory / coat_share);
  if (!frames) return fail(no_gl, frames.status());
  plan_frames(**frames, options);
  const auto scenes = SceneStore::open(options.data, program_folder() + "/pelage-import", limits::undo_bytes, memory);
  if (!scenes) return fail(failed, scenes.status());
  (*scenes)->count_copies([&](std::uint64_t copy) { return (*frames)->copy_bytes(copy); });
  (*scenes)->count_coats([&] { return (*frames)->coat_bytes(); });
  (*scenes)->on_close([&](std::uint64_t copy) { (*frames)->forget(copy); });
  const auto trace_memory = static_cast<std::size_t>(options.trace_memory * 1024 * 1024 * 1024);
  TraceQueue::Limits trace_limits;
  trace_limits.suspended_bytes = trace_memory / suspended_share;
  const ServerLog log(options.log_format, options.log_level, STDERR_FILENO);
  for (const std::string& damage : (*scenes)->damages())
    log.write(LogLevel::error, "damage", {{"why", std::string_view(damage)}});
  TraceQueue traces(std::make_unique<SceneTracer>(**frames, options.threads, trace_memory), gate, trace_limits);
  const auto server = HttpServer::listen(http, {**scenes, **frames, traces, gate, log});
  if (!server) return fail(usage, server.status());

  const int port = (*server)->port();
  const std::string host = http.host.find(':') == std::string::npos ? http.host : "[" + http.host + "]";
  fmt::print("pelaged: http://{}:{}/ with {}\n", host, port, (*frames)->description());
  std::fflush(stdout);
  if (!options.port_file.empty() && !write_port(options.port_file, port)) {
    return fail(failed, failure(Code::internal, "Cannot write " + options.port_file + "."));
  }
  std::thread stopper([&] {
    const StopSignals::Stop stop = signals.wait();
    if (stop.sender != getpid()) {
      fmt::print("pelaged: stopping, process {} sent signal {}\n", stop.sender, stop.signal);
      std::fflush(stdout);
    }
    deadline.begin();
    (*server)->stop();
  });
  std::thread loader(load_picture_files);
  const Status served = (*server)->run();
  loader.join();
  pthread_kill(stopper.native_handle(), SIGTERM);  // ends the thread if no signal came
  stopper.join();
  if (!served.ok()) return fail(failed, served);
  fmt::print("pelaged: stopped\n");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The Pelage render server."};
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : usage;
  }
  if (options.calibrate) {
    const Status calibrated = calibrate_machine(options.gl, options.threads, options.calibration_file());
    if (calibrated.ok()) return 0;
    return fail(calibrated.code == Code::unavailable ? no_gl : failed, calibrated);
  }
  limit_arenas();
  HttpOptions http{.host = {}, .port = 0, .token = options.token, .hosts = options.hosts};
  if (!split_address(options.listen, http)) {
    return fail(usage, failure(Code::invalid, "--listen takes ADDRESS:PORT, not " + options.listen + "."));
  }
  return serve(options, http);
}
