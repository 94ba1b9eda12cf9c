#include "server/import_worker/confine.h"

#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "server/import_worker/parse.h"

namespace pelage {

namespace {

class BytesStream : public Assimp::IOStream {
 public:
  explicit BytesStream(std::string_view bytes) : bytes_(bytes) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - position_) / size);
    if (whole > 0) std::memcpy(buffer, bytes_.data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_SET ? 0 : (origin == aiOrigin_CUR ? position_ : bytes_.size());
    const std::size_t wanted = base + offset;  // a negative offset wraps around to the right sum
    if (wanted > bytes_.size()) return aiReturn_FAILURE;
    position_ = wanted;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

}  // namespace

Assimp::IOStream* ClosedIo::Open(const char* file, const char* mode) {
  const std::string* bytes = std::string_view(mode).starts_with('r') ? bytes_of(file) : nullptr;
  if (bytes) return new BytesStream(*bytes);
  if (refused_.empty()) refused_ = file;
  return nullptr;
}

void ClosedIo::Close(Assimp::IOStream* stream) { delete stream; }

namespace {

bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  const rlimit wanted{soft, hard};
  return setrlimit(resource, &wanted) == 0;
}

bool limit_resources(double seconds, std::size_t memory_bytes) {
  const auto cpu = static_cast<rlim_t>(std::ceil(std::clamp(seconds, 1.0, 1e6)));
  constexpr rlim_t open_files = is_sanitized ? 16 : 3;  // the standard streams
  return limit(RLIMIT_CPU, cpu, cpu + 1) && limit(RLIMIT_FSIZE, 0, 0) && limit(RLIMIT_CORE, 0, 0) &&
         limit(RLIMIT_NOFILE, open_files, open_files) && (is_sanitized || limit(RLIMIT_AS, memory_bytes, memory_bytes));
}

using Filter = std::unique_ptr<void, void (*)(scmp_filter_ctx)>;

/// Allows a system call if its arguments meet all of the conditions.
bool allow(const Filter& filter, int call, const std::vector<scmp_arg_cmp>& conditions = {}) {
  return seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, static_cast<unsigned>(conditions.size()),
                                conditions.data()) == 0;
}

/// Allows mapping memory that is not executable: the third argument of both calls holds the protection.
bool allow_memory(const Filter& filter) {
  const scmp_arg_cmp not_executable{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0};
  return allow(filter, SCMP_SYS(mmap), {not_executable}) && allow(filter, SCMP_SYS(mprotect), {not_executable});
}

/// Allows writing the answer and the error output.
bool allow_streams(const Filter& filter) {
  const auto on = [](int stream) { return scmp_arg_cmp{0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(stream), 0}; };
  return allow(filter, SCMP_SYS(write), {on(STDOUT_FILENO)}) && allow(filter, SCMP_SYS(write), {on(STDERR_FILENO)});
}

/// Allows the sanitizers to check whether memory is readable, which they do by writing it to a pipe.
bool allow_checks_of_sanitizers(const Filter& filter) {
  return !is_sanitized || (allow(filter, SCMP_SYS(pipe)) && allow(filter, SCMP_SYS(pipe2)) &&
                           allow(filter, SCMP_SYS(write)) && allow(filter, SCMP_SYS(close)));
}

bool filter_calls() {
  const Filter filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
  if (!filter || !allow_streams(filter) || !allow_memory(filter) || !allow_checks_of_sanitizers(filter)) return false;
  for (int call :
       {SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk), SCMP_SYS(madvise), SCMP_SYS(futex), SCMP_SYS(exit),
        SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigaction),
        SCMP_SYS(sigaltstack), SCMP_SYS(getpid), SCMP_SYS(gettid), SCMP_SYS(tgkill), SCMP_SYS(sched_yield),
        SCMP_SYS(clock_gettime), SCMP_SYS(gettimeofday), SCMP_SYS(getrandom), SCMP_SYS(restart_syscall)}) {
    if (!allow(filter, call)) return false;
  }
  return seccomp_load(filter.get()) == 0;
}

}  // namespace

Status confine(double seconds, std::size_t memory_bytes) {
  if (!limit_resources(seconds, memory_bytes)) return failure(Code::internal, "A resource limit could not be set.");
  if (prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
    return failure(Code::internal, "New privileges could not be given up.");
  }
  if (!filter_calls()) return failure(Code::internal, "The filter of system calls could not be installed.");
  return {};
}

}  // namespace pelage
