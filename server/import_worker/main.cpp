// pelage-import FORMAT SECONDS BYTES: reads a model on standard input, writes polygons on standard output. Started by
// the server for each upload; server/surface/worker_contract.h has the contract.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <string_view>

#include "server/import_worker/confine.h"
#include "server/import_worker/parse.h"
#include "server/surface/import.h"
#include "server/surface/worker_contract.h"

namespace {

using namespace pelage;

std::optional<ModelFormat> to_format(std::string_view name) {
  for (std::size_t i = 0; i < worker_format_names.size(); ++i) {
    if (name == worker_format_names[i]) return static_cast<ModelFormat>(i);
  }
  return std::nullopt;
}

bool read_all(std::string& octets) {
  static char buffer[1 << 16];
  for (;;) {
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count == 0) return true;
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) octets.append(buffer, static_cast<std::size_t>(count));
  }
}

bool write_all(int stream, std::string_view octets) {
  while (!octets.empty()) {
    const ssize_t count = write(stream, octets.data(), octets.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) octets.remove_prefix(static_cast<std::size_t>(count));
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

int convert(ModelFormat format) {
  std::string octets;
  if (!read_all(octets)) return complain("The input cannot be read.", worker_exit::bad_input);
  const Result<RawModel> model = parse_model(format, std::move(octets));
  if (!model.ok()) return complain(model.status().message, worker_exit::bad_input);
  return write_all(STDOUT_FILENO, encode_raw_model(*model)) ? worker_exit::done : worker_exit::bad_input;
}

/// Memory that is not there and whatever else the libraries throw become exit codes.
int run(int argc, char** argv) {
  const std::optional<ModelFormat> format = argc == 4 ? to_format(argv[1]) : std::nullopt;
  if (!format) return complain("usage: pelage-import FORMAT SECONDS BYTES", worker_exit::usage);
  try {
    const Status confined = confine(std::atof(argv[2]), std::strtoull(argv[3], nullptr, 10));
    if (!confined.ok()) return complain(confined.message, worker_exit::not_confined);
    return convert(*format);
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
