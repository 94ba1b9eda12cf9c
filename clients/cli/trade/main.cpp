// pelage-trade: what `pelage trade` becomes, with the same line; a program of its own for the reason that
// pelage-compare is one.
#include <cstdio>

#include "clients/cli/trade/trade.h"

int main(int argc, char** argv) {
  const auto [exit_code, options] = pelage::parse_line(argc, argv);
  if (exit_code) return *exit_code;
  if (options.action != pelage::Action::trade) {
    std::fputs("pelage-trade: only for `trade`; the rest is done by pelage\n", stderr);
    return pelage::wrong_use;
  }
  auto connection = pelage::Connection::to(options.server, options.token);
  if (!connection) {
    pelage::report(connection.status());
    return pelage::wrong_use;
  }
  pelage::Session session(std::move(connection).value(), options);
  return pelage::measure_trade(session);
}
