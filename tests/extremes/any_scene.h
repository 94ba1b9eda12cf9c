// Texts of any scene and any frame, with every number over its whole range and often at an end.
#pragma once

#include "tests/extremes/row.h"

namespace pelage::testing {

/// Inside a property of RapidCheck. The row is drawn, or refused for members that do not go together.
Row any_row();
/// Another frame of the same scene, of few shells.
std::string any_frame();
/// How strands are traced: the member `quality` of a frame.
std::string any_tracing();

}  // namespace pelage::testing
