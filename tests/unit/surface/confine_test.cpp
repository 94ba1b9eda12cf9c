// What the confined worker can no longer do. Each check runs in a child process, since confinement is permanent.
#include "server/import_worker/confine.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "server/import_worker/parse.h"

namespace pelage::confine_test {
namespace {

constexpr std::size_t plenty = std::size_t{4} << 30;

/// Confines a child and runs `action` in it. Returns the child's exit code: 0 if `action` returns true.
template <class Action>
int confined(Action action) {
  const pid_t child = fork();
  if (child == 0) {
    if (!confine(10, plenty).ok()) _exit(2);
    _exit(action() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool is_denied(long result) { return result < 0 && errno == EPERM; }

TEST(Confine, ComputingAndMemoryAreAllowed) {
  EXPECT_EQ(confined([] {
              const std::string text(10'000'000, 'x');
              return text.back() == 'x';
            }),
            0);
}

TEST(Confine, FilesAreDenied) {
  EXPECT_EQ(confined([] { return is_denied(open("/etc/passwd", O_RDONLY)); }), 0);
  EXPECT_EQ(confined([] { return is_denied(open("/dev/null", O_WRONLY)); }), 0);
  EXPECT_EQ(confined([] { return is_denied(unlink("/nothing")); }), 0);
}

TEST(Confine, SocketsAndProcessesAreDenied) {
  EXPECT_EQ(confined([] { return is_denied(socket(AF_INET, SOCK_STREAM, 0)); }), 0);
  EXPECT_EQ(confined([] {
              char name[] = "/bin/true";
              char* arguments[] = {name, nullptr};
              return is_denied(execv(name, arguments));
            }),
            0);
  EXPECT_EQ(confined([] { return is_denied(fork()); }), 0);
}

TEST(Confine, OtherDescriptorsAreDenied) {
  if (is_sanitized) GTEST_SKIP() << "sanitizers write to pipes";
  const int other = open("/dev/null", O_RDWR);
  ASSERT_GT(other, STDERR_FILENO);
  EXPECT_EQ(confined([&] { return is_denied(write(other, "x", 1)); }), 0);
  close(other);
}

TEST(Confine, ExecutableMemoryIsDenied) {
  EXPECT_EQ(confined([] {
              return mmap(nullptr, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED;
            }),
            0);
}

}  // namespace
}  // namespace pelage::confine_test
