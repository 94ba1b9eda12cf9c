#include "server/import_worker/parse.h"

namespace pelage {

Result<RawModel> parse_model(ModelFormat format, std::string octets) {
  if (octets.empty()) return broken("the file is empty.");
  switch (format) {
    case ModelFormat::obj: return parse_obj(std::move(octets));
    case ModelFormat::ply: return parse_ply(octets);
    case ModelFormat::stl: return parse_stl(octets);
    case ModelFormat::off: return parse_off(octets);
    case ModelFormat::gltf:
    case ModelFormat::glb:
    case ModelFormat::tds: return parse_with_assimp(format, octets);
  }
  return broken("the format is unknown.");
}

}  // namespace pelage
