// Exports the skin under baked fur, with helpers for other parts of a file.
#pragma once

#include "renderer/coat/slices.h"
#include "server/export/glb_writer.h"
#include "server/export/vertex_colours.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the share of the light that reaches a height s in [0, 1] of the fur.
float light_at(const Slices& slices, double height);

/// Adds the whole mesh in the colour of the roots, darkened by the fur above. Returns the primitive, with the material
/// of that number.
GltfJson add_skin(GlbWriter& file, const SceneView& scene, const VertexColours& colours, const Slices& slices,
                  int material);

inline constexpr double dull = 0.9, wet = 0.12;  // roughness of skin and eyes

/// Returns a node for a mesh whose positions are relative to the model's centre.
GltfJson node_of(const std::string& name, std::size_t mesh, const FileTransform& transform);
/// Returns a non-metallic material without a colour of its own, for meshes with vertex colours.
GltfJson material_of(const std::string& name, double roughness);

}  // namespace pelage
