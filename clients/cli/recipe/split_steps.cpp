#include "clients/cli/recipe/split_steps.h"

#include <algorithm>

#include "protocol/json/parse.h"

namespace pelage {

namespace {

using nlohmann::json;

std::vector<std::string_view> nonblank_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

Result<std::vector<std::string>> split_steps(std::string_view text) {
  std::vector<std::string> steps;
  const auto document = parse_json(text);
  if (document) {
    if (!document->is_array()) return std::vector<std::string>{document->dump()};
    for (const json& member : *document) steps.push_back(member.dump());
    return steps;
  }
  const std::vector<std::string_view> lines = nonblank_lines(text);
  if (lines.empty()) return failure(Code::malformed, "There are no commands in it.");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (const auto step = parse_json(lines[i]); !step) {
      if (i == 0) return document.status();  // a single document with a syntax error
      Status status = step.status();
      status.message = "Line " + std::to_string(i + 1) + " (empty ones not counted): " + status.message;
      return status;
    }
    steps.emplace_back(lines[i]);
  }
  return steps;
}

}  // namespace pelage
