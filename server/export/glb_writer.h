// Writes binary glTF 2.0 files, accessor by accessor.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace pelage {

using GltfJson = nlohmann::ordered_json;

class GlbWriter {
 public:
  /// Makes files of at most `max_bytes`, because sizes in a GLB have 32 bits. Data beyond that is not stored, and
  /// finish() fails.
  explicit GlbWriter(std::uint64_t max_bytes = std::numeric_limits<std::uint32_t>::max()) : max_bytes_(max_bytes) {}

  /// These add an accessor of floats and return its index. add_positions also stores the bounds, which accessors of
  /// positions need (glTF 2.0, 3.7.2.1).
  int add(std::span<const float> values);
  int add(std::span<const glm::vec2> values);
  int add(std::span<const glm::vec3> values);
  int add(std::span<const glm::vec4> values);
  int add_positions(std::span<const glm::vec3> values);
  /// Adds an accessor of triangles and returns its index. Indices have 16 bits if there are few enough `vertices`.
  int add_triangles(std::span<const glm::uvec3> triangles, std::size_t vertices);
  /// Adds an image and returns its index.
  int add_png(std::string_view file);

  /// Sets a member of the document: "nodes", "meshes", "materials" and so on.
  void set(const std::string& name, GltfJson value) { document_[name] = std::move(value); }
  /// Sets the sampler of all textures: trilinear, with the wrap mode `wrap`.
  void set_sampler(int wrap);
  /// Sets one scene with one node for mesh 0, which has these primitives and extras.
  void set_scene(GltfJson node, GltfJson primitives, GltfJson extras = {});

  /// Returns the whole file, with the buffers, views, accessors and images that were added. Refused (too_large) if it
  /// would exceed the limit.
  Result<std::string> finish() const;

 private:
  template <class Value>
  int add_vertices(std::span<const Value> values, const char* type);
  int add_accessor(int view, int component_type, std::size_t count, const char* type);
  int add_view(const void* bytes, std::size_t size, int target);

  Status too_large() const;

  std::uint64_t max_bytes_;
  bool is_full_ = false;
  std::string binary_;
  GltfJson document_ = {{"asset", {{"version", "2.0"}, {"generator", "Pelage"}}}};
  GltfJson views_ = GltfJson::array(), accessors_ = GltfJson::array(), images_ = GltfJson::array();
};

GltfJson json_of(glm::dvec3 v);

/// Returns a node with a mesh, which is scaled, rotated by `turn` and moved to `centre`.
GltfJson node_of(const std::string& name, std::size_t mesh, glm::dvec3 centre, const glm::dmat3& turn = glm::dmat3(1),
                 double scale = 1);

inline constexpr int clamped = 33071, repeated = 10497;  // wrap modes; glTF uses GL's numbers

}  // namespace pelage
