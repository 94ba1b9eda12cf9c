// Requests about scenes and their models: new scenes, import, meshes for clients, subdivision and turning.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pelage {

enum class Builtin { torus, knot, sphere, plane, cloth, creature };
enum class ModelFormat { obj, ply, stl, off, gltf, glb, tds, zip };     // tds: "3ds"; zip: any other with its files
enum class Axis { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };  // "x", "-x", ...

/// The first groom: fur that flows from under the chin to the ends of limbs, ears and tail; on sheets from front to
/// back. even: one length everywhere. animal: shorter on face and paws, longer on chest and tail, estimated from where
/// they lie in the box of a model that faces +Z.
enum class GroomForm { even, animal };

struct FirstGroom {
  double length = 0.03;       // sizes, [0, 10]
  double inclination = 0.45;  // [0, 1]
  GroomForm form = GroomForm::even;
};

/// How the sample tile is laid on the surface. overlapping: patches with soft overlaps. hard: patches with hard
/// borders, so that nothing is drawn twice. own_uvs: the model's own texture coordinates. Roots never move, so this is
/// chosen with the model.
enum class FurPatches { overlapping, hard, own_uvs };

struct BuiltinModel {
  Builtin shape = Builtin::creature;
  int triangles = 5000;  // approximate number, [2, 1000000]
};

struct NewScene {
  std::string name = "scene";  // 1 to 200 bytes
  BuiltinModel model;
  FirstGroom fur;
  FurPatches fur_patches = FurPatches::overlapping;
  bool ground = false;  // whether the ground below the model is visible at first
};

/// Edges whose triangles' normals differ by more than this many degrees are sharp.
inline constexpr double default_crease_degrees = 60;

/// Parameters of PUT model: how to read the bytes that come with it. `up` and `front` are the file's axes that point up
/// and forward; they do not lie on one line. Absent ones follow from the format (Z up and -Y forward in STL and 3DS,
/// else Y and Z), and the front also from a skeleton whose joints are named left and right.
struct ImportOptions {
  ModelFormat format = ModelFormat::obj;
  std::optional<Axis> up, front;
  std::string pose;                                // "NAME@SECONDS" of an animation; "" for the pose of the file
  double crease_degrees = default_crease_degrees;  // [0, 180]; at 180 no edge is sharp
  std::vector<int> flip;                           // numbers, from 1, of parts that are turned inside out
  std::vector<int> two_sided;                      // numbers of parts that get a back, to grow fur on both sides
  FirstGroom fur{.form = GroomForm::animal};
  FurPatches fur_patches = FurPatches::overlapping;
  bool ground = false;  // as NewScene::ground
};

/// How a model is aligned with another one. box: its box is scaled to the other's, axis by axis. none: both stay in the
/// same model coordinates.
enum class Alignment { box, none };

/// The resolution and contents of a mesh for clients.
struct MeshRequest {
  int triangles = 20'000;  // largest number, if the model can be simplified as far; [100, 200000]
  bool fur = false;        // true: each vertex also has the positions along its strand
};

/// Splits each triangle of the field mesh into four at the middles of its edges; the shape stays. `masked` splits only
/// triangles with a corner whose mask is above .5, and their neighbours so that no crack opens.
struct Subdivide {
  int levels = 1;  // [1, 8]
  bool masked = false;
};

/// Turns the model: the axes that are up and front as it stands now will point along +Y and +Z. They do not lie on one
/// line.
struct TurnModel {
  Axis up = Axis::plus_y, front = Axis::plus_z;
};

/// A new name for a scene.
struct SceneName {
  std::string name;  // 1 to 200 bytes
};

}  // namespace pelage
