// pelage-import JOB SECONDS BYTES [POSE]: reads an uploaded file from standard input and writes the result of the job
// to standard output. The server starts it for each upload; server/import/import.h has the contract.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "renderer/picture_files/picture_files.h"
#include "server/import/import.h"
#include "server/import_worker/confine.h"
#include "server/import_worker/job.h"

namespace {

using namespace pelage;

bool read_all(std::string& bytes) {
  static char buffer[1 << 16];
  for (;;) {
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count == 0) return true;
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.append(buffer, static_cast<std::size_t>(count));
  }
}

bool write_all(int stream, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(stream, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

int complain(std::string message, int code) {
  for (char& c : message) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  write_all(STDERR_FILENO, message + "\n");
  return code;
}

int convert(const Job& job, std::string&& bytes, const std::string& pose) {
  const Result<std::string> answer = job.run(std::move(bytes), pose);
  if (!answer.ok()) return complain(answer.status().message, worker_exit::bad_input);
  return write_all(STDOUT_FILENO, *answer) ? worker_exit::done : worker_exit::bad_input;
}

/// Runs the job. Turns lack of memory, and any other exception of the libraries, into exit codes.
int run(int argc, char** argv) {
  const std::optional<Job> job = argc == 4 || argc == 5 ? job_of(argv[1]) : std::nullopt;
  if (!job) return complain("usage: pelage-import JOB SECONDS BYTES [POSE]", worker_exit::usage);
  try {
    std::string bytes;
    if (!read_all(bytes)) return complain("The input cannot be read.", worker_exit::bad_input);
    if (job->may_read_pictures(bytes)) picture_files();  // opens libraries, which confine() forbids
    const Status confined = confine(std::atof(argv[2]), std::strtoull(argv[3], nullptr, 10));
    if (!confined.ok()) return complain(confined.message, worker_exit::not_confined);
    return convert(*job, std::move(bytes), argc == 5 ? argv[4] : "");
  } catch (const std::bad_alloc&) {
    return complain("out of memory", worker_exit::out_of_memory);
  } catch (const std::exception& error) {
    return complain(error.what(), worker_exit::bad_input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int code = run(argc, argv);
  _exit(code);  // nothing is left to clean up, and what libraries do at exit is not allowed here
}
