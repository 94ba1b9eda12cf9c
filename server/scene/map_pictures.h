// Pictures that commands name, and maps as files.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/fields/field_set.h"
#include "server/history/journal.h"
#include "server/import/map_picture.h"
#include "server/surface/mesh.h"

namespace pelage {

/// The names of the pictures that the commands read, each once.
std::vector<std::string> pictures_read_by(const std::vector<Command>& commands);

/// What a command reads; null for none.
struct ReadPictures {
  std::shared_ptr<const MapPicture> own;    // of map, and of a mask by a picture
  std::shared_ptr<const MapPicture> alpha;  // of its brush
};

/// The pictures that the commands of a batch read, each once in memory.
class BatchPictures {
 public:
  static constexpr std::size_t max = 8;  // different ones in a batch: each takes up to 256 MiB

  explicit BatchPictures(const Journal& journal) : journal_(journal) {}

  /// The pictures that the command reads. Refused (invalid) when the journal has none of that
  /// name, when the batch reads too many, when vectors are to be read from a picture that holds no floats, and when a
  /// list of vertices is not as long as the mesh has `vertices`.
  Result<ReadPictures> find(const Command& command, std::size_t vertices);

 private:
  Result<std::shared_ptr<const MapPicture>> read(const std::string& name, const char* pointer);

  const Journal& journal_;
  std::map<std::string, std::shared_ptr<const MapPicture>> known_;
};

/// Refuses (invalid, "/picture") a name that is not known, or is that of a picture that was uploaded as data.
Status check_skin_texture(const std::string& name, const Journal& journal);

/// 32 hex digits that follow from the bytes alone, so that a log finds its picture on another server too.
std::string name_of_picture(std::string_view bytes);

struct MapFile {
  std::string bytes;
  const char* content_type = "image/png";
  MapAnswer answer;
};

/// The map as a file, which says its field, encoding and scale in its texts. EXR: value in Y, or R, G, B and A of a
/// colour, multiplied by its cover; the other encodings in R, G, B and A. PNG: grey, or colours with straight alpha;
/// blue of uv_tangent is 0. Refused (invalid) for a model without texture coordinates.
Result<MapFile> make_map_file(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

}  // namespace pelage
