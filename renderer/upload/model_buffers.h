// Uploads a model to GPU buffers: its vertices, split where corners differ, and its fields.
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

/// Locations of vertex attributes; shaders use the same numbers.
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

/// Bytes uploaded, for tests and metrics.
struct UploadCount {
  std::size_t bytes = 0;
};

struct SplitModel;

class ModelBuffers {
 public:
  /// Uploads the whole model and its fields.
  ModelBuffers(const Gl& gl, const FurModel& model, const FurFields& fields, UploadCount& count);

  /// Uploads only the vertices in `fields.dirty`; all vertices if the coat, the regions of bare skin or the set of
  /// painted fields changed. Lengths are uploaded as bare skin leaves them, so that shaders need not know about it.
  void update(const Gl& gl, const FurFields& fields, UploadCount& count);

  GLuint vertex_array() const { return vertex_array_.id(); }
  GLuint base_images() const { return images_.id(); }
  /// Returns the bytes of arrays and GL storage.
  std::size_t bytes(const Gl& gl) const;
  std::uint64_t original() const { return original_; }  // FurModel::original, or its id
  bool has_colours() const { return has_colours_; }
  /// The kinds of paint besides lengths and directions: numbers that change the fur, and colours.
  struct Painted {
    bool fur = false, colours = false;
    bool operator==(const Painted&) const = default;
  };
  const Painted& painted() const { return painted_; }
  /// Returns the #define lines for shaders: PAINT for numbers, PAINT_COLOUR for colours.
  std::string paint_defines() const;
  /// Returns a number that increases with each change of the fields.
  std::uint64_t version() const { return version_; }
  float longest_fur() const;  // length of the longest fur, as bare skin leaves it, sizes

  std::span<const glm::vec3> positions() const { return positions_; }  // of render vertices
  std::span<const glm::vec3> normals() const { return normals_; }
  std::span<const glm::uvec3> triangles() const { return triangles_; }
  /// Returns the rest-pose positions of render vertices, which patterns and tufts use.
  std::span<const glm::vec3> rest_pose_positions() const {
    return rest_positions_.empty() ? positions_ : rest_positions_;
  }
  VolumeSurface surface() const { return {positions_, normals_, triangles_, rest_positions_, rest_normals_}; }
  /// Uploads the variation of the fur at each render vertex (renderer/pattern); only programs with a pattern read it.
  void send_variation(const Gl& gl, std::span<const glm::vec4> values);

  /// A range of the element buffer, in indices.
  struct DrawList {
    GLsizei first = 0, count = 0;
  };
  struct DrawLists {
    DrawList all;      // every triangle
    DrawList visible;  // triangles whose fur is drawn
    // For each shell, in blending order: back-facing triangles from the outside in, then front-facing ones from the
    // inside out.
    std::vector<std::pair<int, DrawList>> back_facing, facing;
  };
  /// Uploads the triangles to draw for a view, and the shell LOD of each vertex.
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
  std::vector<std::uint32_t> first_;   // for each vertex of the model, its first render vertex; one more at the end
  std::vector<glm::uvec3> triangles_;  // indices of render vertices
  std::vector<glm::vec3> centroids_, face_normals_;
  std::vector<glm::vec3> positions_, normals_;            // of render vertices
  std::vector<glm::vec3> rest_positions_, rest_normals_;  // empty if the model is in its rest pose
  std::vector<float> lengths_;                            // of render vertices
  std::vector<FurSkinRegion> skin_;                       // bare regions
  std::vector<float> curvatures_;                         // curvature of the skin at render vertices, 1 / sizes
  std::vector<float> lods_;                               // shell LOD at render vertices for the last view
};

}  // namespace pelage
