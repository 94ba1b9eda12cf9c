// From fields to a map, and from a picture to fields.
#pragma once

#include <array>
#include <vector>

#include "protocol/commands/map.h"
#include "protocol/commands/tools.h"
#include "server/fields/field_set.h"
#include "server/import/map_picture.h"
#include "server/maps/encoding.h"
#include "server/surface/mesh.h"

namespace pelage {

/// A map before it is a file: values as `layout` says, colours with straight alpha.
struct DrawnMap {
  MapImage image;
  MapLayout layout;
  MapAnswer answer;  // all but the revision
};

/// Draws the asked map of a mesh with texture coordinates; not `vertices`. Beside the picture it takes 4 bytes a pixel
/// and channel.
DrawnMap draw_map(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

/// A field's value at each vertex, in their order: numbers over the scale, colours linear with straight alpha, or the
/// vectors along the surface, in model coordinates, of a direction.
struct VertexList {
  std::size_t channels = 1;   // 1, 3 of a direction, 4 of a colour
  std::vector<float> values;  // channels * vertices
  MapAnswer answer;           // all but the revision
};

VertexList list_vertices(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

/// What a picture says about the fields of each vertex.
struct MapTargets {
  std::vector<Field> fields;                                // by rising number: which ones the encoding holds
  std::array<std::vector<glm::dvec4>, field_count> values;  // of those fields, for each vertex; beyond ranges too
  std::vector<bool> keeps_direction;  // of `vector`, where it has no length and so no direction; else empty
  std::vector<bool> says_nothing;     // of vertices that do not lie in the tile; empty where all are read
};

/// Reads the picture at every vertex, mixed from four pixels; on seams the mean of what its islands say. The mesh has
/// texture coordinates, or with `vertices` the picture has as many pixels as the mesh vertices. `scale` is in the
/// field's unit, lengths in sizes. Of a UDIM `tile` the picture shows its square alone.
MapTargets read_map(const Mesh& mesh, const MapPicture& picture, Field field, MapEncoding encoding, double scale,
                    int tile = 0);

/// How bright the picture is, [0, 1], at a place in [0, 1], v up: Rec. 709's weights of the file's own numbers.
double luminance_at(const MapPicture& picture, glm::dvec2 place);

/// One channel of the picture at every vertex, the file's own numbers held in [0, 1].
std::vector<double> read_channel(const Mesh& mesh, const MapPicture& picture, PictureChannel channel);

}  // namespace pelage
