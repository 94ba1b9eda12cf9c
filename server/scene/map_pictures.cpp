#include "server/scene/map_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "protocol/json/names.h"
#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/image/npy.h"
#include "renderer/picture_files/picture_files.h"
#include "server/groom/brush.h"
#include "server/maps/draw_map.h"
#include "server/patches/patches.h"
#include "server/scene/digest.h"

namespace pelage {

namespace {

/// The name of a picture and the JSON pointer to it in its command; "" for none.
struct NamedPicture {
  std::string name;
  const char* pointer = "";
};

NamedPicture picture_of(const Command& command) {
  if (const auto* map = std::get_if<ApplyMap>(&command)) return {map->picture, "/picture"};
  const auto* mask = std::get_if<ChangeMask>(&command);
  const auto* shape = mask ? std::get_if<MaskPicture>(&mask->shape) : nullptr;
  return shape ? NamedPicture{shape->name, "/picture/name"} : NamedPicture{};
}

NamedPicture alpha_of(const Command& command) {
  const Brush* brush = brush_of(command);
  return brush ? NamedPicture{brush->alpha, "/brush/alpha"} : NamedPicture{};
}

Status unknown_picture(std::string pointer) {
  return failure(Code::invalid, "there is no such picture here; upload it first", std::move(pointer));
}

}  // namespace

std::vector<std::string> pictures_read_by(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) {
    for (const std::string& name : {picture_of(command).name, alpha_of(command).name})
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Result<std::shared_ptr<const MapPicture>> BatchPictures::read(const std::string& name, const char* pointer) {
  if (name.empty()) return std::shared_ptr<const MapPicture>();
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  if (!journal_.has_picture(name)) return unknown_picture(pointer);
  if (known_.size() == max)
    return failure(Code::invalid, "a batch reads too many pictures", pointer, std::to_string(max) + " different ones");
  const Result<std::string> bytes = journal_.picture(name);
  if (!bytes) return bytes.status();
  Result<MapPicture> picture = decode_map_picture(std::as_bytes(std::span(*bytes)));
  if (!picture) return failure(Code::internal, "the journal is damaged: a picture cannot be read");
  return known_[name] = std::make_shared<const MapPicture>(std::move(*picture));
}

namespace {

Status check_fit(const ApplyMap& map, const MapPicture& picture, std::size_t vertices) {
  const bool list = map.encoding == MapEncoding::vertices;
  const bool vectors = map.encoding == MapEncoding::vector || (list && map.field == Field::direction);
  if (vectors && picture.bits != 32)
    return failure(Code::invalid, "vectors have parts below 0, and this picture holds no floats", "/encoding",
                   "a picture of floats, such as an EXR");
  const std::size_t entries = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (list && entries != vertices)
    return failure(Code::invalid, fmt::format("the list has {} entries, and the mesh has other vertices", entries),
                   "/picture", std::to_string(vertices) + " entries");
  return {};
}

}  // namespace

Result<ReadPictures> BatchPictures::find(const Command& command, std::size_t vertices) {
  const NamedPicture named = picture_of(command), alpha = alpha_of(command);
  auto own = read(named.name, named.pointer);
  if (!own) return own.status();
  auto of_brush = read(alpha.name, alpha.pointer);
  if (!of_brush) return of_brush.status();
  if (const auto* map = std::get_if<ApplyMap>(&command))
    if (Status unfit = check_fit(*map, **own, vertices); !unfit.ok()) return unfit;
  return ReadPictures{std::move(*own), std::move(*of_brush)};
}

Status check_skin_texture(const std::string& name, const Journal& journal) {
  if (!journal.has_picture(name)) return unknown_picture("/picture");
  const Result<std::string> bytes = journal.picture(name);
  if (!bytes) return bytes.status();
  if (decode_raw_image(std::as_bytes(std::span(*bytes)))) return {};
  return failure(Code::invalid, "this picture was uploaded as data; upload it to skin_texture", "/picture");
}

std::string name_of_picture(std::string_view bytes) { return digest(bytes); }

namespace {

/// Returns the text entries that describe the file. A scale of lengths is in sizes, whatever the units of the request.
std::vector<ImageText> texts_of(const MapAnswer& answer, double model_size) {
  const bool is_length = answer.field == Field::length || answer.encoding == MapEncoding::vector;
  const double scale = is_length && answer.units == Units::world ? answer.scale / model_size : answer.scale;
  return {{"pelage:field", std::string(shape_of(answer.field).name)},
          {"pelage:encoding", std::string(json_names::text_of(json_names::map_encodings, answer.encoding))},
          {map_scale_text, fmt::format("{}", scale)}};
}

/// Converts the map to a picture with red, green, blue and alpha. A single channel becomes grey.
template <class Picture>
Picture integer_picture(const DrawnMap& map) {
  using Sample = typename decltype(Picture::rgba)::value_type;
  constexpr int bits = 8 * sizeof(Sample);
  const int channels = map.layout.channels;
  const std::size_t pixels = map.image.covered.size();
  Picture picture{map.image.size, map.image.size, std::vector<Sample>(4 * pixels)};
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* values = map.image.at(i);
    const auto sample = [&](int k) {
      return static_cast<Sample>(encode_channel(map.layout.kinds[static_cast<std::size_t>(k)], values[k], bits));
    };
    Sample* out = &picture.rgba[4 * i];
    for (int k = 0; k < channels; ++k) out[k] = sample(k);
    if (channels == 1) out[1] = out[2] = out[0];
    if (channels < 4) out[3] = static_cast<Sample>(-1);
  }
  return picture;
}

template <class Picture>
std::string encode_integers(const DrawnMap& map, const std::vector<ImageText>& texts) {
  const bool colour = map.layout.premultiplied;
  return encode_png(integer_picture<Picture>(map), map.layout.channels == 4, texts,
                    colour ? PngNumbers::srgb : PngNumbers::data);
}

/// Converts the values to the numbers that a file of floats holds.
void put_file_numbers(DrawnMap& map) {
  const auto channels = static_cast<std::size_t>(map.layout.channels);
  for (std::size_t i = 0; i < map.image.values.size(); ++i) {
    const ChannelKind kind = map.layout.kinds[i % channels];
    map.image.values[i] = static_cast<float>(encode_channel(kind, map.image.values[i], 32));
  }
}

std::string encode_floats(const DrawnMap& map, ExrSample sample, const std::vector<ImageText>& texts) {
  const auto channels = static_cast<std::size_t>(map.layout.channels);
  if (channels == 1) {
    const std::vector<ExrPlane> grey{{"Y", map.image.values, 0, 1, sample}};
    return picture_files().encode_exr({map.image.size, map.image.size}, grey, texts);
  }
  const std::vector<float> nothing(channels == 2 ? map.image.covered.size() : 0, 0.0f);
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < channels; ++k)
    planes.push_back({std::string(1, "RGBA"[k]), map.image.values, k, channels, sample});
  if (channels == 2) planes.push_back({"B", nothing, 0, 1, sample});
  return picture_files().encode_exr({map.image.size, map.image.size}, planes, texts);
}

}  // namespace

namespace {

std::string encode_array(const DrawnMap& map) {
  const auto size = static_cast<std::size_t>(map.image.size), channels = static_cast<std::size_t>(map.layout.channels);
  std::vector<std::size_t> shape{size, size};
  if (channels > 1) shape.push_back(channels);
  return encode_npy(shape, std::span(std::as_const(map.image.values)));
}

MapFile make_list_file(const Mesh& mesh, const FieldSet& fields, const MapRequest& request) {
  const VertexList list = list_vertices(mesh, fields, request);
  std::vector<std::size_t> shape{mesh.positions.size()};
  if (list.channels > 1) shape.push_back(list.channels);
  return {encode_npy(shape, std::span(list.values)), npy_type, list.answer};
}

}  // namespace

Result<MapFile> make_map_file(const Mesh& mesh, const FieldSet& fields, const MapRequest& request) {
  if (request.encoding == MapEncoding::vertices) return make_list_file(mesh, fields, request);
  if (!has_own_uvs(mesh))
    return failure(Code::invalid, "the model has no texture coordinates to lay a map by", "",
                   "a model with texture coordinates; docs/models.md says which have some");
  DrawnMap map = draw_map(mesh, fields, request);
  const std::vector<ImageText> texts = texts_of(map.answer, mesh.size);
  if (request.format != MapFormat::png && request.format != MapFormat::png16) put_file_numbers(map);
  switch (request.format) {
    case MapFormat::png: return MapFile{encode_integers<Image>(map, texts), "image/png", map.answer};
    case MapFormat::png16: return MapFile{encode_integers<Image16>(map, texts), "image/png", map.answer};
    case MapFormat::exr: return MapFile{encode_floats(map, ExrSample::single, texts), "image/x-exr", map.answer};
    case MapFormat::exr_half: return MapFile{encode_floats(map, ExrSample::half, texts), "image/x-exr", map.answer};
    case MapFormat::npy: break;
  }
  return MapFile{encode_array(map), npy_type, map.answer};
}

}  // namespace pelage
