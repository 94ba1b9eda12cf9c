#include "clients/cli/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace pelage {

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& stream = path == "-" ? std::cin : file;
  std::string bytes;
  char block[1 << 16];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    bytes.append(block, static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > max_bytes) {
      return failure(Code::too_large, path + " is too large.", "", fmt::format("at most {} bytes", max_bytes));
    }
  }
  // A folder opens as a file and fails at the first read.
  if (stream.bad() || (path != "-" && !file.is_open())) {
    return with_next(failure(Code::not_found, "Cannot read " + path + "."),
                     "name a file that exists and that you may read; - is standard input");
  }
  return bytes;
}

Status write_file(const std::string& path, const std::string& bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout ? Status{}
                     : with_next(failure(Code::internal, "Cannot write to standard output."),
                                 "see why its reader ended, or name a file");
  }
  const std::string temporary = fmt::format("{}.{}", path, getpid());
  std::ofstream file(temporary, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file && std::rename(temporary.c_str(), path.c_str()) == 0) return {};
  std::remove(temporary.c_str());
  return with_next(failure(Code::internal, "Cannot write " + path + "."),
                   "name a file in a folder that exists, in which you may write and which has room");
}

ExitCode hand_over(const char* program, char* const* arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string path = self.parent_path() / program;
  execv(path.c_str(), arguments);
  return report(with_next(failure(Code::internal, "Cannot start " + path + "; it belongs beside pelage."),
                          "build or install all programs in one folder"));
}

}  // namespace pelage
