#include "server/batch/output_pattern.h"

#include <cstdlib>
#include <filesystem>

namespace pelage {

namespace {

Status bad_pattern(std::string message, std::string limit) {
  return failure(Code::invalid, std::move(message), "/output", std::move(limit));
}

}  // namespace

Result<OutputPattern> OutputPattern::create(const std::string& pattern, const std::string& folder, bool several) {
  const std::filesystem::path path(pattern);
  const std::string ending = path.extension().string();
  if (ending != ".png" && ending != ".exr")
    return bad_pattern("Frames are written as PNG or EXR, by the ending of the name.", ".png or .exr");
  OutputPattern result;
  result.format_ = ending == ".png" ? FrameFormat::png : FrameFormat::exr;
  const std::string whole = (path.is_absolute() ? path : std::filesystem::path(folder) / path).string();
  const std::size_t name = whole.size() - path.filename().string().size(), first = whole.find('#', name);
  if (whole.find('#') < name) return bad_pattern("A folder's name has a #.", "# in the name of the file only");
  if (first == std::string::npos && several)
    return bad_pattern("All frames would go to one file.", "# for the digits of the frame, as fox.####.png");
  const std::size_t last = first == std::string::npos ? first : whole.find_first_not_of('#', first);
  if (last != std::string::npos && whole.find('#', last) != std::string::npos)
    return bad_pattern("The digits of a frame stand in one place.", "one run of #");
  result.before_ = whole.substr(0, first);
  if (first == std::string::npos) return result;
  result.after_ = whole.substr(last), result.digits_ = last - first;
  return result;
}

std::string OutputPattern::file(int frame) const {
  if (digits_ == 0) return before_;
  const std::string number = std::to_string(std::abs(frame));
  const std::string zeros(digits_ > number.size() ? digits_ - number.size() : 0, '0');
  return before_ + (frame < 0 ? "-" : "") + zeros + number + after_;
}

}  // namespace pelage
