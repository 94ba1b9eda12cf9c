#include "clients/cli/actions/steps.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "clients/cli/recipe/gather.h"
#include "clients/cli/recipe/split_steps.h"
#include "clients/cli/terminal/files.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::size_t max_command_file_bytes = std::size_t{1} << 30;

Result<RecipeRequest> request_of(const Options& options, const std::string& text, RunPlan& plan) {
  const auto read = [&plan](const std::string& file) {
    plan.files.push_back(file);
    return read_file(file, limits::recipe_bytes);
  };
  RecipeSource source{options.file, text, options.variables};
  if (!options.places.empty()) {
    const auto places = read(options.places);
    if (!places) return places.status();
    source.places = *places, source.places_file = options.places;
  }
  return gather_recipe(source, read);
}

/// Rewrites a refusal of the server so that its JSON pointer refers to the file that the message names.
Status with_file_pointer(const Options& options, const Status& refused) {
  Status status = refused;
  if (status.pointer.starts_with("/places")) status.message.insert(0, options.places + ": ");
  status.pointer = pointer_in_file(status.pointer);
  return status;
}

Status steps_of_recipe(Session& session, const std::string& path, const std::string& text, RunPlan& plan) {
  const auto request = request_of(session.options(), text, plan);
  if (!request) return request.status();
  const auto answer = Session::accepted(session.connection().post_json(path + "/recipe", encode(*request)));
  if (!answer) return with_file_pointer(session.options(), answer.status());
  const auto recipe = decode_answer<RecipeAnswer>(answer->body);
  if (!recipe) return recipe.status();
  for (const RecipeStep& step : recipe->steps) {
    const std::string location =
        fmt::format("step {} of {}, {}", plan.steps.size() + 1, recipe->steps.size(), step.file);
    plan.steps.push_back({encode(step.commands), step.commands, location, pointer_in_file(step.pointer), step.asserts});
  }
  return {};
}

/// Decodes `step.text` into `step.commands`.
Status decode_step(RunStep& step) {
  if (step.text.size() > limits::command_body_bytes) {
    return failure(Code::too_large, fmt::format("The step has {} bytes.", step.text.size()), "",
                   fmt::format("at most {} bytes", limits::command_body_bytes));
  }
  auto commands = decode_commands(step.text);
  if (!commands) return commands.status();
  step.commands = std::move(*commands);
  return {};
}

Status steps_of_log(const Options& options, const std::string& text, RunPlan& plan) {
  if (!options.variables.empty() || !options.places.empty())
    return failure(Code::invalid, options.file + " is no recipe: it has no variables to set.", "",
                   "without --set and --places");
  const auto texts = split_steps(text);
  if (!texts) return texts.status();
  for (const std::string& one : *texts) {
    const std::string location = fmt::format("step {} of {} of {}", plan.steps.size() + 1, texts->size(), options.file);
    plan.location = location;
    RunStep& step = plan.steps.emplace_back(RunStep{one, {}, location, "", {}});
    if (Status bad = decode_step(step); !bad.ok()) return bad;
  }
  return {};
}

/// Replaces scene names by ids in `retarget` commands, which copy fields from another scene.
Status resolve_scene_names(Session& session, RunStep& step) {
  bool replaced = false;
  for (std::size_t k = 0; k < step.commands.size(); ++k) {
    auto* retarget = std::get_if<Retarget>(&step.commands[k]);
    if (retarget == nullptr) continue;
    const auto id = session.scene_id(retarget->scene);
    if (!id) {
      Status status = id.status();
      const std::string location = step.commands.size() > 1 ? fmt::format("/commands/{}", k) : "";
      status.pointer = step.pointer + location + "/scene";
      return status;
    }
    replaced = replaced || *id != retarget->scene;
    retarget->scene = *id;
  }
  if (replaced) step.text = encode(step.commands);
  return {};
}

}  // namespace

Status read_steps(Session& session, const std::string& path, RunPlan& plan) {
  const Options& options = session.options();
  plan = {{}, options.file, {options.file}};
  const auto text = read_file(options.file, max_command_file_bytes);
  if (!text) return text.status();
  Status status = is_recipe(*text) ? steps_of_recipe(session, path, *text, plan) : steps_of_log(options, *text, plan);
  for (RunStep& step : plan.steps) {
    if (!status.ok()) break;
    plan.location = step.location;
    status = resolve_scene_names(session, step);
  }
  return status;
}

Status check_asserts(const RunStep& step, const std::vector<CommandResult>& results) {
  for (const TouchLimits& limits : step.asserts) {
    if (limits.command >= results.size()) continue;
    const CommandResult& result = results[limits.command];
    const std::uint64_t min = limits.min_vertices.value_or(0);
    if (min <= result.touched && (!limits.max_vertices || result.touched <= *limits.max_vertices)) continue;
    const std::string command = step.commands.size() > 1 ? fmt::format("/commands/{}", limits.command) : "";
    const std::string max_text = limits.max_vertices ? fmt::format("to {}", *limits.max_vertices) : "or more";
    return with_next(failure(Code::invalid, fmt::format("{} touched {} vertices.", result.op, result.touched),
                             step.pointer + command + "/assert", fmt::format("{} {}", min, max_text)),
                     "look at the picture, and correct the place, the radius or the assert");
  }
  return {};
}

Result<std::string> batch_of(const std::vector<RunStep>& steps) {
  std::vector<Command> all;
  for (const RunStep& step : steps) all.insert(all.end(), step.commands.begin(), step.commands.end());
  const std::string limit =
      fmt::format("at most {} commands and {} bytes", limits::commands_per_batch, limits::command_body_bytes);
  if (all.size() > limits::commands_per_batch)
    return failure(Code::too_large, fmt::format("{} commands are too many for a dry run.", all.size()), "", limit);
  std::string batch = encode(all);
  if (batch.size() <= limits::command_body_bytes) return batch;
  return failure(Code::too_large, fmt::format("{} bytes are too many for a dry run.", batch.size()), "", limit);
}

}  // namespace pelage
