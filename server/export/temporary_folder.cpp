#include "server/export/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

namespace pelage {

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code error;
  std::string path = (std::filesystem::temp_directory_path(error) / "pelage-XXXXXX").string();
  if (error || mkdtemp(path.data()) == nullptr)
    return failure(Code::internal, "a temporary folder cannot be made; see that TMPDIR can be written and has room");
  return TemporaryFolder(std::move(path));
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace pelage
