// pelage: the command-line client.
#include "clients/cli/actions.h"
#include "clients/cli/hand_over.h"

int main(int argc, char** argv) {
  const auto [exit_code, options] = pelage::parse_line(argc, argv);
  if (exit_code) return *exit_code;
  if (options.action == pelage::Action::compare) return pelage::hand_over("pelage-compare", argv);
  if (options.action == pelage::Action::trade) return pelage::hand_over("pelage-trade", argv);
  auto connection = pelage::Connection::to(options.server, options.token);
  if (!connection) {
    pelage::report(connection.status());
    return pelage::wrong_use;
  }
  pelage::Session session(std::move(connection).value(), options);
  return pelage::perform(session);
}
