#include "clients/cli/terminal/describe.h"

#include <fmt/format.h>

#include <variant>

#include "protocol/json/decode.h"

namespace pelage {

namespace {

constexpr std::size_t most = 3;

/// Its name, and where it works: the radius of a stroke's brush, or everywhere.
template <class Tool>
std::string words_of(const Tool& command) {
  std::string words = Tool::op;
  if constexpr (requires { command.stroke, command.brush; }) {
    if (command.stroke) words += fmt::format(" r {:g}", command.brush.radius);
  }
  if constexpr (requires { command.flood; }) {
    if (command.flood) words += " everywhere";
  }
  return words;
}

}  // namespace

std::string described(const std::string& commands) {
  const auto decoded =
      commands.empty() ? Result<std::vector<Command>>(std::vector<Command>{}) : decode_commands(commands);
  if (!decoded) return commands;  // of a newer server
  std::string words;
  for (std::size_t k = 0; k < decoded->size() && k < most; ++k) {
    words += (k > 0 ? ", " : "") + std::visit([](const auto& command) { return words_of(command); }, (*decoded)[k]);
  }
  if (decoded->size() > most) words += fmt::format(" and {} more", decoded->size() - most);
  return words;
}

}  // namespace pelage
