// A volume about a surface as a texture.
#pragma once

#include "renderer/gl/handles.h"
#include "renderer/pattern/surface_volume.h"

namespace pelage {

/// RGBA8, read linearly and clamped at its sides.
Texture volume_texture(const Gl& gl, const SurfaceVolume& volume);

}  // namespace pelage
