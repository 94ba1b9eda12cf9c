// Parses STL (stereolithography), text or binary.
#include <bit>
#include <cstring>

#include "server/import_worker/parse.h"

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read as it lies in memory");

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

void add_corner(RawModel& model, glm::dvec3 position) {
  model.corners.push_back(static_cast<std::uint32_t>(model.positions.size()));
  model.positions.push_back(position);
}

std::uint32_t facet_count(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

Result<RawModel> parse_binary(const std::string& bytes) {
  const std::uint32_t count = facet_count(bytes);
  if (count > (bytes.size() - header_bytes) / facet_bytes) {
    return broken("it counts " + std::to_string(count) + " triangles, but has only room for " +
                  std::to_string((bytes.size() - header_bytes) / facet_bytes) + "; it is cut off or broken.");
  }
  if (count == 0) return broken("it has no faces.");
  RawModel model;
  model.is_32_bit = true;
  model.face_sizes.assign(count, 3);
  for (std::size_t facet = 0; facet < count; ++facet) {
    float numbers[12];  // the normal, then three corners
    std::memcpy(numbers, bytes.data() + header_bytes + facet * facet_bytes, sizeof numbers);
    for (int k = 3; k < 12; k += 3) add_corner(model, {numbers[k], numbers[k + 1], numbers[k + 2]});
  }
  return model;
}

/// Reads a text STL: each `vertex` adds a corner, and each `endloop` ends a face.
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
  std::uint32_t corners_ = 0;  // of the face that is being read
};

/// A binary file may begin with "solid" too, so its size decides first.
bool is_binary(const std::string& bytes) {
  if (bytes.size() < header_bytes) return false;
  if (bytes.size() == header_bytes + std::size_t{facet_count(bytes)} * facet_bytes) return true;
  std::string_view text = bytes;
  return take_word(text) != "solid" || bytes.substr(0, 4096).find('\0') != std::string::npos;
}

}  // namespace

Result<RawModel> parse_stl(const std::string& bytes) {
  if (is_binary(bytes)) return parse_binary(bytes);
  std::string_view text = bytes;
  if (take_word(text) != "solid") return broken("it is neither a text nor a binary STL.");
  return TextReader(bytes).read();
}

}  // namespace pelage
