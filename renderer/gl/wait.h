#pragma once

#include "protocol/base/status.h"
#include "renderer/gl/functions.h"

namespace pelage {

/// Waits until all that was asked for so far is done. Fails with unavailable when that takes longer than a minute.
Status wait_for(const Gl& gl);

}  // namespace pelage
