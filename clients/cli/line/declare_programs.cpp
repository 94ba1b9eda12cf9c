#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void declare_trade(CLI::App& app, Options& options) {
  CLI::App* trade = add_action(app, options, Action::trade, "trade",
                               "Measure what each quality costs and how far it is from the truth: a table and a page");
  trade->add_option("-o,--output", options.output, "Folder for results.csv and index.html")->required();
  trade->add_option("--scene", options.scenes,
                    "Id or name of a scene to measure as it is; may be repeated [built-in ones]");
  trade->add_flag("--quick", options.quick, "One small scene and few knobs: a look at the page in seconds");
  trade->add_flag("--resume", options.resume, "Keep what results.csv has already");
  trade->add_option("--size", options.size, "Pixels of a side")->capture_default_str()->check(CLI::Range(16, 2048));
  trade->add_option("--passes", options.r2_passes, "Passes of the true pictures, which are traced")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536));
  trade->add_option("--repeats", options.repeats, "Timed frames of each setting; the least counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
}

void declare_compare(CLI::App& app, Options& options) {
  CLI::App* compare =
      add_action(app, options, Action::compare, "compare", "Measure how far one picture is from another");
  compare->add_option("reference", options.reference, "The true picture: PNG, JPEG, EXR or HDR")->required();
  compare->add_option("test", options.test, "The picture to measure, of the same size")->required();
  compare->add_option("--mask", options.mask,
                      "Picture of where to measure: its alpha, or what is brighter than half [the alpha of both]");
  compare->add_option("--map", options.map, "PNG of where the error is, dark for none");
  compare->add_option("--tone-map", options.tone_map, "How EXR and HDR are shown, for FLIP: none or filmic")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "filmic"}));
}

void declare_calibrate(CLI::App& app, Options& options) {
  CLI::App* calibrate = add_action(app, options, Action::calibrate, "calibrate",
                                   "Measure what frames cost on this machine, for servers that start here from now on");
  const auto add = [&](const char* flag, const char* help) {
    add_parameter_option(calibrate, options.server_options, flag, flag, help);
  };
  add("--data", "The server's folder, where the calibration is stored [pelage-data]");
  add("--calibration", "Another file for it");
  add("--gl", "As the server's: auto, egl or osmesa [auto]");
  add("--threads", "As the server's: threads of a software GL, 0 for all cores [0]");
}

void declare_get(CLI::App& app, Options& options) {
  CLI::App* get = add_action(app, options, Action::get, "get",
                             "Print what stands at an address of the contract: /metrics, or settings of a scene");
  get->add_option("scene", options.scene, "The address, or the id or name of a scene")->required();
  get->add_option("address", options.address, "What of the scene: settings, events, mesh, 'compare?from=0&to=3' ...");
  get->add_option("-o,--output", options.answer, "File that takes it; - for standard output")->capture_default_str();
}

}  // namespace

void declare_program_actions(CLI::App& app, Options& options) {
  CLI::App* wait = add_action(app, options, Action::wait, "wait", "Wait until the server is ready");
  wait->add_option("--seconds", options.wait_seconds, "How long at most, 0 to 3600")
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
