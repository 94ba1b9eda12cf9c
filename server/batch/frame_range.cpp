#include "server/batch/frame_range.h"

#include <charconv>
#include <string>
#include <unordered_set>

namespace pelage {

namespace {

constexpr int max_number = 1'000'000;
constexpr std::size_t max_frames = 1'000'000;

Status refused_part(std::string_view part, const char* why = "is no range of frames") {
  return failure(Code::invalid, "\"" + std::string(part) + "\" " + why + ".", "/frames", "as 1-100, 1-100x5 or 1,4,9");
}

/// Removes a number from the front of the text. Returns false if there is none in range.
bool take_number(std::string_view& text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < -max_number || number > max_number) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

Status add_part(std::string_view part, std::vector<int>& frames) {
  std::string_view remaining = part;
  int first = 0, last = 0, step = 1;
  if (!take_number(remaining, first)) return refused_part(part);
  last = first;
  if (take(remaining, "-") && !take_number(remaining, last)) return refused_part(part);
  if (take(remaining, "x:") && !take_number(remaining, step)) return refused_part(part);
  if (!remaining.empty()) return refused_part(part);
  if (last < first) return refused_part(part, "ends before it begins");
  if (step < 1) return refused_part(part, "has a step below 1");
  for (int frame = first; frame <= last && frames.size() <= max_frames; frame += step) frames.push_back(frame);
  if (frames.size() > max_frames)
    return failure(Code::invalid, "There are too many frames.", "/frames", "at most 1000000");
  return {};
}

}  // namespace

Result<std::vector<int>> parse_frames(std::string_view text) {
  std::vector<int> frames;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    if (Status added = add_part(text.substr(0, comma), frames); !added.ok()) return added;
    more = comma != std::string_view::npos;
    if (more) text.remove_prefix(comma + 1);
  }
  std::unordered_set<int> seen;
  for (const int frame : frames) {
    if (!seen.insert(frame).second)
      return failure(Code::invalid, "Frame " + std::to_string(frame) + " is named twice.", "/frames",
                     "each frame once");
  }
  return frames;
}

}  // namespace pelage
