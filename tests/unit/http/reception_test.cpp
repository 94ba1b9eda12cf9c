#include "server/http/transport/reception.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <condition_variable>
#include <string>
#include <thread>

namespace pelage {
namespace {

using std::chrono::milliseconds;

/// The bytes of one request, with its empty line.
std::string head(const std::string& target) { return "GET " + target + " HTTP/1.1\r\nHost: here\r\n\r\n"; }

class Client {
 public:
  explicit Client(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval guard{20, 0};  // seconds, against a hang
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &guard, sizeof guard);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Client() { close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void say(const std::string& bytes) const {
    EXPECT_EQ(send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL), static_cast<ssize_t>(bytes.size()));
  }
  /// Reads the next `size` bytes; fewer if the server closes the connection before.
  std::string hear(std::size_t size) const {
    std::string bytes(size, '\0');
    const ssize_t got = recv(socket_, bytes.data(), size, MSG_WAITALL);
    bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return bytes;
  }
  bool ended() const {
    char byte = 0;
    return recv(socket_, &byte, 1, 0) == 0;
  }

 private:
  int socket_;
};

/// A reception that answers requests with their targets. Those of "/hold..." wait until release(), and "/end" closes
/// the connection.
class Served {
 public:
  explicit Served(ReceptionLimits limits) : listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(listening_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listening_, 64), 0);
    getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size);
    port = ntohs(address.sin_port);
    reception_ = std::make_unique<Reception>(listening_, limits, calls());
    thread_ = std::thread([this] { EXPECT_TRUE(reception_->run()); });
  }
  ~Served() {
    release();
    reception_->stop();
    thread_.join();
    close(listening_);
  }
  Served(const Served&) = delete;
  Served& operator=(const Served&) = delete;

  void release() {
    const std::lock_guard lock(mutex_);
    released_ = true;
    changed_.notify_all();
  }
  void wait_for_held(int count) {
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, std::chrono::seconds(20), [&] { return held_ >= count; }));
  }
  void stop() { reception_->stop(); }

  std::uint16_t port = 0;

 private:
  Reception::Calls calls() {
    return {[this](Connection& connection, auto) { return serve(connection); },
            [](const Connection&, int status) { return std::to_string(status); },
            [](const RequestLine& line) { return line.target == "/livez"; }};
  }

  bool serve(Connection& connection) {
    const std::string target = request_line_of(connection.unread()).target;
    std::string bytes(*head_size(connection.unread()), '\0');
    connection.take(bytes.data(), bytes.size());
    if (target.starts_with("/hold")) {
      std::unique_lock lock(mutex_);
      ++held_;
      changed_.notify_all();
      changed_.wait(lock, [&] { return released_; });
    }
    send(connection.socket(), target.data(), target.size(), MSG_NOSIGNAL);
    return target != "/end";
  }

  int listening_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int held_ = 0;
  bool released_ = false;
  std::unique_ptr<Reception> reception_;
  std::thread thread_;
};

TEST(Reception, AConnectionServesSeveralRequestsEvenSentTogether) {
  Served served({.workers = 1});
  const Client client(served.port);
  client.say(head("/a"));
  EXPECT_EQ(client.hear(2), "/a");
  client.say(head("/b") + head("/c") + head("/end"));
  EXPECT_EQ(client.hear(8), "/b/c/end");
  EXPECT_TRUE(client.ended());
}

TEST(Reception, IdleAndSlowClientsTakeNoWorker) {
  Served served({.workers = 1});
  std::vector<std::unique_ptr<Client>> others;
  for (int k = 0; k < 40; ++k) {
    others.push_back(std::make_unique<Client>(served.port));
    if (k % 2 == 0) others.back()->say("GET /a HTTP/1.1\r\nHo");
  }
  const Client client(served.port);
  client.say(head("/b"));
  EXPECT_EQ(client.hear(2), "/b");
  others[0]->say("st: here\r\n\r\n");
  EXPECT_EQ(others[0]->hear(2), "/a");
}

TEST(Reception, OneWorkerIsKeptForUrgentRequests) {
  Served served({.workers = 2});
  const Client first(served.port), second(served.port), third(served.port), probe(served.port);
  first.say(head("/hold1"));
  second.say(head("/hold2"));
  served.wait_for_held(2);
  third.say(head("/third"));
  probe.say(head("/livez"));
  EXPECT_EQ(probe.hear(6), "/livez");
  served.release();
  EXPECT_EQ(third.hear(6), "/third");
}

TEST(Reception, RequestsBeyondThoseThatMayWaitAreRefused) {
  Served served({.workers = 1, .waiting_requests = 1});
  const Client first(served.port), second(served.port), third(served.port);
  first.say(head("/hold"));
  served.wait_for_held(1);
  second.say(head("/second"));
  const Client probe(served.port);
  probe.say(head("/livez"));  // once this is answered, the earlier requests are waiting
  EXPECT_EQ(probe.hear(6), "/livez");
  third.say(head("/third"));
  EXPECT_EQ(third.hear(3), "503");
  EXPECT_TRUE(third.ended());
  served.release();
  EXPECT_EQ(second.hear(7), "/second");
}

TEST(Reception, HeadsAreBoundedInBytesAndTime) {
  Served served(
      {.workers = 1, .head_bytes = 1000, .head_timeout = milliseconds(50), .idle_timeout = std::chrono::minutes(1)});
  const Client whole(served.port), endless(served.port), slow(served.port), good(served.port);
  whole.say(head("/" + std::string(1000, 'x')));
  EXPECT_EQ(whole.hear(3), "431");
  EXPECT_TRUE(whole.ended());
  endless.say("GET / HTTP/1.1\r\nX: " + std::string(100'000, 'y'));
  EXPECT_EQ(endless.hear(3), "431");
  slow.say("GET /");
  EXPECT_EQ(slow.hear(3), "408");
  EXPECT_TRUE(slow.ended());
  good.say(head("/a"));
  EXPECT_EQ(good.hear(2), "/a");
}

TEST(Reception, AnIdleConnectionEndsWithoutAnAnswer) {
  Served served({.workers = 1, .idle_timeout = milliseconds(50)});
  const Client fresh(served.port);
  EXPECT_TRUE(fresh.ended());
  const Client used(served.port);
  used.say(head("/a"));
  EXPECT_EQ(used.hear(2), "/a");
  EXPECT_TRUE(used.ended());
}

TEST(Reception, TheOneThatIsIdleLongestGivesWay) {
  Served served({.workers = 1, .connections = 3});
  const Client held(served.port), first(served.port), second(served.port);
  held.say(head("/hold"));
  served.wait_for_held(1);
  for (const Client* idle : {&first, &second}) {
    idle->say(head("/livez"));  // so `first` is idle longest
    EXPECT_EQ(idle->hear(6), "/livez");
    std::this_thread::sleep_for(milliseconds(200));  // clients get answers before the server knows that they are idle
  }
  const Client late(served.port);
  EXPECT_TRUE(first.ended());
  late.say(head("/livez"));
  EXPECT_EQ(late.hear(6), "/livez");
  second.say(head("/livez"));
  EXPECT_EQ(second.hear(6), "/livez");
  served.release();
  EXPECT_EQ(held.hear(5), "/hold");
}

TEST(Reception, StoppingFinishesWhatRunsAndEndsTheRest) {
  Served served({.workers = 1});
  const Client idle(served.port), held(served.port);
  held.say(head("/hold"));
  served.wait_for_held(1);
  served.stop();
  EXPECT_TRUE(idle.ended());
  served.release();
  EXPECT_EQ(held.hear(5), "/hold");
  EXPECT_TRUE(held.ended());
}

TEST(Reception, AtTheEndOfTheTimeToStopClientsAreCutOff) {
  Served served({.workers = 1, .stopping_timeout = milliseconds(50)});
  const Client held(served.port);
  held.say(head("/hold"));
  served.wait_for_held(1);
  served.stop();
  EXPECT_TRUE(held.ended());
}

TEST(Reception, AHeadEndsAtItsFirstEmptyLine) {
  EXPECT_EQ(head_size("GET / HTTP/1.1\r\n\r\nbody"), 18u);
  EXPECT_EQ(head_size("GET / HTTP/1.1\r\nA: b\n\n"), std::nullopt);
  const std::string whole = "GET / HTTP/1.1\r\nA: b\r\n\r\n";
  for (std::size_t searched = 0; searched < whole.size(); ++searched)
    EXPECT_EQ(head_size(whole, searched), whole.size());
}

}  // namespace
}  // namespace pelage
