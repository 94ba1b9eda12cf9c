// Loads the pictures that commands name, and writes maps as files.
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

/// Returns the names of the pictures that the commands read, each once.
std::vector<std::string> pictures_read_by(const std::vector<Command>& commands);

/// The pictures that a command reads; null where it reads none.
struct ReadPictures {
  std::shared_ptr<const MapPicture> own;    // the picture of a `map`, or of a `mask` by a picture
  std::shared_ptr<const MapPicture> alpha;  // the alpha picture of its brush
};

/// Loads the pictures that the commands of a batch read; each is in memory once.
class BatchPictures {
 public:
  static constexpr std::size_t max = 8;  // maximum number of different pictures in a batch; each takes up to 256 MiB

  explicit BatchPictures(const Journal& journal) : journal_(journal) {}

  /// Returns the pictures that the command reads. Refuses (invalid) a name that the journal does not have, a batch that
  /// reads too many pictures, vectors from a picture that holds no floats, and a list of vertices whose length is not
  /// `vertices`, the number of vertices of the mesh.
  Result<ReadPictures> find(const Command& command, std::size_t vertices);

 private:
  Result<std::shared_ptr<const MapPicture>> read(const std::string& name, const char* pointer);

  const Journal& journal_;
  std::map<std::string, std::shared_ptr<const MapPicture>> known_;
};

/// Refuses (invalid, "/picture") an unknown name, or the name of a picture that was uploaded as data.
Status check_skin_texture(const std::string& name, const Journal& journal);

/// Returns the content hash of the bytes, 32 hex digits, so that a log finds its picture on another server too.
std::string name_of_picture(std::string_view bytes);

struct MapFile {
  std::string bytes;
  const char* content_type = "image/png";
  MapAnswer answer;
};

/// Draws a field as a map file whose text entries state its field, encoding and scale. An EXR holds a value in Y, a
/// colour in R, G, B and A, premultiplied, and the other encodings in R, G, B and A. A PNG holds grey, or colours with
/// straight alpha; the blue channel of uv_tangent is 0. Refuses (invalid) a model without texture coordinates.
Result<MapFile> make_map_file(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

}  // namespace pelage
