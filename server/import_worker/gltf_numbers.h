// The numbers that a glTF file keeps in its buffers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/import_worker/bundle.h"
#include "server/import_worker/gltf_json.h"

namespace pelage {

/// Reads accessors of a document. All three are kept by reference.
class GltfNumbers {
 public:
  /// `binary` is the binary chunk of a GLB.
  GltfNumbers(const gltf::json& root, const Bundle& bundle, std::string_view binary)
      : root_(root), bundle_(bundle), binary_(binary) {}

  /// The numbers of a scalar or vector accessor, item after item; integers that are normalized lie in [-1, 1]. None
  /// where it is not there, has another type, is sparse, or reaches beyond its buffer.
  std::optional<std::vector<double>> of(std::int64_t accessor);

 private:
  /// Null where it is not there.
  const std::string_view* buffer(std::int64_t number);

  const gltf::json& root_;
  const Bundle& bundle_;
  std::string_view binary_;
  std::map<std::int64_t, std::string> decoded_;  // of data URIs
  std::map<std::int64_t, std::string_view> buffers_;
};

std::string to_base64(std::string_view bytes);

}  // namespace pelage
