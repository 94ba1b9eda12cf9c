// What one frame of marched fur is drawn from: plain arrays that threads read.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "renderer/curves/guard_hairs.h"
#include "renderer/input/picture.h"
#include "renderer/marched/ground_contact.h"
#include "renderer/marched/ribbons.h"
#include "renderer/marched/slice_atlas.h"
#include "renderer/optics/eye_cache.h"
#include "renderer/optics/frame_optics.h"

namespace pelage {

/// Where each number of a vertex of a shell lies. All but the place on the picture and in space are over the distance
/// along the view, so that they run evenly over the picture. Negative: not there.
struct Varyings {
  static constexpr int x = 0, y = 1;  // pixels from the left and the top
  static constexpr int place = 2;     // three, not over the distance
  static constexpr int first = 5;     // from here on they are interpolated
  static constexpr int inverse = 5;   // 1 / distance along the view
  static constexpr int tile = 6;      // two, in tiles
  static constexpr int normal = 8, tangent = 11;
  static constexpr int length = 14;  // of the fur, sizes
  static constexpr int share = 15;   // of the optical depth that this piece draws
  static constexpr int min_stride = 16;
  int root = -1, varied = -1;  // three and two: where the strand leaves the skin; factor on lightness, turn of hue
  int open = -1;               // four: place on the hull, how high that is
  int image = -1;              // six: u, v, image, colour
  int paint = -1;              // six: density, width, wetness, bare, curl, clump
  int painted = -1;            // eight: colours at root and tip, times their cover, cover
  int stride = min_stride;     // numbers of a vertex
  int count() const { return stride - first; }  // that are interpolated
};

/// The boundaries of shells from the skin to the tips, heights rising from 0 to 1.
struct ShellSet {
  std::vector<float> heights;
  std::vector<float> facing;  // cosine between view and normal below which a shell is drawn; 2 for everywhere
  int count() const { return static_cast<int>(heights.size()); }
};

/// Numbers of a piece (a triangle of the model), the same over all of it.
struct PieceAxes {
  glm::vec3 tile_u{0};    // unit
  float tile_area = 0;    // of its piece of the tile, sizes^2
  float image_scale = 0;  // sides of an image over a size
};

/// What is read of the model: render vertices (renderer/upload/split_corners.h).
struct MarchMesh {
  std::span<const glm::vec3> positions, normals, tangents;
  std::span<const glm::vec3> shading_normals;  // split at creases; fur grows along `normals`
  std::span<const glm::vec2> tiles;            // place on the sample tile, sizes
  std::span<const float> weights;              // of the patch
  std::span<const glm::vec3> image_uvs, colours;
  std::span<const glm::vec3> groom;               // direction, length
  std::span<const glm::vec4> variation;           // empty without a pattern
  std::span<const std::array<float, 6>> paint;    // empty where none
  std::span<const std::array<float, 8>> painted;  // empty where none
  std::span<const float> mask;                    // empty where all is free
  std::span<const std::uint32_t> welded;          // the model's own vertex of each
  std::span<const glm::uvec3> triangles;
  std::span<const std::uint32_t> patches;  // of triangles
  std::span<const PieceAxes> axes;         // of triangles
};

/// How high fur stops the light that comes to other parts of the body, over its height: its hull (lean.glsl).
inline constexpr float hull_height = 0.6f;

/// A triangle of one shell as a tile takes it.
struct ShellTriangle {
  std::uint32_t piece = 0;
  std::uint16_t shell = 0;
  bool facing = true;     // seen from outside
  std::uint32_t cut = 0;  // its first row where it is cut at the near plane, else 0
};

/// The level that catches the model's shadow. Nothing stands under it.
struct GroundOptics {
  static constexpr float extent = 4;  // to each side of the middle, sizes
  float height = 0;
  float contact = 0;                      // strength, [0, 1]
  float shadow = 0;                       // strength of what lights with maps cast, [0, 1]
  const GroundContact* hidden = nullptr;  // null: there is none to be seen
};

/// Makes room without writing to it: of the rows of a large mesh a part of a picture places few, and memory that nobody
/// writes to costs nothing.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitialisedAllocator<U>;
  };
  template <class U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
};

struct MarchScene {
  FrameOptics optics;
  MarchMesh mesh;
  const SliceAtlas* atlas = nullptr;
  ShellSet shells;
  Varyings varyings;
  int width = 0, height = 0;  // pixels of the picture
  PixelBox box;               // of them that are drawn, by whole tiles
  int samples = 16;           // of the coat over the height of the fur
  bool bends = false;         // whether strands gather or curl beside what the coat has
  bool bare = false;          // without fur: the skin that traced strands grow from, lit as if nothing stood on it
  float reach = 0;            // how far a ray moves over the tile between two shells at most, tiles
  glm::vec3 viewpoint{0}, forward{0, 0, -1};
  glm::vec3 ray_x{0}, ray_y{0}, ray_0{0};  // way of a pixel's ray by its x and y, 1 along the view

  std::vector<EyeCamera> eyes;  // of optics.eyes
  GroundOptics ground;
  Ribbons ribbons;  // of guided curves and guard hairs
  std::vector<HairRoot> hairs;

  std::vector<std::uint32_t> pieces;  // triangles of the mesh whose fur may touch the box, in their order

  /// Rows of all shells' vertices, one shell after the other, and of those that cutting at the near plane makes; what
  /// no piece has is not placed. Those nearer than near_distance have 0 for `inverse`, and their other numbers as they
  /// are.
  std::vector<float, UninitialisedAllocator<float>> vertices;

  std::size_t row_of(int shell, std::size_t vertex) const {
    return static_cast<std::size_t>(shell) * mesh.positions.size() + vertex;
  }
  std::size_t row_of(const ShellTriangle& triangle, int corner) const {
    if (triangle.cut != 0) return triangle.cut + static_cast<std::size_t>(corner);
    return row_of(triangle.shell, mesh.triangles[triangle.piece][corner]);
  }
  float* row(std::size_t number) { return &vertices[number * static_cast<std::size_t>(varyings.stride)]; }
  const float* row(std::size_t number) const { return &vertices[number * static_cast<std::size_t>(varyings.stride)]; }
};

/// What AOVs keep of a pixel beside its light (protocol Aov), multiplied by the share of what shows it.
struct AovRows {
  static constexpr int position = 0, normal = 3, tangent = 6, albedo = 9, direct = 12;  // three each
  static constexpr int kept = 15, whole = 16;  // luminance of direct light, and what it would be without shadows
  static constexpr int count_of_segments = 17;
  static constexpr int inverse = 18;  // 1 / distance along the view of what brings the opacity to a half, 0 for none
  static constexpr int cover = 19;    // share that skin, eyes and what grows there cover
  static constexpr int count = 20;
};
using AovPixel = std::array<float, AovRows::count>;

/// Pixels of a tile, which threads draw one by one.
struct Tile {
  static constexpr int side = 16;
  int left = 0, top = 0;
  std::size_t number = 0;                    // from the first tile of the scene's box, row by row
  std::span<const ShellTriangle> triangles;  // roughly from near to far
};

}  // namespace pelage
