#include "clients/cli/hand_over.h"

#include <unistd.h>

#include <filesystem>
#include <string>

namespace pelage {

ExitCode hand_over(const char* program, char* const* arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string path = self.parent_path() / program;
  execv(path.c_str(), arguments);
  return report(failure(Code::internal, "Cannot start " + path + "; it belongs beside pelage."));
}

}  // namespace pelage
