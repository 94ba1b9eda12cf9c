// What a client reads of the server's answers. Unknown members are passed over, so that an older client lives on.
#pragma once

#include <string_view>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/map.h"

namespace pelage {

// All of these refuse (malformed) what is no such answer.
Result<CommandAnswer> decode_command_answer(std::string_view text);
Result<SceneSummary> decode_scene_summary(std::string_view text);
Result<std::vector<SceneSummary>> decode_scene_list(std::string_view text);
Result<PickAnswer> decode_pick_answer(std::string_view text);
Result<PictureAnswer> decode_picture_answer(std::string_view text);
Result<TraceReport> decode_trace_report(std::string_view text);
Result<std::vector<LogEntry>> decode_log(std::string_view text);

/// The refusal in a problem document; its code follows the `type`. Malformed when it is no problem document.
Status decode_problem(std::string_view text);

}  // namespace pelage
