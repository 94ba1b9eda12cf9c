// The parts of the command line: what they are called, what they say and where their values go.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/options.h"

namespace CLI {
class App;
}

namespace pelage {

/// A command with its examples, for what the options' `action` says.
CLI::App* add_action(CLI::App& app, Options& options, Action action, const char* name, const char* help);

void add_scene(CLI::App* command, Options& options);

/// Options whose values are handed on under the name that an address knows them by.
void hand_on(CLI::App* command, Parameters& into, const char* flag, const char* parameter, const char* help);

/// NAME=VALUE, each.
void add_pairs(const std::vector<std::string>& texts, Parameters& pairs);

/// What a recipe's variables are.
void add_variables(CLI::App* command, Options& options);

/// The whole line: all that stands below, and the program's own options.
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
