#include "renderer/image/npy.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <charconv>
#include <cstring>
#include <vector>

#include "renderer/image/image.h"

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view magic("\x93NUMPY", 6);
constexpr std::size_t alignment = 64;  // of the numbers from the beginning of the file, bytes

template <class Number>
std::string encode(std::span<const std::size_t> shape, std::span<const Number> values, const char* type) {
  std::string header = std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (";
  std::size_t count = 1;
  for (const std::size_t n : shape) header += std::to_string(n) + ",", count *= n;
  assert(count == values.size());
  header += "), }";
  const std::size_t prefix = magic.size() + 4;
  header.append(alignment - 1 - (prefix + header.size()) % alignment, ' ');
  header += '\n';
  std::string file(magic);
  file += {1, 0, static_cast<char>(header.size() & 255), static_cast<char>(header.size() >> 8)};
  file += header;
  return file.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

/// The contents of the header.
struct Layout {
  std::string_view type;           // "<f4"
  std::vector<std::size_t> shape;  // 1 to 3 numbers
  std::string_view numbers;        // the rest of the file
};

/// Returns the text after `key` in the header's dictionary.
std::string_view member(std::string_view header, std::string_view key) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  header.remove_prefix(at + key.size());
  header.remove_prefix(std::min(header.find_first_not_of(": "), header.size()));
  return header;
}

std::vector<std::size_t> shape_of_text(std::string_view text) {
  std::vector<std::size_t> shape;
  if (text.empty() || text.front() != '(') return shape;
  for (text.remove_prefix(1); shape.size() < 4;) {
    text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc()) break;
    shape.push_back(count);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  return shape;
}

Result<Layout> layout_of(std::string_view bytes) {
  const std::size_t length_bytes = bytes.size() > magic.size() && bytes[magic.size()] == 1 ? 2 : 4;
  const std::size_t prefix = magic.size() + 2 + length_bytes;
  if (bytes.size() < prefix) return unreadable("it is cut off.");
  std::size_t length = 0;
  std::memcpy(&length, bytes.data() + magic.size() + 2, length_bytes);
  if (length > bytes.size() - prefix) return unreadable("it is cut off.");
  const std::string_view header = bytes.substr(prefix, length);
  if (!member(header, "'fortran_order'").starts_with("False"))
    return unreadable("its array is not in C order; save numpy.ascontiguousarray of it.");
  const std::string_view type = member(header, "'descr'");
  return Layout{type.size() > 5 && type.front() == '\'' ? type.substr(1, 3) : std::string_view(),
                shape_of_text(member(header, "'shape'")), bytes.substr(prefix + length)};
}

/// A picture whose pixels are not read yet, and the number of channels in the file.
struct Pixels {
  DataImage image;
  std::size_t channels = 1;
};

Result<Pixels> pixels_of(const std::vector<std::size_t>& shape, std::size_t max_pixels) {
  const bool rows = shape.size() == 1 || (shape.size() == 2 && shape[1] <= 4);
  const std::size_t channels = shape.size() == 3 ? shape[2] : rows && shape.size() == 2 ? shape[1] : 1;
  if (shape.empty() || shape.size() > 3 || channels < 1 || channels > 4)
    return unreadable("its shape is none of [n], [n, k], [height, width] and [height, width, k] with k from 1 to 4.");
  const std::size_t height = shape[0], width = rows ? 1 : shape[1];
  if (width < 1 || height < 1) return unreadable("it has no numbers.");
  if (width > max_pixels || height > max_pixels / width)
    return unreadable("it has more than " + std::to_string(max_pixels) + " pixels.");
  return Pixels{{static_cast<int>(width), static_cast<int>(height), 32, {}, {}}, channels};
}

/// Reads numbers of one type as floats, divided by `max_value`.
template <class Number>
Result<DataImage> read_numbers(Pixels pixels, std::string_view numbers, int bits, float max_value) {
  const std::size_t count =
      static_cast<std::size_t>(pixels.image.width) * static_cast<std::size_t>(pixels.image.height);
  if (numbers.size() < count * pixels.channels * sizeof(Number)) return unreadable("it is cut off.");
  DataImage& image = pixels.image;
  image.bits = bits;
  image.rgba.assign(4 * count, 0.0f);
  for (std::size_t i = 0; i < count; ++i) {
    float* rgba = &image.rgba[4 * i];
    rgba[3] = 1;
    for (std::size_t k = 0; k < pixels.channels; ++k) {
      Number number;
      std::memcpy(&number, numbers.data() + (i * pixels.channels + k) * sizeof(Number), sizeof(Number));
      rgba[k] = static_cast<float>(number) / max_value;
    }
    if (pixels.channels == 1) rgba[1] = rgba[2] = rgba[0];
  }
  return std::move(image);
}

}  // namespace

std::string encode_npy(std::span<const std::size_t> shape, std::span<const float> values) {
  return encode(shape, values, "<f4");
}

std::string encode_npy(std::span<const std::size_t> shape, std::span<const double> values) {
  return encode(shape, values, "<f8");
}

std::string encode_npy(std::span<const std::size_t> shape, std::span<const std::uint8_t> values) {
  return encode(shape, values, "|u1");
}

bool is_npy(std::string_view bytes) { return bytes.starts_with(magic); }

Result<DataImage> decode_npy(std::string_view bytes, std::size_t max_pixels) {
  Result<Layout> layout = layout_of(bytes);
  if (!layout) return layout.status();
  Result<Pixels> pixels = pixels_of(layout->shape, max_pixels);
  if (!pixels) return pixels.status();
  if (layout->type == "<f4") return read_numbers<float>(std::move(*pixels), layout->numbers, 32, 1);
  if (layout->type == "<f8") return read_numbers<double>(std::move(*pixels), layout->numbers, 32, 1);
  if (layout->type == "|u1") return read_numbers<std::uint8_t>(std::move(*pixels), layout->numbers, 8, 255);
  if (layout->type == "<u2") return read_numbers<std::uint16_t>(std::move(*pixels), layout->numbers, 16, 65535);
  return unreadable("its numbers are none of uint8, uint16, float32 and float64.");
}

}  // namespace pelage
