#include "protocol/json/decode_answers.h"

#include "protocol/json/decode_document.h"

namespace pelage {

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
template Result<Comparison> decode_answer(std::string_view);
template Result<FoldCount> decode_answer(std::string_view);
template Result<Log> decode_answer(std::string_view);
template Result<FrameEstimate> decode_answer(std::string_view);
template Result<FrameCounters> decode_answer(std::string_view);
template Result<TraceReport> decode_answer(std::string_view);
template Result<MapAnswer> decode_answer(std::string_view);
template Result<PictureAnswer> decode_answer(std::string_view);
template Result<Problem> decode_answer(std::string_view);

}  // namespace pelage
