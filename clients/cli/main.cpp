// pelage: the command-line client.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "clients/cli/actions/actions.h"
#include "clients/cli/compare/compare_pictures.h"
#include "protocol/json/author.h"

namespace {

constexpr const char* install_advice = "build or install all programs in one folder";

/// Replaces this process by `program` from the same folder (exec). Returns only if that fails.
pelage::ExitCode exec_program(const char* program, char* const* arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string path = self.parent_path() / program;
  execv(path.c_str(), arguments);
  const auto status = pelage::failure(pelage::Code::internal, "Cannot start " + path + "; it belongs beside pelage.");
  return report(with_next(status, install_advice));
}

pelage::ExitCode compare(const pelage::Options& options) {
  try {
    return pelage::compare_pictures(options);
  } catch (const std::runtime_error& error) {  // the picture library is missing
    const auto status = pelage::failure(pelage::Code::internal, error.what());
    return report(with_next(status, install_advice));
  }
}

/// Calibrates this machine by running `pelaged --calibrate`; no server has to run.
pelage::ExitCode calibrate(const pelage::Options& options) {
  std::vector<std::string> words{"pelaged", "--calibrate"};
  for (const auto& [flag, value] : options.server_options) words.insert(words.end(), {flag, value});
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return exec_program("pelaged", arguments.data());
}

}  // namespace

int main(int argc, char** argv) {
  const auto [exit_code, options] = pelage::parse_line(argc, argv);
  if (exit_code) return *exit_code;
  if (options.action == pelage::Action::compare) return compare(options);
  if (options.action == pelage::Action::trade) return exec_program("pelage-trade", argv);
  if (options.action == pelage::Action::farm) return exec_program("pelage-farm", argv);
  if (options.action == pelage::Action::calibrate) return calibrate(options);
  pelage::HttpHeaders headers;
  if (!options.author.empty()) headers.emplace(pelage::author_header, pelage::encoded_author(options.author));
  auto connection = pelage::Connection::to(options.server, options.token, headers);
  if (!connection) {
    pelage::report(connection.status());
    return pelage::wrong_use;
  }
  pelage::Session session(std::move(connection).value(), options);
  return pelage::perform(session);
}
