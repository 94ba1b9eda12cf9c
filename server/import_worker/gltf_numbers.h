// Reads the numbers that a glTF file stores in its buffers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/import_worker/bundle.h"
#include "server/import_worker/gltf_json.h"

namespace pelage {

/// Reads accessors of a document. All three arguments of the constructor must outlive it.
class GltfNumbers {
 public:
  /// `binary` is the binary chunk of a GLB; empty for a glTF document.
  GltfNumbers(const gltf::json& root, const Bundle& bundle, std::string_view binary)
      : root_(root), bundle_(bundle), binary_(binary) {}

  /// Returns the numbers of a scalar or vector accessor, item after item; normalized integers are in [-1, 1]. None if
  /// the accessor is missing, has another type, is sparse, or reaches beyond its buffer.
  std::optional<std::vector<double>> of(std::int64_t accessor);

 private:
  /// Returns the bytes of a buffer; null if it is missing.
  const std::string_view* buffer(std::int64_t number);

  const gltf::json& root_;
  const Bundle& bundle_;
  std::string_view binary_;
  std::map<std::int64_t, std::string> decoded_;  // bytes of data URIs
  std::map<std::int64_t, std::string_view> buffers_;
};

std::string to_base64(std::string_view bytes);

}  // namespace pelage
