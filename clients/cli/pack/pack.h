// Packs a model file and the files that it references into one upload.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"

namespace pelage {

/// The body of PUT model: the model file's own bytes, or a zip archive of it and the files that it references.
struct PackedModel {
  std::string bytes;
  bool is_zip = false;
  std::vector<std::string> missing;  // referenced files that cannot be read
};

/// Packs an OBJ with its material files and their pictures, and a .gltf with its buffers and pictures. Other formats
/// are sent as they are. Files outside the model's folder and its subfolders are not read. `extension` is the path's
/// extension in lower case, without its dot. Fails if the model cannot be read (not_found) or the total exceeds
/// `max_bytes` (too_large).
Result<PackedModel> pack_model(const std::string& path, const std::string& extension, std::size_t max_bytes);

/// Return the file names that the text of an OBJ, a material file or a glTF references, as written there, each once.
std::vector<std::string> names_in_obj(const std::string& text);
std::vector<std::string> names_in_mtl(const std::string& text);
std::vector<std::string> names_in_gltf(const std::string& text);

}  // namespace pelage
