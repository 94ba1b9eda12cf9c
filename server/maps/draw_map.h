// Draws maps of fields, and reads fields from pictures.
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

/// A map before it is encoded; `layout` describes its values. Colours have straight alpha for PNG, and are
/// premultiplied for formats of floats.
struct DrawnMap {
  MapImage image;
  MapLayout layout;
  MapAnswer answer;  // without the revision
};

/// Draws the requested map of a mesh, which must have texture coordinates; the encoding must not be `vertices`. Takes 4
/// bytes a pixel and channel in addition to the encoded file.
DrawnMap draw_map(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

/// A field's values at all vertices, in their order: numbers divided by the scale, linear colours with straight alpha,
/// or directions as vectors along the surface in model coordinates.
struct VertexList {
  std::size_t channels = 1;   // 1; 3 for a direction, 4 for a colour
  std::vector<float> values;  // channels * vertices
  MapAnswer answer;           // without the revision
};

VertexList list_vertices(const Mesh& mesh, const FieldSet& fields, const MapRequest& request);

/// The values of fields that a picture gives for each vertex.
struct MapTargets {
  std::vector<Field> fields;                                // fields of the encoding, by rising number
  std::array<std::vector<glm::dvec4>, field_count> values;  // of those fields, for each vertex; may be out of range
  std::vector<bool> no_direction;  // for `vector`: true if its length is 0, so that it has no direction; else empty
  std::vector<bool> outside_tile;  // true for vertices outside the tile; empty if all are read
};

/// Samples the picture bilinearly at every vertex; on seams it takes the mean over the islands. The mesh must have
/// texture coordinates or, for `vertices`, the picture must have as many pixels as the mesh has vertices. `scale` is in
/// the field's unit, lengths in sizes. If `tile` is not 0, the picture covers only the square of this UDIM tile.
MapTargets read_map(const Mesh& mesh, const MapPicture& picture, Field field, MapEncoding encoding, double scale,
                    int tile = 0);

/// Returns the luminance of the picture, [0, 1], at a position in [0, 1], v up: Rec. 709's weights of the file's own
/// numbers.
double luminance_at(const MapPicture& picture, glm::dvec2 uv);

/// Returns one channel of the picture at every vertex: the file's own numbers, clamped to [0, 1].
std::vector<double> read_channel(const Mesh& mesh, const MapPicture& picture, PictureChannel channel);

}  // namespace pelage
