// A model file with the files that it names, as one upload.
#pragma once

#include <string>
#include <vector>

#include "base/status.h"

namespace pelage {

/// What PUT model is sent: the file's own bytes, or a zip archive of it and of what it names.
struct PackedModel {
  std::string bytes;
  bool is_zip = false;
  std::vector<std::string> missing;  // files that it names and that cannot be read
};

/// Reads an OBJ's material files and their pictures, and a .gltf's buffers and pictures, from beside it. Other files
/// are sent as they are. Names that lead out of the model's folder and below are not followed. `ending` is that of the
/// path, in lower case. Fails where the model cannot be read (not_found) or all together is over `max_bytes`
/// (too_large).
Result<PackedModel> pack_model(const std::string& path, const std::string& ending, std::size_t max_bytes);

/// Files that the text of an OBJ, a material file or a glTF names, as they are written there, each once.
std::vector<std::string> names_in_obj(const std::string& text);
std::vector<std::string> names_in_mtl(const std::string& text);
std::vector<std::string> names_in_gltf(const std::string& text);

}  // namespace pelage
