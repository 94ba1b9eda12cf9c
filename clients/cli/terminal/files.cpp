#include "clients/cli/terminal/files.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "base/temporary_name.h"

namespace pelage {

namespace {

Status cannot_write(const std::string& path) {
  return with_next(failure(Code::internal, "Cannot write " + path + "."),
                   "name a file in a folder that exists, in which you may write and which has room");
}

}  // namespace

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
  // Opening a folder succeeds; only the first read fails.
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
                                 "see why the pipe's reader ended, or name a file");
  }
  NewFile file(path);
  file.write(bytes);
  return file.commit();
}

NewFile::NewFile(std::string path)
    : path_(std::move(path)), temporary_(temporary_beside(path_)), file_(temporary_, std::ios::binary) {}

NewFile::~NewFile() {
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

bool NewFile::write(std::string_view chunk) {
  return static_cast<bool>(file_.write(chunk.data(), static_cast<std::streamsize>(chunk.size())));
}

Status NewFile::commit() {
  file_.close();
  if (file_ && std::rename(temporary_.c_str(), path_.c_str()) == 0) {
    temporary_.clear();
    return {};
  }
  return cannot_write(path_);
}

Status check_output(const std::string& path) {
  if (path == "-") return {};
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return cannot_write(path);
  const NewFile probe(path);
  return probe.file_ ? Status{} : cannot_write(path);
}

}  // namespace pelage
