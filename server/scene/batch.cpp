#include "server/scene/batch.h"

#include <chrono>

#include "protocol/json/encode.h"
#include "server/groom/evaluate.h"

namespace pelage {

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

std::string text_of(const SceneSettings& settings) {
  return encode(commands_of(settings));
}

/// Carries out a command that sets something about the scene; whether that made a difference.
bool set(const Command& command, SceneSettings& settings) {
  const std::optional<SceneSettings> after = with_setting(settings, command);
  if (!after || text_of(*after) == text_of(settings)) return false;
  settings = *after;
  return true;
}

}  // namespace

CommandResult describe_change(const char* op, const FieldDelta& delta, const FieldSet& fields) {
  CommandResult result;
  result.op = op;
  result.touched = delta.vertices().size();
  result.fields = measure(delta, fields);
  if (!result.fields.empty()) {
    result.mean_change = result.fields.front().mean_change;
    result.max_change = result.fields.front().max_change;
  }
  return result;
}

Outcome evaluate_batch(const std::vector<Command>& commands, const FieldDelta& start, const Surface& surface,
                       FieldSet& fields, const SceneSettings& settings) {
  Outcome outcome;
  SceneSettings set_so_far = settings;
  bool any_set = false;
  fields.apply(start);
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const auto begin = std::chrono::steady_clock::now();
    const Evaluation evaluation = evaluate(commands[k], surface, fields);
    fields.apply(evaluation.delta);
    const FieldDelta change = k == 0 ? compose(start, evaluation.delta) : evaluation.delta;
    outcome.delta = compose(outcome.delta, change);
    outcome.results.push_back(describe_change(op_of(commands[k]), change, fields));
    outcome.results.back().clamped = evaluation.clamped;
    outcome.results.back().milliseconds = milliseconds_since(begin);
    const bool setting = set(commands[k], set_so_far);
    any_set = any_set || setting;
    if (setting || !change.empty()) outcome.effective.push_back(k);
  }
  outcome.fields_hash = fields.hash();
  if (any_set) outcome.settings = std::make_shared<const SceneSettings>(std::move(set_so_far));
  fields.apply(outcome.delta);
  return outcome;
}

}  // namespace pelage
