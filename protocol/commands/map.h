// Maps: fields as pictures through the model's own texture coordinates; also the answer to an uploaded picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/answers.h"
#include "protocol/commands/field.h"
#include "protocol/commands/inputs.h"
#include "protocol/commands/stroke.h"

namespace pelage {

/// What a map's pixels hold; server/maps/encoding.h has the numbers. `value`: a number in grey, or of a colour field
/// its red, green, blue and cover. `uv_tangent`: red and green are a direction's parts along +u and +v, .5 is 0.
/// `fast_fur` (Warren): the same, with the field width in blue and density in alpha. `vector` (as MODO has it):
/// direction and length as one vector with parts along +u, +v and the normal; floats only. `vertices`: no picture but a
/// list with a value for each vertex of the mesh, in its order; a direction is a vector along the surface in model
/// coordinates, floats only, as long as the tip is inclined. `automatic`: uv_tangent of direction, else value.
enum class MapEncoding { automatic, value, uv_tangent, fast_fur, vector, vertices };

/// `npy` is a NumPy array of floats: [size, size] or [size, size, channels], of `vertices` [vertices] or
/// [vertices, channels].
enum class MapFormat { png, png16, exr, exr_half, npy };

/// Puts the fields in place of what a picture holds for them. Needs a model with texture coordinates, unless it has a
/// value for each vertex.
struct ApplyMap {
  static constexpr const char* op = "map";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  std::string picture;          // 32 hex digits, the name that its upload answered with; required
  Field field = Field::length;  // direction with uv_tangent, fast_fur and vector
  MapEncoding encoding = MapEncoding::automatic;
  double scale = 1;               // what 1 in the picture is in the field's unit, [1e-27, 1e27]; a length of `units`
  Units units = Units::relative;  // of length and vector
  double strength = 1;            // how far fields go to the picture's, [0, 1]
  std::string edit_layer = {};    // edit layer that keeps the change; "" for the groom
  std::vector<std::string> coats = {};  // that it changes; none for all that are not muted
  int tile = 0;                         // UDIM tile, [1001, 9999]: only vertices that lie in it change; 0: all do
};

/// Which map is asked for.
struct MapRequest {
  Field field = Field::length;
  std::string coat = {};  // whose field; "" for the first one's
  MapFormat format = MapFormat::png16;
  MapEncoding encoding = MapEncoding::automatic;
  int size = 1024;                   // pixels of a side, [1, 8192]
  int dilate = 8;                    // pixels by which islands grow, [0, 64]
  std::optional<double> scale = {};  // as in ApplyMap; absent: the field's largest value for PNG, else 1
  Units units = Units::relative;
  int tile = 0;  // UDIM tile, [1001, 9999]: 1001 + u + 10 v; 0: all, over one another
};

/// What comes with the bytes of an uploaded map.
struct MapUpload {
  Field field = Field::length;
  std::string coat = {};  // whose field; "" for that of all coats
  MapEncoding encoding = MapEncoding::automatic;
  std::optional<double> scale = {};  // absent: what the picture says about itself, else 1
  Units units = Units::relative;
  double strength = 1;
  int tile = 0;  // as in ApplyMap
};

/// What a map that was made is like.
struct MapAnswer {
  Revision revision = 0;
  Field field = Field::length;
  MapEncoding encoding = MapEncoding::value;
  double scale = 1;  // that 1 in the picture stands for
  Units units = Units::relative;
  double covered = 0;           // share of the pixels that lie in triangles
  std::size_t outside = 0;      // triangles with a part outside [0, 1], drawn where a picture that repeats shows them
  std::vector<int> tiles = {};  // UDIM tiles that the model has texture coordinates in, rising
  bool operator==(const MapAnswer&) const = default;
};

/// A picture that the server keeps for commands to name.
struct PictureAnswer {
  std::string picture;               // 32 hex digits
  int width = 0, height = 0;         // pixels
  int bits = 8;                      // of a channel: 8, 16, or 32 for any float
  std::optional<double> scale = {};  // sizes, or the field's unit, where the picture says it of itself
  bool operator==(const PictureAnswer&) const = default;
};

/// Numbers of UDIM tiles.
inline constexpr int first_udim = 1001, last_udim = 9999;

/// What `automatic` stands for.
constexpr MapEncoding encoding_of(Field field, MapEncoding encoding) {
  if (encoding != MapEncoding::automatic) return encoding;
  return field == Field::direction ? MapEncoding::uv_tangent : MapEncoding::value;
}

/// Returns whether a map in this encoding can hold the field.
constexpr bool fits(Field field, MapEncoding encoding) {
  if (encoding == MapEncoding::vertices) return true;
  return (field == Field::direction) != (encoding_of(field, encoding) == MapEncoding::value);
}

}  // namespace pelage
