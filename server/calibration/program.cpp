#include "server/calibration/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "server/calibration/calibrate.h"
#include "server/frames/stored_calibration.h"

namespace pelage {

namespace {

constexpr int bar_width = 40;

/// On a terminal one line that grows; elsewhere a line for each tenth.
class ProgressBar {
 public:
  void show(double share) {
    if (isatty(STDERR_FILENO)) {
      const auto full = static_cast<std::size_t>(share * bar_width);
      fmt::print(stderr, "\rMeasuring [{:<{}}] {:3.0f}%{}", std::string(full, '#'), bar_width, share * 100,
                 share < 1 ? "" : "\n");
    } else if (const int tenth = static_cast<int>(share * 10); tenth > tenth_) {
      tenth_ = tenth;
      fmt::print(stderr, "Measuring: {}%\n", tenth * 10);
    }
    std::fflush(stderr);
  }

 private:
  int tenth_ = 0;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm date{};
  gmtime_r(&now, &date);
  return fmt::format("{:04}-{:02}-{:02}", date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
}

}  // namespace

Status calibrate_machine(GlChoice gl, int threads, const std::string& file) {
  const Result<std::unique_ptr<Context>> context = select_context(gl, threads);
  if (!context) return context.status();
  const Result<std::unique_ptr<Renderer>> renderer = Renderer::create((*context)->gl());
  if (!renderer) return renderer.status();
  fmt::print(stderr, "Calibrating {}\n", (*context)->description());
  ProgressBar bar;
  const CostUnit unit = cost_unit((*context)->is_software(), threads);
  Result<Calibration> measured =
      calibrate(**renderer, unit, default_calibration(), [&](double share) { bar.show(share); });
  if (!measured) return measured.status();
  measured->name = today(), measured->machine = (*context)->description(), measured->threads = unit.threads;
  std::error_code error;
  if (const auto folder = std::filesystem::path(file).parent_path(); !folder.empty())
    std::filesystem::create_directories(folder, error);
  if (Status written = write_calibration(file, *measured); !written.ok()) return written;
  fmt::print(stderr,
             "Stored in {}; a server reads it when it starts. 95% of measured frames cost at most {:.2f} times their "
             "estimate.\n",
             file, measured->cost_safety);
  return {};
}

}  // namespace pelage
