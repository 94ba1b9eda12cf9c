#include "clients/cli/actions/steps.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "clients/cli/recipe/split_steps.h"
#include "clients/cli/terminal/files.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::size_t command_file_bytes = std::size_t{1} << 30;

Result<ModelReport> model_at(Session& session, const std::string& path) {
  const auto answer = Session::accepted(session.connection().get(path));
  if (!answer) return answer.status();
  const auto summary = decode_answer<SceneSummary>(answer->body);
  return summary ? Result<ModelReport>(summary->report) : summary.status();
}

/// Returns the recipe, completed by the options, the model and the server. It refers to all that it is made of.
Result<Recipe> completed(Session& session, const std::string& path, const std::string& text, RunPlan& plan) {
  const Options& options = session.options();
  const auto model = model_at(session, path);
  if (!model) return model.status();
  Recipe recipe{options.file, text, options.variables, model->bounds.min, model->bounds.max, {}};
  recipe.read = [&plan](const std::string& file) {
    plan.files.push_back(file);
    return read_file(file, recipe_file_bytes);
  };
  recipe.pick = [&session, path](const std::string& request) -> Result<std::string> {
    const auto answer = Session::accepted(session.connection().post_json(path + "/pick", request));
    return answer ? Result<std::string>(answer->body) : answer.status();
  };
  if (options.places.empty()) return recipe;
  const auto places = recipe.read(options.places);
  if (!places) return places.status();
  recipe.places = *places, recipe.places_file = options.places;
  return recipe;
}

Status steps_of_recipe(Session& session, const std::string& path, const std::string& text, RunPlan& plan) {
  const auto recipe = completed(session, path, text, plan);
  if (!recipe) return recipe.status();
  const auto expanded = expand_recipe(*recipe);
  if (!expanded) return expanded.status();
  for (const RecipeStep& step : *expanded) {
    const std::string place = fmt::format("step {} of {}, {}", plan.steps.size() + 1, expanded->size(), step.file);
    plan.steps.push_back({step.text, {}, place, step.pointer, step.asserts});
  }
  return {};
}

Status steps_of_log(const Options& options, const std::string& text, RunPlan& plan) {
  if (!options.variables.empty() || !options.places.empty())
    return failure(Code::invalid, options.file + " is no recipe: it has no variables to set.", "",
                   "without --set and --places");
  const auto texts = split_steps(text);
  if (!texts) return texts.status();
  for (const std::string& one : *texts) {
    const std::string place = fmt::format("step {} of {} of {}", plan.steps.size() + 1, texts->size(), options.file);
    plan.steps.push_back({one, {}, place, "", {}});
  }
  return {};
}

Status check(RunStep& step) {
  if (step.text.size() > limits::command_body_bytes) {
    return failure(Code::too_large, fmt::format("The step has {} bytes.", step.text.size()), step.pointer,
                   fmt::format("at most {} bytes", limits::command_body_bytes));
  }
  auto commands = decode_commands(step.text);
  if (commands) {
    step.commands = std::move(*commands);
    return {};
  }
  Status status = commands.status();
  status.pointer.insert(0, step.pointer);
  return status;
}

/// Puts ids in place of the names of scenes that fields are taken from.
Status name_sources(Session& session, RunStep& step) {
  bool named = false;
  for (std::size_t k = 0; k < step.commands.size(); ++k) {
    auto* retarget = std::get_if<Retarget>(&step.commands[k]);
    if (retarget == nullptr) continue;
    const auto id = session.scene_id(retarget->scene);
    if (!id) {
      Status status = id.status();
      const std::string place = step.commands.size() > 1 ? fmt::format("/commands/{}", k) : "";
      status.pointer = step.pointer + place + "/scene";
      return status;
    }
    named = named || *id != retarget->scene;
    retarget->scene = *id;
  }
  if (named) step.text = encode(step.commands);
  return {};
}

}  // namespace

Status read_steps(Session& session, const std::string& path, RunPlan& plan) {
  const Options& options = session.options();
  plan = {{}, options.file, {options.file}};
  const auto text = read_file(options.file, command_file_bytes);
  if (!text) return text.status();
  Status status = is_recipe(*text) ? steps_of_recipe(session, path, *text, plan) : steps_of_log(options, *text, plan);
  for (RunStep& step : plan.steps) {
    if (!status.ok()) break;
    plan.place = step.place;
    status = check(step);
    if (status.ok()) status = name_sources(session, step);
  }
  return status;
}

Status check_asserts(const RunStep& step, const std::vector<CommandResult>& results) {
  for (std::size_t k = 0; k < std::min(step.asserts.size(), results.size()); ++k) {
    const auto& limits = step.asserts[k];
    const std::size_t touched = results[k].touched;
    if (!limits || (limits->min <= touched && touched <= limits->max)) continue;
    const std::string command = step.asserts.size() > 1 ? fmt::format("/commands/{}", k) : "";
    const std::string most = limits->max == TouchLimits{}.max ? "or more" : fmt::format("to {}", limits->max);
    return with_next(failure(Code::invalid, fmt::format("{} touched {} vertices.", results[k].op, touched),
                             step.pointer + command + "/assert", fmt::format("{} {}", limits->min, most)),
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
