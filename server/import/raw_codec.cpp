// The encodings of models, guide curves, environments and pictures. A model has a signature, then its arrays one after
// the other, each after its count.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

#include "base/limits.h"
#include "server/import/import.h"

namespace pelage {

namespace {

// "PELRAW3". Older journals have "PELRAW2", the same without names of materials, and "PELRAW1", also without notes.
constexpr std::uint64_t raw_signature = 0x33'57'41'52'4c'45'50ULL, without_names = 0x32'57'41'52'4c'45'50ULL,
                        without_notes = 0x31'57'41'52'4c'45'50ULL;

/// A material without its name.
struct StoredMaterial {
  glm::vec3 base_colour{1};
  std::int32_t image = -1;
};
static_assert(sizeof(StoredMaterial) == 16);

class Writer {
 public:
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&v), sizeof v);
  }

  template <class T>
  void array(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads values as Writer writes them. After the first missing one, all are zero or empty, and ok() is false.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class T>
  T value() {
    T v{};
    take(&v, sizeof v);
    return v;
  }

  template <class T>
  std::vector<T> array() {
    const std::uint64_t count = value<std::uint64_t>();
    if (count > left_.size() / sizeof(T)) ok_ = false;  // before anything is allocated
    if (!ok_) return {};
    std::vector<T> values(count);
    take(values.data(), count * sizeof(T));
    return values;
  }

  bool ok() const { return ok_; }
  bool at_end() const { return ok_ && left_.empty(); }

 private:
  void take(void* out, std::size_t size) {
    ok_ = ok_ && size <= left_.size();
    if (!ok_ || size == 0) return;
    std::memcpy(out, left_.data(), size);
    left_ = left_.subspan(size);
  }

  std::span<const std::byte> left_;
  bool ok_ = true;
};

void write_texts(Writer& out, const std::vector<std::string>& texts) {
  out.value(static_cast<std::uint64_t>(texts.size()));
  for (const std::string& text : texts) out.array(std::vector<char>(text.begin(), text.end()));
}

std::vector<std::string> read_texts(Reader& in) {
  std::vector<std::string> texts;
  const std::uint64_t count = in.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count && in.ok(); ++i) {
    const std::vector<char> text = in.array<char>();
    texts.emplace_back(text.begin(), text.end());
  }
  return texts;
}

/// Writes the axes, the pose, the animations and the losses.
void write_notes(Writer& out, const RawModel& model) {
  const auto axis = [&](const std::optional<Axis>& value) {
    out.value(static_cast<std::int8_t>(value ? static_cast<int>(*value) : -1));
  };
  axis(model.up), axis(model.front);
  write_texts(out, {model.pose});
  write_texts(out, model.animations);
  out.value(static_cast<std::uint64_t>(model.losses.size()));
  for (const Repair& loss : model.losses) {
    write_texts(out, {loss.code});
    out.value(static_cast<std::uint64_t>(loss.count));
    write_texts(out, loss.names);
  }
}

std::optional<Axis> read_axis(Reader& in) {
  const auto number = in.value<std::int8_t>();
  if (number < 0 || number > static_cast<int>(Axis::minus_z)) return {};
  return static_cast<Axis>(number);
}

std::string read_text(Reader& in) {
  std::vector<std::string> texts = read_texts(in);
  return texts.empty() ? std::string() : std::move(texts.front());
}

void read_notes(Reader& in, RawModel& model) {
  model.up = read_axis(in), model.front = read_axis(in);
  model.pose = read_text(in);
  model.animations = read_texts(in);
  const std::uint64_t losses = in.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < losses && in.ok(); ++i) {
    Repair loss{read_text(in), 0};
    loss.count = in.value<std::uint64_t>();
    loss.names = read_texts(in);
    model.losses.push_back(std::move(loss));
  }
}

/// The parts that only newer encodings of models have.
struct Beside {
  bool notes = true, names = true;
};

RawModel read_model(Reader& in, Beside beside) {
  RawModel model;
  model.is_32_bit = in.value<std::uint8_t>() != 0;
  model.positions = in.array<glm::dvec3>();
  model.face_sizes = in.array<std::uint32_t>();
  model.corners = in.array<std::uint32_t>();
  model.corner_uv = in.array<glm::dvec2>();
  model.corner_colour = in.array<glm::vec4>();
  model.face_material = in.array<std::uint16_t>();
  for (const StoredMaterial& material : in.array<StoredMaterial>())
    model.materials.push_back({material.base_colour, material.image});
  model.length_scale = in.array<float>();
  const std::uint64_t images = in.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < images && in.ok(); ++i) {
    RawImage image;
    image.width = in.value<std::int32_t>();
    image.height = in.value<std::int32_t>();
    image.rgba = in.array<std::uint8_t>();
    model.images.push_back(std::move(image));
  }
  if (beside.notes) read_notes(in, model);
  if (!beside.names) return model;
  const std::vector<std::string> names = read_texts(in);
  for (std::size_t i = 0; i < std::min(names.size(), model.materials.size()); ++i) model.materials[i].name = names[i];
  return model;
}

bool counts_agree(const RawModel& model) {
  const std::size_t corners = model.corners.size(), faces = model.face_sizes.size();
  const auto none_or = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  const std::uint64_t sum = std::accumulate(model.face_sizes.begin(), model.face_sizes.end(), std::uint64_t{0});
  return sum == corners && corners < no_position && model.positions.size() < no_position &&
         none_or(model.corner_uv.size(), corners) && none_or(model.corner_colour.size(), corners) &&
         none_or(model.face_material.size(), faces) && none_or(model.length_scale.size(), model.positions.size());
}

bool indices_are_in_range(const RawModel& model) {
  for (std::uint32_t size : model.face_sizes) {
    if (size == 0) return false;
  }
  for (std::uint32_t corner : model.corners) {
    if (corner >= model.positions.size() && corner != no_position) return false;
  }
  for (std::uint16_t material : model.face_material) {
    if (material >= model.materials.size()) return false;
  }
  for (const RawMaterial& material : model.materials) {
    if (material.image < -1 || material.image >= static_cast<std::int64_t>(model.images.size())) return false;
  }
  return true;
}

bool values_are_good(const RawModel& model) {
  for (const RawImage& image : model.images) {
    if (image.width <= 0 || image.height <= 0) return false;
    const auto pixels = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height);
    if (image.rgba.size() != 4 * pixels) return false;
  }
  for (float scale : model.length_scale) {
    if (!(scale > 0 && scale <= 4)) return false;
  }
  return true;
}

}  // namespace

std::string encode_raw_model(const RawModel& model) {
  Writer out;
  out.value(raw_signature);
  out.value(static_cast<std::uint8_t>(model.is_32_bit));
  out.array(model.positions);
  out.array(model.face_sizes);
  out.array(model.corners);
  out.array(model.corner_uv);
  out.array(model.corner_colour);
  out.array(model.face_material);
  std::vector<StoredMaterial> materials;
  std::vector<std::string> names;
  for (const RawMaterial& material : model.materials) {
    materials.push_back({material.base_colour, material.image});
    names.push_back(material.name);
  }
  out.array(materials);
  out.array(model.length_scale);
  out.value(static_cast<std::uint64_t>(model.images.size()));
  for (const RawImage& image : model.images) {
    out.value(static_cast<std::int32_t>(image.width));
    out.value(static_cast<std::int32_t>(image.height));
    out.array(image.rgba);
  }
  write_notes(out, model);
  write_texts(out, names);
  return out.take();
}

Result<RawModel> decode_raw_model(std::span<const std::byte> bytes) {
  Reader in(bytes);
  const auto signature = in.value<std::uint64_t>();
  if (signature != raw_signature && signature != without_names && signature != without_notes)
    return failure(Code::invalid, "The bytes are no raw model.");
  RawModel model = read_model(in, {signature != without_notes, signature == raw_signature});
  if (!in.at_end()) return failure(Code::invalid, "The raw model is cut off, or counts more than it holds.");
  if (!counts_agree(model)) return failure(Code::invalid, "The counts of the raw model do not agree.");
  if (!indices_are_in_range(model)) return failure(Code::invalid, "An index of the raw model is out of range.");
  if (!values_are_good(model)) return failure(Code::invalid, "A value of the raw model is out of range.");
  return model;
}

// Guide curves: up axis and unit (-1 and 0 if the file gives none), number of curves left out, number of curves, then
// for each curve its number of points and the points. Native byte order.

std::string encode_guides(const GuideFile& file) {
  Writer out;
  out.value(static_cast<std::int8_t>(file.up ? static_cast<int>(*file.up) : -1));
  out.value(file.metres.value_or(0));
  out.value(file.single);
  out.value(static_cast<std::uint64_t>(file.curves.size()));
  for (const GuideCurve& curve : file.curves) out.array(curve);
  return out.take();
}

Result<GuideFile> decode_guides(std::span<const std::byte> bytes) {
  const Status misfit = failure(Code::invalid, "The bytes are no guide curves.");
  Reader in(bytes);
  GuideFile file;
  file.up = read_axis(in);
  const auto metres = in.value<double>();
  if (!(metres >= 0) || !std::isfinite(metres)) return misfit;
  if (metres > 0) file.metres = metres;
  file.single = in.value<std::uint64_t>();
  std::vector<GuideCurve>& curves = file.curves;
  const auto count = in.value<std::uint64_t>();
  for (std::uint64_t i = 0; i < count && in.ok(); ++i) {
    const GuideCurve& curve = curves.emplace_back(in.array<glm::dvec3>());
    if (curve.size() < 2 || !std::all_of(curve.begin(), curve.end(), is_finite)) return misfit;
  }
  return in.at_end() ? Result<GuideFile>(std::move(file)) : misfit;
}

// The worker's answers for pictures: nine vectors of doubles for an environment, or width, height and RGBA bytes.
// Native byte order.

namespace {

struct Sides {
  std::int32_t width = 0, height = 0;
};

bool is_side(std::int32_t pixels) { return pixels >= 1 && pixels <= limits::picture_pixels; }

bool is_harmonic(double value) { return std::abs(value) <= limits::harmonic; }  // false for NaN

}  // namespace

std::string encode_harmonics(const SphericalHarmonics& harmonics) {
  return {reinterpret_cast<const char*>(harmonics.data()), sizeof harmonics};
}

Result<SphericalHarmonics> decode_harmonics(std::span<const std::byte> bytes) {
  SphericalHarmonics harmonics{};
  if (bytes.size() != sizeof harmonics) return failure(Code::invalid, "The bytes are no spherical harmonics.");
  std::memcpy(harmonics.data(), bytes.data(), bytes.size());
  for (const glm::dvec3& v : harmonics) {
    if (!is_harmonic(v.x) || !is_harmonic(v.y) || !is_harmonic(v.z)) {
      return failure(Code::invalid, "A spherical harmonic is out of range.");
    }
  }
  return harmonics;
}

std::string encode_raw_image(const RawImage& image) {
  const Sides sides{image.width, image.height};
  std::string bytes(reinterpret_cast<const char*>(&sides), sizeof sides);
  return bytes.append(reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size());
}

Result<RawImage> decode_raw_image(std::span<const std::byte> bytes) {
  Sides sides;
  if (bytes.size() >= sizeof sides) std::memcpy(&sides, bytes.data(), sizeof sides);
  if (!is_side(sides.width) || !is_side(sides.height)) {
    return failure(Code::invalid, "The sides of the picture are out of range.");
  }
  const auto pixels = static_cast<std::size_t>(sides.width) * static_cast<std::size_t>(sides.height);
  if (bytes.size() != sizeof sides + 4 * pixels) return failure(Code::invalid, "The picture's bytes do not fit it.");
  RawImage image{sides.width, sides.height, std::vector<std::uint8_t>(4 * pixels)};
  std::memcpy(image.rgba.data(), bytes.data() + sizeof sides, image.rgba.size());
  return image;
}

}  // namespace pelage
