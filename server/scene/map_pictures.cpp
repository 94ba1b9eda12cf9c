#include "server/scene/map_pictures.h"

#include <algorithm>
#include <cstring>

#include "protocol/base/random.h"

namespace pelage {

namespace {

/// The name, and where it stands in the command.
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

Status unknown_picture(std::string pointer) {
  return failure(Code::invalid, "there is no such picture here; upload it first", std::move(pointer));
}

}  // namespace

std::vector<std::string> pictures_read_by(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) {
    const std::string name = picture_of(command).name;
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Result<std::shared_ptr<const MapPicture>> BatchPictures::read(const std::string& name, const char* pointer) {
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

Result<std::shared_ptr<const MapPicture>> BatchPictures::find(const Command& command) {
  const NamedPicture named = picture_of(command);
  if (named.name.empty()) return std::shared_ptr<const MapPicture>();
  auto picture = read(named.name, named.pointer);
  const auto* map = std::get_if<ApplyMap>(&command);
  if (picture && map != nullptr && map->encoding == MapEncoding::vector && (*picture)->bits != 32)
    return failure(Code::invalid, "vectors have parts below 0, and this picture holds no floats", "/encoding",
                   "a picture of floats, such as an EXR");
  return picture;
}

Status check_skin_texture(const std::string& name, const Journal& journal) {
  if (!journal.has_picture(name)) return unknown_picture("/picture");
  const Result<std::string> bytes = journal.picture(name);
  if (!bytes) return bytes.status();
  if (decode_raw_image(std::as_bytes(std::span(*bytes)))) return {};
  return failure(Code::invalid, "this picture was uploaded as data; upload it to skin_texture", "/picture");
}

std::string name_of_picture(std::string_view bytes) {
  FieldsHash hash{bytes.size(), ~bytes.size()};
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    hash.low = mix_bits(hash.low ^ word);
    hash.high = mix_bits(hash.high + mix_bits(~word));
  }
  return to_hex(hash);
}

}  // namespace pelage
