#include "server/import_worker/gltf_numbers.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pelage {

namespace {

using gltf::index;
using gltf::item;
using gltf::json;
using gltf::list;
using gltf::text;

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Decodes base64. gltf_check has made sure that `digits` are nothing else.
std::string from_base64(std::string_view digits) {
  while (digits.ends_with('=')) digits.remove_suffix(1);
  std::array<std::uint32_t, 256> values{};
  for (std::uint32_t i = 0; i < base64_digits.size(); ++i) values[static_cast<unsigned char>(base64_digits[i])] = i;
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : digits) {
    bits = bits << 6 | values[static_cast<unsigned char>(digit)], count += 6;
    if (count >= 8) count -= 8, bytes.push_back(static_cast<char>(bits >> count & 0xff));
  }
  return bytes;
}

/// Returns how many numbers an item has; 0 for matrices and unknown types.
std::int64_t width_of(const std::string& type) {
  if (type == "SCALAR") return 1;
  return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

/// The storage of a number.
struct Component {
  std::int64_t bytes;
  double largest;  // stored value of 1 for normalized numbers
  double (*read)(const char*);
};

template <class T>
double read_number(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);  // little-endian, as this machine
  return static_cast<double>(value);
}

std::optional<Component> component_of(std::int64_t type) {
  switch (type) {
    case 5120: return Component{1, 127, read_number<std::int8_t>};
    case 5121: return Component{1, 255, read_number<std::uint8_t>};
    case 5122: return Component{2, 32767, read_number<std::int16_t>};
    case 5123: return Component{2, 65535, read_number<std::uint16_t>};
    case 5125: return Component{4, 4294967295, read_number<std::uint32_t>};
    case 5126: return Component{4, 1, read_number<float>};
    default: return {};
  }
}

/// Returns the part of the buffer with `count` items of `bytes` bytes, `stride` bytes apart; none if it does not fit.
std::optional<std::string_view> cut(std::string_view buffer, std::int64_t begin, std::int64_t stride,
                                    std::int64_t count, std::int64_t bytes) {
  constexpr std::int64_t large = std::int64_t{1} << 30;  // above the size of any model; keeps products in range
  const auto size = static_cast<std::int64_t>(buffer.size());
  if (begin > size || stride > large || count > large || count < 1) return {};
  const std::int64_t wanted = stride * (count - 1) + bytes;
  if (wanted > size - begin) return {};
  return buffer.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(wanted));
}

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string digits;
  digits.reserve((bytes.size() + 2) / 3 * 4);
  const auto at = [&](std::size_t i) {
    return i < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[i])} : 0;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) digits.push_back(base64_digits[three >> shift & 63]);
  }
  const std::size_t missing = (3 - bytes.size() % 3) % 3;
  return digits.replace(digits.size() - missing, missing, missing, '=');
}

const std::string_view* GltfNumbers::buffer(std::int64_t number) {
  if (const auto known = buffers_.find(number); known != buffers_.end()) return &known->second;
  const json* entry = item(list(root_, "buffers"), number);
  if (!entry) return nullptr;
  const std::string uri = text(*entry, "uri");
  std::string_view bytes = binary_;
  if (uri.starts_with("data:")) {
    bytes = decoded_[number] = from_base64(std::string_view(uri).substr(uri.find(',') + 1));
  } else if (!uri.empty()) {
    const std::string* bundled = bundle_.find(uri);
    if (!bundled) return nullptr;
    bytes = *bundled;
  }
  return &buffers_.emplace(number, bytes).first->second;
}

std::optional<std::vector<double>> GltfNumbers::of(std::int64_t accessor) {
  const json* entry = item(list(root_, "accessors"), accessor);
  const json* view = entry ? item(list(root_, "bufferViews"), index(*entry, "bufferView")) : nullptr;
  if (!view || entry->contains("sparse")) return {};
  const std::optional<Component> component = component_of(index(*entry, "componentType"));
  const std::int64_t width = width_of(text(*entry, "type")), count = index(*entry, "count");
  const std::string_view* bytes = buffer(index(*view, "buffer"));
  if (!component || width == 0 || !bytes) return {};
  const std::int64_t tight = width * component->bytes, stride = std::max(index(*view, "byteStride"), tight);
  const std::int64_t first = std::max<std::int64_t>(index(*view, "byteOffset"), 0),
                     begin = std::max<std::int64_t>(index(*entry, "byteOffset"), 0);
  if (first > static_cast<std::int64_t>(bytes->size())) return {};
  const auto items = cut(bytes->substr(static_cast<std::size_t>(first)), begin, stride, count, tight);
  if (!items) return {};
  const auto normalized = entry->find("normalized");
  const bool is_share = normalized != entry->end() && *normalized == true;
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(width * count));
  for (std::int64_t i = 0; i < count; ++i) {
    for (std::int64_t k = 0; k < width; ++k) {
      const double number = component->read(items->data() + i * stride + k * component->bytes);
      numbers.push_back(is_share ? std::max(number / component->largest, -1.0) : number);
    }
  }
  return numbers;
}

}  // namespace pelage
