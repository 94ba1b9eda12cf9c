// Reads the base colours and base-colour pictures of an assimp scene.
#pragma once

#include <assimp/scene.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/scene.h"
#include "server/import_worker/bundle.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Reads materials on demand, each once.
class MaterialReader {
 public:
  MaterialReader(const aiScene& scene, ModelFormat format, const Bundle& bundle, RawModel& model)
      : scene_(scene), format_(format), bundle_(bundle), model_(model) {}

  struct Entry {
    std::uint16_t index = 0;  // in RawModel::materials
    unsigned uv_channel = 0;
  };

  /// Reads a material of the scene. Refused (invalid) if there are too many. Pictures that are missing, broken, too
  /// large, or neither PNG nor JPEG are counted among the losses.
  Result<Entry> read(unsigned material);

 private:
  /// Returns the bytes of a picture inside the file or bundled with it.
  std::optional<std::string_view> bytes_of(const char* path) const;
  /// Returns the index of the picture; -1 if it is missing or broken.
  int read_image(const std::string& path);

  const aiScene& scene_;
  ModelFormat format_;
  const Bundle& bundle_;
  RawModel& model_;
  std::map<unsigned, Entry> materials_;
  std::map<std::string, int> images_;  // by path
};

}  // namespace pelage
