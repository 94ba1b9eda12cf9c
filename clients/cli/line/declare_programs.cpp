#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void declare_trade(CLI::App& app, Options& options) {
  CLI::App* trade = add_action(app, options, Action::trade, "trade",
                               "Measure the cost and the error of each quality; writes a table and a page");
  trade->add_option("-o,--output", options.output, "Folder for results.csv and index.html")->required();
  trade->add_option("--scene", options.scenes,
                    "Id or name of a scene to measure as it is; may be repeated [built-in ones]");
  trade->add_flag("--quick", options.quick, "A trial: one small scene, few knobs, small pictures");
  trade->add_flag("--resume", options.resume, "Keep the results already in results.csv");
  trade->add_option("--size", options.size, "Width and height in pixels")
      ->capture_default_str()
      ->check(CLI::Range(16, 2048));
  trade->add_option("--passes", options.r2_passes, "Passes of the traced reference, at least 2")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536));
  trade->add_option("--repeats", options.repeats, "Timed frames of each setting; the fastest counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
}

void declare_compare(CLI::App& app, Options& options) {
  CLI::App* compare =
      add_action(app, options, Action::compare, "compare", "Measure the error of a picture against a reference");
  compare->add_option("reference", options.reference, "The reference picture: PNG, JPEG, EXR or HDR")->required();
  compare->add_option("test", options.test, "The picture to measure, of the same size")->required();
  compare->add_option(
      "--mask", options.mask,
      "Picture of where to measure: its alpha, or if opaque where it is above half [union of both alphas]");
  compare->add_option("--map", options.map, "PNG for the error map, dark for none");
  compare->add_option("--tone-map", options.tone_map, "Tone mapping of EXR and HDR for FLIP: none or filmic")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "filmic"}));
}

void declare_calibrate(CLI::App& app, Options& options) {
  CLI::App* calibrate = add_action(app, options, Action::calibrate, "calibrate",
                                   "Measure what frames cost on this machine; servers read it when they start");
  const auto add = [&](const char* flag, const char* help) {
    add_parameter_option(calibrate, options.server_options, flag, flag, help);
  };
  add("--data", "The server's folder, where the calibration is stored [pelage-data]");
  add("--calibration", "Calibration file [calibration.json in --data]");
  add("--gl", "As the server's: auto, none, egl or osmesa [auto]");
  add("--threads", "As the server's: threads that draw, 0 for all cores [0]");
}

void declare_get(CLI::App& app, Options& options) {
  CLI::App* get = add_action(app, options, Action::get, "get",
                             "Print what an API address answers: /metrics, or settings of a scene");
  get->add_option("scene", options.scene, "A path such as /metrics, or the id or name of a scene")->required();
  get->add_option("address", options.address, "Address below the scene: settings, mesh, 'compare?from=0&to=3' ...");
  get->add_option("-o,--output", options.answer, "Output file; - for standard output")->capture_default_str();
}

}  // namespace

void declare_program_actions(CLI::App& app, Options& options) {
  CLI::App* wait = add_action(app, options, Action::wait, "wait", "Wait until the server is ready");
  wait->add_option("--seconds", options.wait_seconds, "Timeout in seconds, 0 to 3600")
      ->capture_default_str()
      ->check(CLI::Range(0, 3600));
  declare_get(app, options);
  declare_compare(app, options);
  declare_trade(app, options);
  declare_calibrate(app, options);
  CLI::App* completions = add_action(app, options, Action::completions, "completions",
                                     "Print a script that completes this command line in a shell");
  completions->add_option("shell", options.shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  add_action(app, options, Action::man, "man", "Print the manual page, as roff for `man`");
}

}  // namespace pelage
