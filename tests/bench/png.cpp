// Measures how long a PNG takes to encode on one thread and on several. usage: bench_png THREADS PICTURE...
#include "renderer/image/png.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/stopwatch.h"
#include "renderer/picture_files/picture_files.h"

namespace pelage {
namespace {

constexpr std::size_t max_pixels = std::size_t{8192} * 8192;
constexpr int repetitions = 15;

Image read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  auto image = picture_files().decode_image(std::as_bytes(std::span(bytes)), max_pixels);
  if (!image) std::fprintf(stderr, "%s: %s\n", path, image.status().message.c_str()), std::exit(1);
  return *std::move(image);
}

double milliseconds(Image image, int threads) {
  const Stopwatch passed;
  PngEncoder(threads).encode(std::move(image), false);
  return passed.milliseconds();
}

void measure(const char* path, int threads) {
  const Image image = read(path);
  double alone = 1e9, together = 1e9;
  for (int i = 0; i < repetitions; ++i) {
    alone = std::min(alone, milliseconds(image, 1));
    together = std::min(together, milliseconds(image, threads));
  }
  const std::size_t bytes = encode_png(image, false).size();
  std::printf("| %s | %d x %d | %zu | %.1f | %.1f | %.2f |\n", std::filesystem::path(path).filename().c_str(),
              image.width, image.height, bytes / 1000, alone, together, together / alone);
}

}  // namespace
}  // namespace pelage

int main(int count, char** words) {
  const int threads = count > 2 ? std::atoi(words[1]) : 0;
  if (threads < 1) return std::fprintf(stderr, "usage: bench_png THREADS PICTURE...\n"), 2;
  std::printf("| picture | size | kB | one thread, ms | %d threads | ratio |\n|---|---|---|---|---|---|\n", threads);
  for (int i = 2; i < count; ++i) pelage::measure(words[i], threads);
}
