#include "protocol/json/decode.h"

#include "protocol/json/members_scene.h"
#include "protocol/json/read.h"

namespace pelage {

namespace {

using namespace json_parts;

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// Decodes a document; an empty body means all defaults.
template <class T>
Result<T> decode_optional_document(std::string_view text) {
  return is_blank(text) ? Result<T>(T{}) : decode_document<T>(text);
}

/// Decodes a batch; a single command is a batch of one.
Result<Batch> decode_batch(std::string_view text) {
  const auto tree = parse_json(text);
  if (!tree) return tree.status();
  Status first_failure;
  const Value value(*tree, "", first_failure);
  Batch result;
  if (tree->is_object() && tree->contains("commands")) {
    result = read<Batch>(value);
  } else {
    result.commands.push_back(read<Command>(value));
  }
  if (!first_failure.ok()) return first_failure;
  return result;
}

}  // namespace

Result<std::vector<Command>> decode_commands(std::string_view text) {
  auto batch = decode_batch(text);
  if (!batch) return batch.status();
  return std::move(batch->commands);
}

Result<NewScene> decode_new_scene(std::string_view text) { return decode_document<NewScene>(text); }

Result<FrameRequest> decode_frame_request(std::string_view text, FrameFormat usual) {
  auto tree = parse_json(text);
  if (!tree) return tree.status();
  const bool names_one = !tree->is_object() || tree->contains("format");
  if (!names_one) (*tree)["format"] = json_names::text_of(json_names::frame_formats, usual);
  return decode_tree<FrameRequest>(*tree);
}

Result<RenderJob> decode_job(std::string_view text) { return decode_document<RenderJob>(text); }

Result<PickRequest> decode_pick(std::string_view text) { return decode_document<PickRequest>(text); }

Result<RecipeRequest> decode_recipe(std::string_view text) { return decode_document<RecipeRequest>(text); }

Result<int> decode_steps(std::string_view text) {
  const auto body = decode_optional_document<StepsBody>(text);
  if (!body) return body.status();
  return body->steps;
}

Result<Subdivide> decode_subdivide(std::string_view text) { return decode_optional_document<Subdivide>(text); }
Result<TurnModel> decode_turn_model(std::string_view text) { return decode_optional_document<TurnModel>(text); }

Result<SceneName> decode_scene_name(std::string_view text) { return decode_document<SceneName>(text); }

Result<BranchRequest> decode_branch(std::string_view text) { return decode_optional_document<BranchRequest>(text); }

Result<AmendRequest> decode_amend(std::string_view text) { return decode_document<AmendRequest>(text); }

Result<std::uint64_t> decode_revision(std::string_view text) {
  const auto body = decode_document<RevisionBody>(text);
  if (!body) return body.status();
  return body->revision;
}

template <class T>
Result<T> decode_answer(std::string_view text) {
  Result<T> answer = json_parts::decode_document<T>(text, Reading::tolerant);
  if (answer || answer.status().code == Code::malformed) return answer;
  return failure(Code::malformed, "The server's answer is not what this client knows.", answer.status().pointer);
}

template Result<CommandAnswer> decode_answer(std::string_view);
template Result<SceneSummary> decode_answer(std::string_view);
template Result<SceneList> decode_answer(std::string_view);
template Result<PickAnswer> decode_answer(std::string_view);
template Result<RecipeAnswer> decode_answer(std::string_view);
template Result<Comparison> decode_answer(std::string_view);
template Result<SettingsAnswer> decode_answer(std::string_view);
template Result<Log> decode_answer(std::string_view);
template Result<SceneEvent> decode_answer(std::string_view);
template Result<ChangeEvent> decode_answer(std::string_view);
template Result<FrameEstimate> decode_answer(std::string_view);
template Result<FrameCounters> decode_answer(std::string_view);
template Result<FrameCost> decode_answer(std::string_view);
template Result<ExportAnswer> decode_answer(std::string_view);
template Result<FrameProgressList> decode_answer(std::string_view);
template Result<TraceReport> decode_answer(std::string_view);
template Result<MapAnswer> decode_answer(std::string_view);
template Result<PictureAnswer> decode_answer(std::string_view);
template Result<Problem> decode_answer(std::string_view);

}  // namespace pelage
