// Base colours and base-colour pictures of an assimp scene.
#pragma once

#include <assimp/scene.h>

#include <map>
#include <vector>

#include "protocol/base/status.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Reads materials as meshes ask for them, each once.
class MaterialReader {
 public:
  MaterialReader(const aiScene& scene, ModelFormat format, RawModel& model)
      : scene_(scene), format_(format), model_(model) {}

  struct Entry {
    std::uint16_t index = 0;  // in RawModel::materials
    unsigned uv_channel = 0;
  };

  /// Refused (invalid) when a picture inside the file is broken, too large, or neither PNG nor JPEG.
  Result<Entry> read(unsigned material);

 private:
  Result<int> read_image(const char* path);

  const aiScene& scene_;
  ModelFormat format_;
  RawModel& model_;
  std::map<unsigned, Entry> materials_;
  std::map<const aiTexture*, int> images_;
};

}  // namespace pelage
