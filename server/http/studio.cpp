#include "server/http/studio.h"

#include <algorithm>

namespace pelage {

const StudioFile* find_studio_file(std::string_view path) {
  const auto files = studio_files();
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const StudioFile& file) { return file.path == path; });
  return found == files.end() ? nullptr : &*found;
}

}  // namespace pelage
