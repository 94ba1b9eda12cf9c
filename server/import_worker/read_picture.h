// Reads uploaded pictures (environments, skin textures, maps, a model's own pictures), and converts sRGB to linear.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "base/colour_space.h"
#include "base/status.h"
#include "protocol/commands/look.h"
#include "server/import/map_picture.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Converts each channel, clamped to [0, 1]; NaN stays NaN.
inline glm::vec3 srgb_to_linear(glm::vec3 colour) {
  for (int i = 0; i < 3; ++i) {
    const float c = colour[i] < 0 ? 0 : (colour[i] > 1 ? 1 : colour[i]);
    colour[i] = linear_from_srgb(c);
  }
  return colour;
}

// Readers of pictures. They run in the confined worker only.

// The functions that return a Result refuse (invalid, with the reason) bytes that are broken or of another format, and
// pictures wider or higher than limits::picture_pixels.

/// Returns the light of an equirectangular EXR or HDR, with the directions of renderer/light/environment.h.
Result<SphericalHarmonics> read_environment(const std::string& bytes);

/// Adds a PNG or JPEG to a model's pictures and returns its index; -1 if it is broken, of another format or larger than
/// 8192 x 8192, which is counted among the losses under its name.
int add_picture(RawModel& model, std::string_view bytes, const std::string& name);

/// Reads a PNG or JPEG: a skin texture or a backplate.
Result<RawImage> read_skin_texture(const std::string& bytes);

/// Reads a PNG, JPEG, EXR or HDR that holds data. Also refuses NaN and infinity, and says how many there are. A picture
/// one pixel wide, which holds a number for each vertex, may have any height.
Result<MapPicture> read_map_picture(const std::string& bytes);

}  // namespace pelage
