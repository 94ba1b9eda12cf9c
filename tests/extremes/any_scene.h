// Random JSON of scenes and frames, with every number over its whole range and often at an end.
#pragma once

#include "tests/extremes/row.h"

namespace pelage::testing {

/// A random row, to be called in a RapidCheck property. It is drawn, or refused if members do not go together.
Row any_row();
/// A random frame of few shells, for the same scene.
std::string any_frame();
/// A random member `quality` of a frame that traces strands.
std::string any_tracing();

}  // namespace pelage::testing
