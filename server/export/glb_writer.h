// Binary glTF 2.0 files, put together accessor by accessor.
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
  /// Makes files of at most `max_bytes`, because sizes in a GLB have 32 bits. What would make the file larger is not
  /// stored.
  explicit GlbWriter(std::uint64_t max_bytes = std::numeric_limits<std::uint32_t>::max()) : max_bytes_(max_bytes) {}

  /// Accessors of floats; each gives its number. Those of positions need their bounds (glTF 2.0, 3.7.2.1).
  int add(std::span<const float> values);
  int add(std::span<const glm::vec2> values);
  int add(std::span<const glm::vec3> values);
  int add(std::span<const glm::vec4> values);
  int add_positions(std::span<const glm::vec3> values);
  /// An accessor of triangles, in 16 bits where `vertices` are few enough.
  int add_triangles(std::span<const glm::uvec3> triangles, std::size_t vertices);
  /// Adds an image and returns its number.
  int add_png(std::string_view file);

  /// A member of the file's object: "nodes", "meshes", "materials" and so on.
  void set(const std::string& name, GltfJson value) { document_[name] = std::move(value); }
  /// The sampler of all textures: trilinear, and at the borders `wrap`.
  void set_sampler(int wrap);
  /// One scene with one node, of mesh 0, which has these primitives.
  void set_scene(GltfJson node, GltfJson primitives, GltfJson extras = {});

  /// The whole file. Buffers, views, accessors, images and asset are what was added. Refused (too_large) where it would
  /// be larger than it may be.
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

/// A node with a mesh, which stands at a centre, turned (a rotation) and scaled about it.
GltfJson node_of(const std::string& name, std::size_t mesh, glm::dvec3 centre, const glm::dmat3& turn = glm::dmat3(1),
                 double scale = 1);

inline constexpr int clamped = 33071, repeated = 10497;  // GL's numbers, which glTF takes

}  // namespace pelage
