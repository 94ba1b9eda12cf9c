// The skin under baked fur.
#pragma once

#include <string>

#include "renderer/coat/slices.h"
#include "server/export/glb_writer.h"
#include "server/export/vertex_colours.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the share of the light that reaches a height s in [0, 1] of the fur.
float light_at(const Slices& slices, double height);

/// Adds the whole mesh in the colour of the roots, darkened as the fur above shades it. Returns the primitive as JSON,
/// with the material of that number.
std::string add_skin(GlbWriter& file, const SceneView& scene, const VertexColours& colours, const Slices& slices,
                     int material);

inline constexpr const char* dull_material = R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.9})";
inline constexpr const char* wet_material = R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.12})";

}  // namespace pelage
