#include "server/batch/file_pattern.h"

#include <cstdlib>
#include <filesystem>

namespace pelage {

Result<FilePattern> FilePattern::create(const std::string& pattern, const std::string& folder,
                                        const std::string& pointer) {
  const std::filesystem::path path(pattern);
  const std::string full_path = (path.is_absolute() ? path : std::filesystem::path(folder) / path).string();
  const std::size_t name = full_path.size() - path.filename().string().size(), first = full_path.find('#', name);
  if (full_path.find('#') < name)
    return failure(Code::invalid, "A folder's name has a #.", pointer, "# in the name of the file only");
  FilePattern result;
  result.before_ = full_path.substr(0, first);
  if (first == std::string::npos) return result;
  const std::size_t last = full_path.find_first_not_of('#', first);
  if (last != std::string::npos && full_path.find('#', last) != std::string::npos)
    return failure(Code::invalid, "A file name has one run of # for the number of the frame.", pointer, "one run of #");
  if (last != std::string::npos) result.after_ = full_path.substr(last);
  result.digits_ = std::min(last, full_path.size()) - first;
  return result;
}

std::string FilePattern::file(int frame) const {
  if (digits_ == 0) return before_;
  const std::string number = std::to_string(std::abs(frame));
  const std::string zeros(digits_ > number.size() ? digits_ - number.size() : 0, '0');
  return before_ + (frame < 0 ? "-" : "") + zeros + number + after_;
}

}  // namespace pelage
