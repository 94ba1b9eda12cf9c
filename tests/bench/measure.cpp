#include "tests/bench/measure.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace pelage::bench {

namespace {

double cpu_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [](const timeval& t) { return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3; };
  return ms(usage.ru_utime) + ms(usage.ru_stime);
}

}  // namespace

void Cost::least(const Cost& other) { wall = std::min(wall, other.wall), cpu = std::min(cpu, other.cpu); }

Cost measure(const std::function<void()>& work) {
  const double cpu = cpu_milliseconds();
  const auto start = std::chrono::steady_clock::now();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(), cpu_milliseconds() - cpu};
}

std::vector<Cost> measure_alternating(const std::vector<std::function<void()>>& works, int repetitions) {
  std::vector<Cost> costs(works.size());
  for (const auto& work : works) work();
  for (int i = 0; i < repetitions; ++i) {
    for (std::size_t k = 0; k < works.size(); ++k) costs[k].least(measure(works[k]));
  }
  return costs;
}

BenchRenderer open_renderer() {
  Result<std::unique_ptr<Context>> context = select_context(GlChoice::automatic, 0);
  if (!context) return std::fprintf(stderr, "%s\n", context.status().message.c_str()), BenchRenderer{};
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create((*context)->gl());
  if (!renderer) return std::fprintf(stderr, "%s\n", renderer.status().message.c_str()), BenchRenderer{};
  std::printf("%s\n", (*context)->description().c_str());
  return {std::move(context).value(), std::move(renderer).value()};
}

Image draw(Renderer& renderer, const FurFrame& frame, DrawTimes* times) {
  Result<Image> image = renderer.draw(frame, times);
  if (!image) std::fprintf(stderr, "%s\n", image.status().message.c_str()), std::exit(4);
  return std::move(image).value();
}

int argument(int count, char** arguments, const char* name, int fallback) {
  for (int i = 1; i + 1 < count; i += 2) {
    if (arguments[i] == std::string(name)) return std::atoi(arguments[i + 1]);
  }
  return fallback;
}

}  // namespace pelage::bench
