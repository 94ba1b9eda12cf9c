#include "server/history/codec.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::uint64_t fields_of_a_sheet = 16;  // more than there are, to leave room
static_assert(field_count <= fields_of_a_sheet);
constexpr std::uint64_t sheets_of_a_coat = 32;  // likewise
static_assert(sheet_count <= sheets_of_a_coat);

void put_number(std::string& text, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) text.push_back(static_cast<char>(value | 0x80));
  text.push_back(static_cast<char>(value));
}

void put_words(std::string& text, const std::vector<std::uint32_t>& words) {
  const std::size_t size = text.size(), bytes = words.size() * sizeof(std::uint32_t);
  text.resize(size + bytes);
  if (bytes > 0) std::memcpy(text.data() + size, words.data(), bytes);
}

/// Reads values from the front of the bytes. After the first failure, good() stays false.
class Bytes {
 public:
  explicit Bytes(std::span<const std::byte> bytes) : left_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && !left_.empty(); shift += 7) {
      const auto byte = std::to_integer<std::uint64_t>(left_.front());
      left_ = left_.subspan(1);
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    good_ = false;
    return 0;
  }

  void words(std::vector<std::uint32_t>& words, std::uint64_t count) {
    good_ = good_ && left_.size() / sizeof(std::uint32_t) >= count;
    if (!good_ || count == 0) return;
    words.resize(count);
    std::memcpy(words.data(), left_.data(), count * sizeof(std::uint32_t));
    left_ = left_.subspan(count * sizeof(std::uint32_t));
  }

  bool good() const { return good_; }
  std::size_t left() const { return left_.size(); }

 private:
  std::span<const std::byte> left_;
  bool good_ = true;
};

/// Writes rising vertex numbers as the gaps between them.
void put_vertices(std::string& text, const std::vector<std::uint32_t>& vertices) {
  std::uint64_t next = 0;
  for (const std::uint32_t v : vertices) {
    put_number(text, v - next);
    next = std::uint64_t{v} + 1;
  }
}

/// Inverts put_vertices. Returns false if a vertex number exceeds 32 bits.
bool take_vertices(Bytes& in, std::uint64_t count, std::vector<std::uint32_t>& vertices) {
  constexpr std::uint64_t max = std::numeric_limits<std::uint32_t>::max();
  std::uint64_t next = 0;
  for (std::uint64_t i = 0; i < count && in.good(); ++i) {
    const std::uint64_t gap = in.number();
    if (gap > max - next) return false;
    vertices.push_back(static_cast<std::uint32_t>(next + gap));
    next += gap + 1;
    if (next > max) return false;
  }
  return true;
}

/// Reads one field's change on one sheet of a coat. Returns false if the bytes hold none that may follow `before`.
bool take_part(Bytes& in, const FieldDelta& before, FieldDelta::Part& part) {
  const std::uint64_t field_code = in.number(), count = in.number();
  const std::uint64_t field = field_code % fields_of_a_sheet, sheet = field_code / fields_of_a_sheet % sheets_of_a_coat;
  const std::uint64_t coat = field_code / fields_of_a_sheet / sheets_of_a_coat;
  if (field >= field_count || sheet >= sheet_count || coat >= limits::coats) return false;
  if (coat > 0 && is_shared(field_at(field))) return false;
  if (count == 0 || count > in.left()) return false;  // each vertex takes at least one byte
  part.field = field_at(field), part.sheet = static_cast<Sheet>(sheet), part.coat = static_cast<CoatId>(coat);
  if (!before.parts.empty() && !comes_before(before.parts.back(), part)) return false;
  if (!take_vertices(in, count, part.vertices)) return false;
  in.words(part.flips, count * static_cast<std::uint64_t>(shape_of(part.field).channels));
  return in.good();
}

}  // namespace

std::string encode_delta(const FieldDelta& delta) {
  std::string text;
  put_number(text, delta.parts.size());
  for (const FieldDelta::Part& part : delta.parts) {
    put_number(
        text, (part.coat * sheets_of_a_coat + part.sheet) * fields_of_a_sheet + static_cast<std::uint64_t>(part.field));
    put_number(text, part.vertices.size());
    put_vertices(text, part.vertices);
    put_words(text, part.flips);
  }
  return text;
}

Result<FieldDelta> decode_delta(std::span<const std::byte> bytes) {
  Bytes in(bytes);
  FieldDelta delta;
  const std::uint64_t parts = in.number();
  bool good = in.good() && parts <= field_count * sheet_count * limits::coats;
  for (std::uint64_t i = 0; good && i < parts; ++i) {
    FieldDelta::Part part;
    good = take_part(in, delta, part);
    if (good) delta.parts.push_back(std::move(part));
  }
  if (!good || in.left() != 0) return failure(Code::internal, "a stored change is damaged");
  return delta;
}

namespace {

static_assert(std::endian::native == std::endian::little);

void put_word(std::string& text, std::uint32_t word) { text.append(reinterpret_cast<const char*>(&word), sizeof word); }

/// Reads the next run of a subdivision. Returns false if it does not lie after the run before it.
bool take_run(std::span<const std::uint32_t> words, ChosenTriangles& runs) {
  const TriangleRun run{words[0], words[1]};
  if (run.begin >= run.end || (!runs.empty() && run.begin <= runs.back().end)) return false;
  runs.push_back(run);
  return true;
}

}  // namespace

std::string encode_subdivisions(const std::vector<ChosenTriangles>& subdivisions) {
  std::string text;
  for (const ChosenTriangles& runs : subdivisions) {
    put_word(text, static_cast<std::uint32_t>(runs.size()));
    for (const TriangleRun run : runs) put_word(text, run.begin), put_word(text, run.end);
  }
  return text;
}

Result<std::vector<ChosenTriangles>> decode_subdivisions(std::span<const std::byte> bytes) {
  const auto damaged = [] { return failure(Code::internal, "the stored subdivisions of a model are damaged"); };
  if (bytes.size() % sizeof(std::uint32_t) != 0) return damaged();
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  std::vector<ChosenTriangles> subdivisions;
  std::span<const std::uint32_t> left(words);
  while (!left.empty()) {
    const std::size_t runs = left[0];
    left = left.subspan(1);
    if (left.size() / 2 < runs) return damaged();
    ChosenTriangles& chosen = subdivisions.emplace_back();
    for (std::size_t i = 0; i < runs; ++i, left = left.subspan(2)) {
      if (!take_run(left, chosen)) return damaged();
    }
  }
  return subdivisions;
}

namespace {

template <class T>
bool take_number(std::string_view& text, T& number) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace

std::string encode_creases_and_flips(const PrepareOptions& options) {
  std::string text = fmt::format("{}", options.crease_degrees);
  for (const std::uint32_t part : options.flipped_parts) text += fmt::format(" {}", part);
  if (!options.two_sided_parts.empty()) text += " /";
  for (const std::uint32_t part : options.two_sided_parts) text += fmt::format(" {}", part);
  return text;
}

bool decode_creases_and_flips(std::string_view text, PrepareOptions& options) {
  if (text.empty()) return true;
  if (!take_number(text, options.crease_degrees)) return false;
  std::vector<std::uint32_t>* parts = &options.flipped_parts;
  while (!text.empty()) {
    if (text.starts_with(" /")) text.remove_prefix(2), parts = &options.two_sided_parts;
    if (!take_number(text, parts->emplace_back())) return false;
  }
  return true;
}

namespace {

constexpr int fast_compression = 1;
constexpr std::uint64_t max_compression_ratio = 1040;  // maximum of zlib; a larger stated size is wrong

}  // namespace

std::string compress_bytes(std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  uLongf packed = compressBound(size);
  std::string stored(sizeof size + packed, '\0');
  std::memcpy(stored.data(), &size, sizeof size);
  compress2(reinterpret_cast<Bytef*>(stored.data() + sizeof size), &packed,
            reinterpret_cast<const Bytef*>(bytes.data()), size, fast_compression);
  stored.resize(sizeof size + packed);
  return stored;
}

Result<std::string> decompress_bytes(std::string_view stored) {
  const Status damaged = failure(Code::internal, "the journal is damaged: a picture cannot be read");
  std::uint64_t size = 0;
  if (stored.size() < sizeof size) return damaged;
  std::memcpy(&size, stored.data(), sizeof size);
  stored.remove_prefix(sizeof size);
  if (size > stored.size() * max_compression_ratio) return damaged;
  std::string bytes(size, '\0');
  uLongf unpacked = size;
  const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &unpacked,
                                reinterpret_cast<const Bytef*>(stored.data()), stored.size());
  return result == Z_OK && unpacked == size ? Result<std::string>(std::move(bytes)) : damaged;
}

}  // namespace pelage
