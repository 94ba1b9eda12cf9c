// Pictures that are uploaded for themselves. Runs in the confined worker only.
#pragma once

#include <string>

#include "protocol/base/status.h"
#include "protocol/commands/look.h"
#include "server/import/map_picture.h"
#include "server/surface/raw_model.h"

namespace pelage {

// All refuse (invalid, with the reason) bytes that are broken or of another format, and pictures wider or higher than
// limits::picture_pixels.

/// The light of an EXR or HDR of all directions; renderer/light/equirectangular.h says which pixel is where.
Result<SphericalHarmonics> read_environment(const std::string& bytes);

/// The colours of a PNG or JPEG that is laid on a model.
Result<RawImage> read_base_picture(const std::string& bytes);

/// The numbers of a PNG, JPEG, EXR or HDR that holds data. Also refuses NaN and infinity, with their count.
Result<MapPicture> read_map_picture(const std::string& bytes);

}  // namespace pelage
