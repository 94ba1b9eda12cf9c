#include "server/history/delta_codec.h"

#include <bit>
#include <cstring>
#include <limits>

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Groom) == 16 && std::is_trivially_copyable_v<Groom>);

void put_number(std::string& text, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) text.push_back(static_cast<char>(value | 0x80));
  text.push_back(static_cast<char>(value));
}

void put_grooms(std::string& text, const std::vector<Groom>& grooms) {
  const std::size_t size = text.size(), bytes = grooms.size() * sizeof(Groom);
  text.resize(size + bytes);
  if (bytes > 0) std::memcpy(text.data() + size, grooms.data(), bytes);
}

/// Takes octets from the front; once something is missing, everything after fails too.
class Octets {
 public:
  explicit Octets(std::span<const std::byte> octets) : left_(octets) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64 && !left_.empty(); shift += 7) {
      const auto octet = std::to_integer<std::uint64_t>(left_.front());
      left_ = left_.subspan(1);
      value |= (octet & 0x7f) << shift;
      if (octet < 0x80) return value;
    }
    good_ = false;
    return 0;
  }

  void grooms(std::vector<Groom>& grooms, std::size_t count) {
    good_ = good_ && left_.size() / sizeof(Groom) >= count;
    if (!good_ || count == 0) return;
    grooms.resize(count);
    std::memcpy(grooms.data(), left_.data(), count * sizeof(Groom));
    left_ = left_.subspan(count * sizeof(Groom));
  }

  bool good() const { return good_; }
  std::size_t left() const { return left_.size(); }

 private:
  std::span<const std::byte> left_;
  bool good_ = true;
};

}  // namespace

std::string encode_delta(const FieldDelta& delta) {
  std::string text;
  put_number(text, delta.vertices.size());
  std::uint64_t next = 0;
  for (const std::uint32_t v : delta.vertices) {
    put_number(text, v - next);
    next = std::uint64_t{v} + 1;
  }
  put_grooms(text, delta.before);
  put_grooms(text, delta.after);
  return text;
}

Result<FieldDelta> decode_delta(std::span<const std::byte> octets) {
  Octets in(octets);
  FieldDelta delta;
  const std::uint64_t count = in.number();
  std::uint64_t next = 0;
  bool in_range = count <= in.left();  // each vertex takes an octet or more
  for (std::uint64_t i = 0; i < count && in_range && in.good(); ++i) {
    const std::uint64_t gap = in.number();
    in_range = gap <= std::numeric_limits<std::uint32_t>::max() - next;
    delta.vertices.push_back(static_cast<std::uint32_t>(next + gap));
    next += gap + 1;
    in_range = in_range && next <= std::numeric_limits<std::uint32_t>::max();
  }
  if (in_range) {
    in.grooms(delta.before, count);
    in.grooms(delta.after, count);
  }
  if (!in_range || !in.good() || in.left() != 0) return failure(Code::internal, "a stored change is damaged");
  return delta;
}

}  // namespace pelage
