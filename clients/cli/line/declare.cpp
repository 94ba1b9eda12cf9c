#include "clients/cli/line/declare.h"

#include <CLI/CLI.hpp>

#include "clients/cli/help/examples.h"

namespace pelage {

CLI::App* add_action(CLI::App& app, Options& options, Action action, const char* name, const char* help) {
  CLI::App* command = app.add_subcommand(name, help);
  command->callback([&options, action] { options.action = action; });
  command->fallthrough();
  command->footer(footer_of((app.get_parent() ? app.get_name() + " " : "") + name));
  return command;
}

void add_scene(CLI::App* command, Options& options) {
  command->add_option("scene", options.scene, "Id or name of the scene")->required();
}

void add_parameter_option(CLI::App* command, Parameters& into, const char* flag, const char* parameter,
                          const char* help) {
  command->add_option_function<std::string>(
      flag, [&into, parameter](const std::string& value) { into.emplace_back(parameter, value); }, help);
}

void add_pairs(const std::vector<std::string>& texts, Parameters& pairs) {
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    pairs.emplace_back(text.substr(0, equals), text.substr(std::min(equals + 1, text.size())));
  }
}

void add_variables(CLI::App* command, Options& options) {
  command->add_option_function<std::vector<std::string>>(
      "--set", [&options](const std::vector<std::string>& texts) { add_pairs(texts, options.variables); },
      "NAME=VALUE for a recipe's variable, JSON or plain text; may be repeated");
  command->add_option(
      "--places", options.places,
      "JSON file of named places, as `pelage pick` writes it; they replace variables and picks so named");
}

}  // namespace pelage
