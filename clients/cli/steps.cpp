#include "clients/cli/steps.h"

#include <fmt/format.h>

#include "clients/cli/print.h"
#include "clients/cli/recipe/recipe.h"
#include "clients/cli/recipe/split_steps.h"
#include "protocol/base/limits.h"
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

Result<std::vector<RunStep>> steps_of_recipe(Session& session, const std::string& path, const std::string& text) {
  const Options& options = session.options();
  const auto model = model_at(session, path);
  if (!model) return model.status();
  const auto read = [](const std::string& file) { return read_file(file, recipe_file_bytes); };
  const auto expanded =
      expand_recipe({options.file, text, options.variables, model->bounds.min, model->bounds.max, read});
  if (!expanded) return expanded.status();
  std::vector<RunStep> steps;
  for (const RecipeStep& step : *expanded) {
    const std::string place = fmt::format("step {} of {}, {}", steps.size() + 1, expanded->size(), step.file);
    steps.push_back({step.text, {}, place, step.pointer});
  }
  return steps;
}

Result<std::vector<RunStep>> steps_of_log(const Options& options, const std::string& text) {
  if (!options.variables.empty())
    return failure(Code::invalid, options.file + " is no recipe: it has no variables to set.", "/variables");
  const auto texts = split_steps(text);
  if (!texts) return texts.status();
  std::vector<RunStep> steps;
  for (const std::string& one : *texts) {
    const std::string place = fmt::format("step {} of {} of {}", steps.size() + 1, texts->size(), options.file);
    steps.push_back({one, {}, place, ""});
  }
  return steps;
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

Result<std::vector<RunStep>> read_steps(Session& session, const std::string& path, std::string& place) {
  const Options& options = session.options();
  place = options.file;
  const auto text = read_file(options.file, command_file_bytes);
  if (!text) return text.status();
  auto steps = is_recipe(*text) ? steps_of_recipe(session, path, *text) : steps_of_log(options, *text);
  if (!steps) return steps;
  for (RunStep& step : *steps) {
    place = step.place;
    if (const Status bad = check(step); !bad.ok()) return bad;
    if (const Status bad = name_sources(session, step); !bad.ok()) return bad;
  }
  return steps;
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
