#include <array>
#include <cstring>

#include "server/export/buffered.h"
#include "server/export/strand_files.h"

namespace pelage {

namespace {

/// The header as described at cemyuksel.com/research/hairmodels.
struct HairHeader {
  std::array<char, 4> signature{'H', 'A', 'I', 'R'};
  std::uint32_t strands = 0, points = 0;
  std::uint32_t arrays = 1 | 2 | 4 | 16;  // segments, points, thickness, colours
  std::uint32_t segments = 0;             // default for all strands; unused, as there is an array
  float thickness = 0, transparency = 0;
  std::array<float, 3> colour{};
  std::array<char, 88> about{};
};
static_assert(sizeof(HairHeader) == 128);

template <class Use>
void for_each_point(const ExportedStrands& strands, const Buffered& out, const Use& use) {
  for (const StrandSet& set : strands.sets) {
    for (std::size_t i = 0; i < set.points.size() && out.going(); ++i) use(set, i);
  }
}

}  // namespace

bool write_hair(const ExportedStrands& strands, const Sink& sink) {
  Buffered out(sink);
  HairHeader header;
  header.strands = static_cast<std::uint32_t>(strands.count());
  header.points = static_cast<std::uint32_t>(strands.points());
  constexpr std::string_view about = "Pelage; thickness is the width, colours are linear";
  std::memcpy(header.about.data(), about.data(), about.size());
  out.put(header);
  for (const StrandSet& set : strands.sets) {
    for (std::size_t i = 0; i < set.count(); ++i) out.put(static_cast<std::uint16_t>(set.segments));
  }
  for_each_point(strands, out, [&](const StrandSet& set, std::size_t i) {
    out.put(glm::vec3(glm::dvec3(strands.file_offset(set.points[i])) + strands.transform.centre));
  });
  for_each_point(strands, out,
                 [&](const StrandSet& set, std::size_t i) { out.put(strands.model_width(set.points[i])); });
  for_each_point(strands, out, [&](const StrandSet& set, std::size_t i) { out.put(unpack_colour(set.colours[i])); });
  return out.finish();
}

}  // namespace pelage
