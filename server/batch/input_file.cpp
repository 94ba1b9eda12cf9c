#include "server/batch/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "server/import/import.h"

namespace pelage {

namespace {

/// Owns a file descriptor; -1 if the file cannot be opened.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path)  // O_NONBLOCK: does not wait for the writer of a pipe
      : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

Status cannot_read(const std::string& path, const std::string& why) {
  return failure(Code::not_found, path + " cannot be read: " + why + ".");
}

}  // namespace

Result<ModelFormat> format_of_file(const std::string& path, const std::string& pointer) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto found = std::ranges::find(worker_format_names, ending.empty() ? ending : ending.substr(1));
  if (found != worker_format_names.end()) return static_cast<ModelFormat>(found - worker_format_names.begin());
  return failure(
      Code::invalid, "The file is no model by its ending.", pointer,
      std::string(pointer == "/scene" ? ".pelage, " : "") + ".obj, .ply, .stl, .off, .gltf, .glb, .3ds or .zip");
}

Result<std::string> read_file(const std::string& path) {
  const OpenFile file(path);
  struct stat about {};
  if (file.descriptor() < 0 || ::fstat(file.descriptor(), &about) != 0) return cannot_read(path, std::strerror(errno));
  if (S_ISDIR(about.st_mode)) return cannot_read(path, std::strerror(EISDIR));
  if (!S_ISREG(about.st_mode)) return cannot_read(path, "It is a pipe or a device, not a file");
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(about.st_size));
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t got = ::read(file.descriptor(), block.data(), block.size());
    if (got == 0) return bytes;
    if (got > 0) bytes.append(block.data(), static_cast<std::size_t>(got));
    if (got < 0 && errno != EINTR) return cannot_read(path, std::strerror(errno));
  }
}

Status in_file(const std::string& path, Status status) {
  status.message = path + ": " + status.message;
  return status;
}

}  // namespace pelage
