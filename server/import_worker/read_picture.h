// Reading uploaded pictures: environments, skin textures, maps and a model's own pictures; sRGB to linear colours.
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

/// Each channel in [0, 1]; others are clamped, NaN stays.
inline glm::vec3 srgb_to_linear(glm::vec3 colour) {
  for (int i = 0; i < 3; ++i) {
    const float c = colour[i] < 0 ? 0 : (colour[i] > 1 ? 1 : colour[i]);
    colour[i] = linear_from_srgb(c);
  }
  return colour;
}

// Pictures that are uploaded for themselves. Runs in the confined worker only.

// All refuse (invalid, with the reason) bytes that are broken or of another format, and pictures wider or higher than
// limits::picture_pixels.

/// The light of an EXR or HDR of all directions; renderer/light/environment.h says which pixel is where.
Result<SphericalHarmonics> read_environment(const std::string& bytes);

/// Adds a PNG or JPEG to a model's pictures. Its index; -1 where it is broken, another format or larger than 8192 x
/// 8192, which is counted among the losses under its name.
int add_picture(RawModel& model, std::string_view bytes, const std::string& name);

/// The colours of a PNG or JPEG that is laid on a model.
Result<RawImage> read_skin_texture(const std::string& bytes);

/// The numbers of a PNG, JPEG, EXR or HDR that holds data. Also refuses NaN and infinity, with their count.
Result<MapPicture> read_map_picture(const std::string& bytes);

}  // namespace pelage
