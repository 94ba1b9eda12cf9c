#include "server/history/journal_guard.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "server/history/checksum.h"

namespace pelage {

namespace {

constexpr off_t max_text_bytes = 1 << 14;

std::string reserve_of(const std::string& path) { return path + "-reserve"; }

std::optional<LogTails> tails_in(const std::string& path) {
  std::ifstream file(path);
  LogTails tails;
  std::string line, read;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string id;
    LogTail tail;
    words >> id;
    if (id == "end") {
      std::uint64_t sum = 0;
      words >> std::hex >> sum;
      return sum == checksum_of(read) ? std::optional(std::move(tails)) : std::nullopt;
    }
    words >> tail.revision >> std::hex >> tail.chain;
    tails[id] = tail;
    read += line + "\n";
  }
  return {};
}

}  // namespace

Result<FolderLock> FolderLock::of(const std::string& path) {
  const std::string folder = std::filesystem::absolute(path).parent_path().string();
  FolderLock lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.folder_ < 0) return failure(Code::internal, "the data folder " + folder + " cannot be opened");
  if (flock(lock.folder_, LOCK_EX | LOCK_NB) == 0) return Result<FolderLock>(std::move(lock));
  return failure(Code::unavailable, "the journal cannot be used: another server uses the data folder " + folder);
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

JournalGuard::JournalGuard(std::string path, FolderLock lock)
    : path_(std::move(path)),
      lock_(std::move(lock)),
      journal_(file_at(path_)),
      wal_(file_at(path_ + "-wal")),
      acknowledged_(tails_in(path_ + "-acknowledged")),
      tails_file_(open((path_ + "-acknowledged").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  // Allocates all blocks that the text can need, so that a full disk does not truncate it.
  static_cast<void>(posix_fallocate(tails_file_, 0, max_text_bytes));
  allocate_reserve();
}

JournalGuard::~JournalGuard() {
  if (tails_file_ >= 0) close(tails_file_);
}

std::optional<JournalGuard::File> JournalGuard::file_at(const std::string& path) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return {};
  return File{found.st_dev, found.st_ino};
}

Status JournalGuard::files_in_place() const {
  for (const auto& [path, file] : {std::pair(path_, journal_), std::pair(path_ + "-wal", wal_)}) {
    if (file_at(path) == file) continue;
    return failure(Code::unavailable,
                   fmt::format("the journal's file {} has been removed or replaced while the server runs: nothing more "
                               "is changed; export what is needed, then start the server anew",
                               std::filesystem::path(path).filename().string()));
  }
  return {};
}

std::uint64_t JournalGuard::free_space_at(const std::string& path) {
  struct statvfs disk {};
  if (statvfs(std::filesystem::path(path).parent_path().c_str(), &disk) != 0) return 0;
  return std::uint64_t{disk.f_bavail} * disk.f_frsize;
}

/// Returns a line for each log, then a line with their checksum. What an earlier, longer text left behind that line is
/// not read.
std::string JournalGuard::text_of(const LogTails& tails) {
  std::string text;
  for (const auto& [id, tail] : tails) text += fmt::format("{} {} {:x}\n", id, tail.revision, tail.chain);
  return text + fmt::format("end {:x}\n", checksum_of(text));
}

// One write to allocated blocks needs no room on the disk, and a kill leaves the old text or the new one. If the write
// fails, the old text stays, which only acknowledges less.
void JournalGuard::acknowledge(const std::string& text) noexcept {
  static_cast<void>(!pwrite(tails_file_, text.data(), text.size(), 0));
}

bool JournalGuard::free_reserve(const std::string& path) { return unlink(reserve_of(path).c_str()) == 0; }

void JournalGuard::allocate_reserve() {
  const std::string path = reserve_of(path_);
  struct stat found {};
  if (stat(path.c_str(), &found) == 0 && static_cast<std::uint64_t>(found.st_size) >= min_free_bytes) return;
  if (free_space() < 2 * min_free_bytes) return;
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) return;
  const int failed = posix_fallocate(file, 0, static_cast<off_t>(min_free_bytes));
  close(file);
  if (failed != 0) free_reserve();
}

}  // namespace pelage
