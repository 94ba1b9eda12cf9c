#include "base/temporary_name.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <random>

namespace pelage {

namespace {

constexpr std::size_t max_host_bytes = 40;  // a file name has at most 255 bytes

std::string random_digits() {
  std::random_device random;
  const std::uint64_t number = (std::uint64_t{random()} << 32) | random();
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), number, 16).ptr;
  return {digits.begin(), end};
}

}  // namespace

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string temporary_beside(const std::string& path) {
  const std::filesystem::path target(path);
  std::string host = host_name().substr(0, max_host_bytes);
  std::ranges::replace(host, '/', '-');
  return (target.parent_path() / ("." + target.filename().string() + "." + host + "-" + random_digits() + ".tmp"))
      .string();
}

}  // namespace pelage
