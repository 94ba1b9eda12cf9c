#include "server/import_worker/parse.h"

namespace pelage {

Result<RawModel> parse_model(ModelFormat format, std::string bytes) {
  if (bytes.empty()) return broken("the file is empty.");
  switch (format) {
    case ModelFormat::obj: return parse_obj(std::move(bytes));
    case ModelFormat::ply: return parse_ply(bytes);
    case ModelFormat::stl: return parse_stl(bytes);
    case ModelFormat::off: return parse_off(bytes);
    case ModelFormat::gltf:
    case ModelFormat::glb:
    case ModelFormat::tds: return parse_with_assimp(format, bytes);
  }
  return broken("the format is unknown.");
}

}  // namespace pelage
