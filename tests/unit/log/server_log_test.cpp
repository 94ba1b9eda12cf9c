#include "server/log/server_log.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <regex>
#include <string>

namespace pelage {
namespace {

/// A pipe that is read only on request.
class Pipe {
 public:
  Pipe() {
    EXPECT_EQ(pipe2(ends_.data(), 0), 0);
    fcntl(ends_[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    close(ends_[0]);
    close(ends_[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int writer() const { return ends_[1]; }
  std::string read_all() const {
    std::string text;
    std::array<char, 4096> block;
    for (ssize_t size = 0; (size = ::read(ends_[0], block.data(), block.size())) > 0;)
      text.append(block.data(), static_cast<std::size_t>(size));
    return text;
  }

 private:
  std::array<int, 2> ends_{};
};

std::string logged(LogFormat format, LogLevel level, std::initializer_list<LogField> fields) {
  const Pipe pipe;
  const ServerLog log(format, LogLevel::info, pipe.writer());
  log.write(level, "request", fields);
  return pipe.read_all();
}

constexpr const char* time_pattern = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)";

TEST(Log, WritesALineOfText) {
  const std::string line =
      logged(LogFormat::text, LogLevel::error,
             {{"id", "6f1c"}, {"status", std::int64_t{500}}, {"ms", 1.25}, {"problem", "it broke"}, {"empty", ""}});
  EXPECT_TRUE(std::regex_match(line, std::regex(std::string(time_pattern) +
                                                R"( error request id=6f1c status=500 ms=1\.250 problem="it broke"\n)")))
      << line;
}

TEST(Log, WritesALineOfJson) {
  const std::string line =
      logged(LogFormat::json, LogLevel::warning, {{"path", "/a\"b\n"}, {"bytes", std::int64_t{7}}, {"ms", 2.0}});
  EXPECT_TRUE(std::regex_match(
      line, std::regex(R"(\{"time":")" + std::string(time_pattern) +
                       R"(","level":"warning","event":"request","path":"/a\\"b\\n","bytes":7,"ms":2\.000\}\n)")))
      << line;
}

TEST(Log, ClientsCanNeitherForgeLinesNorMakeThemEndless) {
  const std::string line =
      logged(LogFormat::text, LogLevel::info, {{"path", "/a\n2026 error forged"}, {"long", std::string(9000, '\x01')}});
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  EXPECT_NE(line.find(R"(path="/a\n2026 error forged")"), line.npos) << line;
  EXPECT_LT(line.size(), 4096u);
  EXPECT_NE(logged(LogFormat::json, LogLevel::info, {{"path", "/\xff"}}).find("\xef\xbf\xbd"),
            std::string::npos);  // invalid UTF-8
}

TEST(Log, LinesBelowTheLevelAreLeftOut) {
  const Pipe pipe;
  const ServerLog log(LogFormat::text, LogLevel::warning, pipe.writer());
  log.write(LogLevel::info, "request", {});
  EXPECT_EQ(pipe.read_all(), "");
  log.write(LogLevel::warning, "request", {});
  EXPECT_NE(pipe.read_all(), "");
  const ServerLog none(LogFormat::text, LogLevel::off, pipe.writer());
  none.write(LogLevel::error, "request", {});
  EXPECT_EQ(pipe.read_all(), "");
}

TEST(Log, AReaderThatStandsStillStopsNobody) {
  const Pipe pipe;
  const ServerLog log(LogFormat::text, LogLevel::info, pipe.writer());
  for (int k = 0; k < 5000; ++k) log.write(LogLevel::info, "request", {{"path", std::string(200, 'x')}});
  EXPECT_FALSE(pipe.read_all().ends_with("late=1\n"));
  log.write(LogLevel::info, "request", {{"late", std::int64_t{1}}});
  const std::string after = pipe.read_all();
  EXPECT_TRUE(std::regex_search(after, std::regex(R"(warning lines_dropped count=\d+\n)"))) << after;
  EXPECT_TRUE(after.ends_with("late=1\n")) << after;
}

}  // namespace
}  // namespace pelage
