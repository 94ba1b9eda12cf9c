// How a scene begins: with a built-in model or with the bytes of a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pelage {

enum class Builtin { torus, knot, sphere, plane, cloth, creature };
enum class ModelFormat {
  obj,
  ply,
  stl,
  off,
  gltf,
  glb,
  tds,
  zip
};                                                                      // tds is "3ds" on the wire; zip: one of the
                                                                        // others with the files that it names
enum class Axis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };  // "x", "-x", ...

/// The first groom: fur that flows from under the chin to the ends of limbs, ears and tail, on sheets from front to
/// back. even: one length everywhere. animal: shorter on face and paws, longer on chest and tail, estimated from where
/// they lie in the model's box when it looks along +Z.
enum class GroomForm { even, animal };

struct FirstGroom {
  double length = 0.03;       // sizes, [0, 10]
  double inclination = 0.45;  // [0, 1]
  GroomForm form = GroomForm::even;
};

/// How the sample tile is laid on the surface: lapped patches with soft overlaps, the same with hard borders (each
/// place drawn once), or the model's own texture coordinates. Roots never move, so it is chosen with the model.
enum class FurPatches { overlapping, hard, own_uvs };

struct BuiltinModel {
  Builtin shape = Builtin::creature;
  int triangles = 5000;  // wished for; [2, 1000000]
};

struct NewScene {
  std::string name = "scene";  // 1 to 200 bytes
  BuiltinModel model;
  FirstGroom fur;
  FurPatches fur_patches = FurPatches::overlapping;
  bool ground = false;  // whether the ground below the model is visible at first
};

/// An edge whose triangles' normals differ by more degrees is seen as an edge.
inline constexpr double default_crease_degrees = 60;

/// Parameters of PUT model: how to read the bytes that come with it. `up` and `front` say which of the file's axes
/// point up and forward; they differ in more than sign. Where they are not given they follow from the format (Z up and
/// -Y forward in STL, else Y and Z), and forward from a skeleton whose joints say what is left and right.
struct ImportOptions {
  ModelFormat format = ModelFormat::obj;
  std::optional<Axis> up, front;
  std::string pose;                                // "NAME@SECONDS" of an animation of the file; "" as it stands
  double crease_degrees = default_crease_degrees;  // [0, 180]; 180: no edge is
  std::vector<int> flip;                           // numbers of parts that turn inside out, from 1
  std::vector<int> two_sided;                      // and of those that get a back, to grow fur on both sides
  FirstGroom fur{.form = GroomForm::animal};
  FurPatches fur_patches = FurPatches::overlapping;
  bool ground = false;  // as NewScene::ground
};

/// How a model is aligned with another one: its box is scaled to the other's, axis by axis, or both stay in the same
/// model coordinates.
enum class Alignment { box, none };

/// How fine a mesh for clients is to be.
struct MeshRequest {
  int triangles = 20'000;  // at most, where the model can be made simpler; [100, 200000]
  bool fur = false;        // whether each vertex says where its strand stands, too
};

/// Splits the triangles of the field mesh in four at the middles of their edges; the shape stays. `masked` splits only
/// triangles with a corner whose mask is above .5, and their neighbours so that no crack opens.
struct Subdivide {
  int levels = 1;  // [1, 8]
  bool masked = false;
};

/// Which way the model stands: the axes that point up and forward now point along +Y and +Z from then on. They differ
/// in more than sign.
struct TurnModel {
  Axis up = Axis::plus_y, front = Axis::plus_z;
};

/// Another name for a scene.
struct SceneName {
  std::string name;  // 1 to 200 bytes
};

}  // namespace pelage
