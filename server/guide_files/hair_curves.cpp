#include <cstdint>
#include <cstring>
#include <string>

#include "server/guide_files/read_guides.h"

namespace pelage {

namespace {

// The format is described at cemyuksel.com/research/hairmodels. It is little-endian, as this machine.
constexpr std::size_t header_bytes = 128;
constexpr std::uint32_t has_segments = 1, has_points = 2;

template <class T>
T number_at(std::string_view bytes, std::size_t offset) {
  T number{};
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

}  // namespace

Result<std::vector<GuideCurve>> read_hair_curves(std::string_view bytes) {
  if (!bytes.starts_with("HAIR")) return broken_guides("it does not begin as HAIR does.");
  if (bytes.size() < header_bytes) return broken_guides("it is cut off within HAIR's header.");
  const auto strands = number_at<std::uint32_t>(bytes, 4), points = number_at<std::uint32_t>(bytes, 8);
  const auto arrays = number_at<std::uint32_t>(bytes, 12), segments = number_at<std::uint32_t>(bytes, 16);
  if ((arrays & has_points) == 0) return broken_guides("it has no points.");
  const bool own_segments = (arrays & has_segments) != 0;
  const std::size_t first_point = header_bytes + (own_segments ? 2 * std::size_t{strands} : 0);
  if (bytes.size() < first_point + 12 * std::size_t{points}) return broken_guides("it is cut off.");
  std::vector<GuideCurve> curves;
  std::size_t next = 0;
  for (std::size_t i = 0; i < strands; ++i) {
    const std::size_t count =
        1 + (own_segments ? std::size_t{number_at<std::uint16_t>(bytes, header_bytes + 2 * i)} : std::size_t{segments});
    if (count > points - next) return broken_guides("its strands have more points than it says.");
    GuideCurve& curve = curves.emplace_back();
    for (std::size_t k = 0; k < count; ++k, ++next) {
      const std::size_t at = first_point + 12 * next;
      curve.emplace_back(number_at<float>(bytes, at), number_at<float>(bytes, at + 4), number_at<float>(bytes, at + 8));
    }
  }
  return curves;
}

}  // namespace pelage
