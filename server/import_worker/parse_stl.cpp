// Stereolithography, text or binary.
#include <bit>
#include <cstring>

#include "server/import_worker/parse.h"
#include "server/import_worker/text.h"

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

constexpr std::size_t header_octets = 84, facet_octets = 50;

void add_corner(RawModel& model, glm::dvec3 position) {
  model.corners.push_back(static_cast<std::uint32_t>(model.positions.size()));
  model.positions.push_back(position);
}

std::uint32_t facet_count(const std::string& octets) {
  std::uint32_t count = 0;
  std::memcpy(&count, octets.data() + header_octets - sizeof count, sizeof count);
  return count;
}

Result<RawModel> parse_binary(const std::string& octets) {
  const std::uint32_t count = facet_count(octets);
  if (count > (octets.size() - header_octets) / facet_octets) {
    return broken("it counts " + std::to_string(count) + " triangles, but has only room for " +
                  std::to_string((octets.size() - header_octets) / facet_octets) + "; it is cut off or broken.");
  }
  if (count == 0) return broken("it has no faces.");
  RawModel model;
  model.is_32_bit = true;
  model.face_sizes.assign(count, 3);
  for (std::size_t facet = 0; facet < count; ++facet) {
    float numbers[12];  // the normal, then three corners
    std::memcpy(numbers, octets.data() + header_octets + facet * facet_octets, sizeof numbers);
    for (int k = 3; k < 12; k += 3) add_corner(model, {numbers[k], numbers[k + 1], numbers[k + 2]});
  }
  return model;
}

/// The words between `facet` and `endfacet`; each `endloop` ends a face.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : text_(text) {}

  Result<RawModel> read() {
    for (std::string_view word = take_word(text_); !word.empty(); word = take_word(text_)) {
      if (word == "solid" || word == "endsolid") take_line(text_);  // a name may be anything
      if (word == "vertex" && !read_vertex()) return broken("a vertex is not three numbers.");
      if (word == "endloop") end_face();
    }
    if (corners_ > 0) return broken("it is cut off within a facet.");
    if (model_.face_sizes.empty()) return broken("it has no faces.");
    return std::move(model_);
  }

 private:
  bool read_vertex() {
    glm::dvec3 position(0);
    for (int i = 0; i < 3; ++i) {
      const std::optional<double> number = to_number(take_word(text_));
      if (!number) return false;
      position[i] = *number;
    }
    add_corner(model_, position);
    ++corners_;
    return true;
  }

  void end_face() {
    if (corners_ > 0) model_.face_sizes.push_back(corners_);
    corners_ = 0;
  }

  std::string_view text_;
  RawModel model_;
  std::uint32_t corners_ = 0;  // of the face that is read
};

/// A binary file may begin with "solid" too, so its size decides first.
bool is_binary(const std::string& octets) {
  if (octets.size() < header_octets) return false;
  if (octets.size() == header_octets + std::size_t{facet_count(octets)} * facet_octets) return true;
  std::string_view text = octets;
  return take_word(text) != "solid" || octets.substr(0, 4096).find('\0') != std::string::npos;
}

}  // namespace

Result<RawModel> parse_stl(const std::string& octets) {
  if (is_binary(octets)) return parse_binary(octets);
  std::string_view text = octets;
  if (take_word(text) != "solid") return broken("it is neither a text nor a binary STL.");
  return TextReader(octets).read();
}

}  // namespace pelage
