// Fur drawn without a GL: shells rasterized into lists of crossings, and the coat marched between them.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>

#include "renderer/coat/slices.h"
#include "renderer/image/float_image.h"
#include "renderer/input/fur_scene.h"
#include "renderer/marched/fur_mesh.h"
#include "renderer/marched/slice_atlas.h"
#include "renderer/optics/eye_cache.h"
#include "renderer/visibility/changed_fur.h"

namespace pelage {

/// How closely fur is marched.
struct MarchQuality {
  int shells = 8;       // segments between skin and tips at silhouettes, [1, 64]; fewer for large meshes
  int halvings = 1;     // how often their number is halved where the skin faces the camera, [0, 3]
  float denser = 1.5f;  // power by which shells lie closer to the tips, [1, 3]
  int samples = 16;     // of the coat over the height of the fur, [1, 256]
};

/// Milliseconds of a frame's stages.
struct MarchTimes {
  double vertices = 0, bins = 0, tiles = 0;
};

/// Belongs to one thread; draws on up to `threads`, with the same bits for any number of them.
class Marcher {
 public:
  explicit Marcher(int threads);
  ~Marcher();

  bool has(std::uint64_t model) const { return meshes_.contains(model); }
  /// Both give the bytes that were taken over.
  std::size_t add(const FurModel& model, const FurFields& fields);
  std::size_t update(std::uint64_t model, const FurFields& fields);
  /// Bytes of all copies of a model (FurModel::original).
  std::size_t bytes_of(std::uint64_t original) const;
  void forget(std::uint64_t original);
  void forget_all();

  /// The finest level of the coat's slices (Slices) that a frame of a model that it has may read, or one before it.
  int finest_level(const FurFrame& frame) const;
  /// Whether it has the coat's slices from that level on.
  bool has(const Coat& coat, int finest) const;
  /// Takes the slices of a coat, in place of coarser ones; what a frame reads and it does not have is baked when it is
  /// drawn.
  void add(const Coat& coat, const Slices& slices);
  /// What a frame reads of its coat; none where it is there.
  std::optional<CoatNeed> missing_coat(const FurFrame& frame) const;
  /// Of the coats that it has.
  std::size_t coat_bytes() const;

  /// How many changes of the model's fur there were so far, and where on a picture it has changed since there were so
  /// many; none where none has.
  std::uint64_t changes(std::uint64_t model) const { return meshes_.at(model).changes(); }
  std::optional<ClipBox> changed_box(const FurFrame& frame, const glm::mat4& to_clip, std::uint64_t since) const;

  /// The longest fur rounded up to a power of two, sizes: how far a ray may go sideways in it. A change of it may
  /// change any pixel.
  float reach_of(std::uint64_t model) const;

  /// Pixels that are drawn for a frame.
  static glm::ivec2 size_of(const FurFrame& frame);

  /// Premultiplied linear light of the skin and its fur, of a model that it has.
  FloatImage draw(const FurFrame& frame, const MarchQuality& quality, MarchTimes* times = nullptr);
  /// The same of a part alone, by whole tiles of 16 pixels, into a picture of the frame's size; the rest stays. What
  /// AOVs keep goes into `aovs`, of as many pixels, where that is given.
  void draw_part(const FurFrame& frame, const MarchQuality& quality, const PixelBox& part, FloatImage& picture,
                 std::vector<AovPixel>* aovs = nullptr, MarchTimes* times = nullptr);
  /// The skin and the eyes alone, lit as if no fur stood on them; the skin under fur has the colour of the roots.
  FloatImage draw_bare(const FurFrame& frame, std::vector<AovPixel>& aovs);

  /// Fields of a model that it has as colours over a frame (field_overlay), or a map of a light in its place; none
  /// where no light of the frame has such a map.
  std::optional<FloatImage> draw_overlay(const FurFrame& frame) const;

 private:
  struct Coated;
  const Coated& coat_of(const Coat& coat, int finest);
  MarchScene scene_of(const FurFrame& frame, const Coated& coated, const ShellSet& shells, int samples);
  /// Places and sorts the scene's box, and calls draw(tile, scratch) for its tiles.
  template <class Draw>
  void draw_tiles(MarchScene& scene, MarchTimes* times, const Draw& draw) const;
  void add_optics(const FurFrame& frame, const FurMesh& mesh, const Coated& coated, MarchScene& scene);
  void add_pattern(const FurFrame& frame, MarchScene& scene);
  void add_tufts(const FurFrame& frame, MarchScene& scene);
  void add_paint(const FurFrame& frame, MarchScene& scene);
  void add_ground(const FurFrame& frame, MarchScene& scene);
  void add_ribbons(const FurFrame& frame, MarchScene& scene);
  void add_shell_shadows(const FurFrame& frame, MarchScene& scene);
  ShellShadow shell_shadow_of(const FurFrame& frame, const FurLight& light, float radius, std::vector<float>& maps);

  int threads_;
  std::map<std::uint64_t, FurMesh> meshes_;
  std::list<Coated> coats_;
  std::unique_ptr<EyeCache> eyes_;  // null before the first eye
  struct Kept;                      // what is made once for a look, a model or its curves
  std::unique_ptr<Kept> kept_;
};

}  // namespace pelage
