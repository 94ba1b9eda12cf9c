// The one door from CPU arrays to GPU buffers: a model's vertices, split where corners differ, and its fields.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/gl/handles.h"
#include "renderer/input/fur_scene.h"
#include "renderer/pattern/surface_volume.h"
#include "renderer/upload/shell_lod.h"

namespace pelage {

/// Attribute places, listed once; shaders name the same numbers.
enum class Attribute : GLuint {
  position,
  normal,
  tangent,
  tile_uv,
  tile_axis,
  image_uv,
  colour,
  groom,
  weight,
  shell_lod,
  variation,
  amounts,
  forms,
  root_paint,
  tip_paint,
  shading_normal
};

/// What was sent, for tests and metrics.
struct UploadCount {
  std::size_t bytes = 0;
};

struct SplitModel;

class ModelBuffers {
 public:
  /// Sends the whole model and its fields.
  ModelBuffers(const Gl& gl, const FurModel& model, const FurFields& fields, UploadCount& count);

  /// Sends the vertices in `fields.dirty` only, or all of another coat, or when other skin is bare or other fields
  /// are painted. Lengths are
  /// sent as bare skin leaves them, so that no shader has to know.
  void update(const Gl& gl, const FurFields& fields, UploadCount& count);

  GLuint vertex_array() const { return vertex_array_.id(); }
  GLuint base_images() const { return images_.id(); }
  /// What it takes in memory: arrays and the storage of its GL objects.
  std::size_t bytes(const Gl& gl) const;
  std::uint64_t original() const { return original_; }  // FurModel::original, or its id
  bool has_colours() const { return has_colours_; }
  /// What is painted beside lengths and directions: numbers that change the fur, and colours.
  struct Painted {
    bool fur = false, colours = false;
    bool operator==(const Painted&) const = default;
  };
  const Painted& painted() const { return painted_; }
  /// The #define lines of it: PAINT for numbers, PAINT_COLOUR for colours.
  std::string paint_defines() const;
  /// Counts the changes of the fields.
  std::uint64_t version() const { return version_; }
  float longest_fur() const;  // sizes, beside bare skin

  std::span<const glm::vec3> positions() const { return positions_; }  // of render vertices
  std::span<const glm::vec3> normals() const { return normals_; }
  std::span<const glm::uvec3> triangles() const { return triangles_; }
  /// Of render vertices, where patterns and tufts see them.
  std::span<const glm::vec3> rest_places() const { return rest_positions_.empty() ? positions_ : rest_positions_; }
  VolumeSurface surface() const { return {positions_, normals_, triangles_, rest_positions_, rest_normals_}; }
  /// Slow changes of the fur at each render vertex (renderer/pattern); read by programs with a pattern only.
  void send_variation(const Gl& gl, std::span<const glm::vec4> values);

  /// A stretch of the element buffer, in indices.
  struct DrawList {
    GLsizei first = 0, count = 0;
  };
  struct DrawLists {
    DrawList all;    // every triangle
    DrawList shown;  // those whose fur is drawn
    // Of each shell, in the order of blending: outside in, then inside out.
    std::vector<std::pair<int, DrawList>> back_facing, facing;
  };
  /// Sends the triangles to draw for a view, and the level of each vertex.
  DrawLists lists_for(const Gl& gl, const ShellView& view);

 private:
  void keep(const FurModel& model, SplitModel split);
  void send_fur(const Gl& gl, const FurFields& fields, const DirtyRange& range, UploadCount& count);
  void make_vertex_array(const Gl& gl);
  void send_images(const Gl& gl, const FurModel& model, UploadCount& count);

  VertexArray vertex_array_;
  Buffer fixed_, fur_, lod_, variation_, elements_;
  Texture images_;
  std::uint64_t original_ = 0;
  bool has_colours_ = false;
  Painted painted_;
  CoatId coat_ = 0;
  std::uint64_t version_ = 0;
  std::vector<std::uint32_t> welded_;  // the model's vertex of each render vertex, rising
  std::vector<std::uint32_t> first_;   // of each model's vertex, its first render vertex; one more at the end
  std::vector<glm::uvec3> triangles_;  // in render vertices
  std::vector<glm::vec3> centroids_, face_normals_;
  std::vector<glm::vec3> positions_, normals_;            // of render vertices
  std::vector<glm::vec3> rest_positions_, rest_normals_;  // empty where the model stands in its rest pose
  std::vector<float> lengths_;                            // of render vertices
  std::vector<FurSkinRegion> skin_;                       // bare regions
  std::vector<float> curvatures_;                         // of the skin at render vertices, 1 / sizes
  std::vector<float> lods_;                               // of the last view
};

}  // namespace pelage
