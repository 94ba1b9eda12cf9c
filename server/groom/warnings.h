// What a command does as asked but is hardly meant.
#pragma once

#include <string>
#include <vector>

#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage {

/// In plain words, for the answer: a brush that is finer than the mesh where its stroke passes, so that it touches few
/// vertices or none. The command is resolved.
std::vector<std::string> warnings_of(const Command& resolved, const Surface& surface);

}  // namespace pelage
