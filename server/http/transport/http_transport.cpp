#include "server/http/transport/http_transport.h"

#include <unistd.h>

#include <system_error>

#include "base/caught.h"
#include "server/http/transport/stream.h"

namespace pelage {

namespace {

/// Carries the exchange to the handlers in `progress` of a request, which cpp-httplib uses in its client only.
struct ExchangeCarrier {
  Exchange* exchange;
  bool operator()(std::uint64_t, std::uint64_t) const { return true; }
};

}  // namespace

Exchange* exchange_of(const httplib::Request& request) {
  const auto* carrier = request.progress.target<ExchangeCarrier>();
  return carrier ? carrier->exchange : nullptr;
}

bool HttpTransport::serve(const ReceptionLimits& limits, Hooks hooks) {
  hooks_ = std::move(hooks);
  const auto urgent = [this](const RequestLine& line) {
    return (line.method == "GET" || line.method == "HEAD") &&
           hooks_.is_probe(line.target.substr(0, line.target.find('?')));
  };
  const auto refusal = [this](const Connection& connection, int http_status) {
    Exchange exchange(connection, std::chrono::steady_clock::now());
    exchange.status = http_status;
    std::string answer = hooks_.refusal(exchange, http_status);
    exchange.bytes = answer.size();
    hooks_.ended(exchange);
    return answer;
  };
  const auto one = [this](Connection& connection, auto begin) { return serve_one(connection, begin); };
  bool good = false;
  {
    Reception reception(svr_sock_, limits, {one, refusal, urgent});
    {
      const std::lock_guard lock(mutex_);
      reception_ = &reception;
      if (stopped_) reception.stop();
    }
    good = reception.run();
    const std::lock_guard lock(mutex_);
    reception_ = nullptr;
  }
  ::close(svr_sock_.exchange(INVALID_SOCKET));
  return good;
}

void HttpTransport::stop_serving() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  if (reception_) reception_->stop();
}

bool HttpTransport::serve_one(Connection& connection, std::chrono::steady_clock::time_point begin) {
  bool keep_alive = false;
  const Status served = caught([&] {
    Exchange exchange(connection, begin);
    // Catches what handlers throw while their answer is being sent; answer_failures answers what they throw before.
    const Status answered = caught([&] { return keep_alive = answer_one(connection, exchange), Status{}; });
    if (!answered.ok()) exchange.problem = answered.message;
    hooks_.ended(exchange);
    return answered;
  });
  return keep_alive && served.ok();
}

bool HttpTransport::answer_one(Connection& connection, Exchange& exchange) {
  ConnectionStream stream(connection, exchange);
  exchange.problem = "The request is not valid HTTP.";  // until its head is parsed
  const bool last = static_cast<std::size_t>(++connection.requests) >= keep_alive_max_count_;
  bool client_ends = false;
  const bool keep_alive = process_request(stream, last, client_ends, [&](httplib::Request& request) {
    exchange.problem.clear();
    request.progress = ExchangeCarrier{&exchange};
    hooks_.begun(request, exchange);
  });
  if (stream.broken() && exchange.problem.empty()) exchange.problem = "The client left before the answer ended.";
  return keep_alive && !last && !client_ends && !stream.broken();
}

}  // namespace pelage
