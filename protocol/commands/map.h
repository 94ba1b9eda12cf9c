// Maps: fields as pictures through the model's own texture coordinates. Also the answer to an uploaded picture.
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

/// What the pixels of a map hold; server/maps/encoding.h has the numbers. value: a grey number or, for a colour field,
/// red, green, blue and coverage. uv_tangent: the components of a direction along +u and +v in red and green, where .5
/// is 0. fast_fur (Warren): the same, with the field width in blue and density in alpha. vector (as in MODO): direction
/// and length as one vector with components along +u, +v and the normal; floats only. vertices: not a picture but a
/// list with a value for each vertex of the mesh, in its order; a direction is a vector along the surface in model
/// coordinates, as long as the inclination; floats only. automatic: uv_tangent for direction, else value.
enum class MapEncoding { automatic, value, uv_tangent, fast_fur, vector, vertices };

/// `npy` is a NumPy array of floats: [size, size] or [size, size, channels]; with `vertices` [vertices] or [vertices,
/// channels].
enum class MapFormat { png, png16, exr, exr_half, npy };

/// Sets fields to what a picture holds for them. Needs a model with texture coordinates, unless the picture is a list
/// with a value for each vertex.
struct ApplyMap {
  static constexpr const char* op = "map";
  static constexpr Inputs inputs = Inputs::none;
  static constexpr Work work = Work::vertices;
  std::string picture;          // 32 hex digits, the name that its upload answered with; required
  Field field = Field::length;  // direction with uv_tangent, fast_fur and vector
  MapEncoding encoding = MapEncoding::automatic;
  double scale = 1;               // value of 1 in the picture, in the field's unit (lengths: in `units`), [1e-27, 1e27]
  Units units = Units::relative;  // for the field length and the encoding vector
  double strength = 1;            // blend factor from the present value to the picture's, [0, 1]
  std::string edit_layer = {};    // edit layer that stores the change; "" for the groom
  std::vector<std::string> coats = {};  // coats to change; empty for all that are not muted
  int tile = 0;                         // UDIM tile, [1001, 9999]: only vertices that lie in it change; 0: all do
};

/// Which field is drawn as a map, and how.
struct MapRequest {
  Field field = Field::length;
  std::string coat = {};  // name of the coat whose field is drawn; "" for the first
  MapFormat format = MapFormat::png16;
  MapEncoding encoding = MapEncoding::automatic;
  int size = 1024;                   // width and height in pixels, [1, 8192]
  int dilate = 8;                    // pixels by which UV islands grow, [0, 64]
  std::optional<double> scale = {};  // as in ApplyMap; absent: the field's largest value for PNG, else 1
  Units units = Units::relative;
  int tile = 0;  // UDIM tile, [1001, 9999]: 1001 + u + 10 v; 0: all tiles, over one another
};

/// The parameters of an uploaded map.
struct MapUpload {
  Field field = Field::length;
  std::string coat = {};  // name of the coat to change; "" for all
  MapEncoding encoding = MapEncoding::automatic;
  std::optional<double> scale = {};  // as in ApplyMap; absent: the scale stored in the picture, else 1
  Units units = Units::relative;
  double strength = 1;
  int tile = 0;  // as in ApplyMap
};

/// How to read a map that was drawn.
struct MapAnswer {
  Revision revision = 0;
  Field field = Field::length;
  MapEncoding encoding = MapEncoding::value;
  double scale = 1;  // value of 1 in the picture, in the field's unit
  Units units = Units::relative;
  double covered = 0;           // share of the pixels that lie in triangles
  std::size_t outside = 0;      // triangles with a part outside [0, 1], drawn where a repeating picture shows them
  std::vector<int> tiles = {};  // UDIM tiles that the model has texture coordinates in, ascending
  bool operator==(const MapAnswer&) const = default;
};

/// A picture that the server stores, so that commands can name it.
struct PictureAnswer {
  std::string picture;               // 32 hex digits
  int width = 0, height = 0;         // pixels
  int bits = 8;                      // per channel: 8, 16, or 32 for any float
  std::optional<double> scale = {};  // scale stored in the picture: sizes, or the field's unit; absent if none
  bool operator==(const PictureAnswer&) const = default;
};

/// Smallest and largest number of a UDIM tile.
inline constexpr int first_udim = 1001, last_udim = 9999;

/// Returns the encoding that `automatic` stands for, and any other encoding as it is.
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
