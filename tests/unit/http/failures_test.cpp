#include "server/http/failures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "server/http/reply.h"
#include "server/http/transport/http_transport.h"

namespace pelage {
namespace {

/// A server whose handlers fail. `problems` gets what the exchanges report; it is complete once this is destroyed.
class Failing {
 public:
  explicit Failing(std::vector<std::string>& problems) : problems_(problems) {
    answer_failures(server_);
    server_.Get("/throws", [](const auto&, auto&) { throw std::runtime_error("the shelf is empty"); });
    server_.Get("/grows", [](const auto&, auto&) { throw std::bad_alloc(); });
    server_.Get("/says", [](const auto&, auto& response) {
      reply_problem(response, failure(Code::internal, "The shelf is empty."));
    });
    server_.Get("/breaks", [](const auto&, auto& response) {
      response.set_chunked_content_provider(
          "text/plain", [](std::size_t, httplib::DataSink&) -> bool { throw std::runtime_error("it fell"); });
    });
    port_ = server_.bind_to_any_port("127.0.0.1");
    HttpTransport::Hooks hooks{.begun = [](const auto&, Exchange& exchange) { exchange.id = "6f1c"; },
                               .refusal = [](Exchange&, int) { return std::string(); },
                               .ended = [this](const Exchange& exchange) { keep(exchange); },
                               .is_probe = [](const std::string&) { return false; }};
    thread_ = std::thread([this, hooks] { EXPECT_TRUE(server_.serve({.workers = 2}, hooks)); });
  }
  ~Failing() {
    server_.stop_serving();
    thread_.join();
  }
  Failing(const Failing&) = delete;
  Failing& operator=(const Failing&) = delete;

  httplib::Result get(const std::string& path) const { return httplib::Client("127.0.0.1", port_).Get(path); }

 private:
  void keep(const Exchange& exchange) {
    const std::lock_guard lock(mutex_);
    problems_.push_back(exchange.problem);
  }

  HttpTransport server_;
  int port_ = 0;
  std::mutex mutex_;
  std::vector<std::string>& problems_;
  std::thread thread_;
};

TEST(Failures, EachFailureNamesItsRequest) {
  std::vector<std::string> problems;
  const Failing server(problems);
  for (const char* path : {"/throws", "/says"}) {
    const auto answer = server.get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 500);
    EXPECT_EQ(answer->get_header_value("Content-Type"), "application/problem+json");
    EXPECT_NE(answer->body.find("request 6f1c"), std::string::npos) << answer->body;
  }
  EXPECT_NE(server.get("/says")->body.find("The shelf is empty."), std::string::npos);
}

TEST(Failures, WithoutMemoryARequestIsRefusedForNow) {
  std::vector<std::string> problems;
  const Failing server(problems);
  const auto answer = server.get("/grows");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 503);
  EXPECT_EQ(answer->get_header_value("Retry-After"), "1");
}

TEST(Failures, TheLogIsToldWhatWasThrown) {
  std::vector<std::string> problems;
  {
    const Failing server(problems);
    EXPECT_TRUE(server.get("/throws"));
    EXPECT_FALSE(server.get("/breaks"));
    EXPECT_TRUE(server.get("/throws")) << "one that fails while it writes ends its connection alone";
  }
  EXPECT_EQ(std::count(problems.begin(), problems.end(), "The server failed: the shelf is empty"), 2);
  EXPECT_EQ(std::count(problems.begin(), problems.end(), "The server failed: it fell"), 1);
}

}  // namespace
}  // namespace pelage
