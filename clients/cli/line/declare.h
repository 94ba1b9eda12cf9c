// Declares the command line: names, help texts, and the members of Options that take the values.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/options.h"

namespace CLI {
class App;
}

namespace pelage {

/// Adds a command with its examples. Parsing it sets `options.action`.
CLI::App* add_action(CLI::App& app, Options& options, Action action, const char* name, const char* help);

void add_scene(CLI::App* command, Options& options);

/// Adds an option whose value is appended to `into` as a query parameter named `parameter`.
void add_parameter_option(CLI::App* command, Parameters& into, const char* flag, const char* parameter,
                          const char* help);

/// Splits each text NAME=VALUE and appends the pair to `pairs`.
void add_pairs(const std::vector<std::string>& texts, Parameters& pairs);

/// Adds the options that set a recipe's variables.
void add_variables(CLI::App* command, Options& options);

/// Declares the whole command line: the program's own options and all commands.
void declare_line(CLI::App& app, Options& options);

void declare_scene_actions(CLI::App& app, Options& options);
void declare_model_actions(CLI::App& app, Options& options);
void declare_groom_actions(CLI::App& app, Options& options);
void declare_history_actions(CLI::App& app, Options& options);
void declare_picture_actions(CLI::App& app, Options& options);
void declare_file_actions(CLI::App& app, Options& options);
void declare_program_actions(CLI::App& app, Options& options);
void declare_farm_actions(CLI::App& app, Options& options);

}  // namespace pelage
