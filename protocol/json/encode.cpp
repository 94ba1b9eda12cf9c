#include "protocol/json/encode.h"

#include "protocol/json/members_scene.h"
#include "protocol/json/write.h"

namespace pelage {

using json_parts::line;
using json_parts::written;

std::string encode(const Command& command) { return line(written(command)); }
std::string encode(const NewScene& request) { return line(written(request)); }
std::string encode(const FrameRequest& request) { return line(written(request)); }
std::string encode(const BranchRequest& request) { return line(written(request)); }
std::string encode(const AmendRequest& request) { return line(written(request)); }
std::string encode(const PickRequest& request) { return line(written(request)); }
std::string encode(const Knobs& knobs) { return line(written(knobs)); }

std::string encode(const std::vector<Command>& commands) {
  return commands.size() == 1 ? encode(commands.front()) : line(written(json_parts::Batch{commands}));
}

std::string json_text(std::string_view text) { return line(json_parts::Json(text)); }

}  // namespace pelage
