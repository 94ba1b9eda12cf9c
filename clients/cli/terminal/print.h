// Prints answers of the server as text on standard output.
#pragma once

#include <vector>

#include "protocol/commands/answers.h"

namespace pelage {

void print(const SceneSummary& summary);
void print(const std::vector<SceneSummary>& summaries);
void print(const CommandResult& result);
void print(const CommandAnswer& answer);
/// Prints the skin and fur at a picked position, but not the JSON forms for recipes.
void print(const PickAnswer& answer);
void print(const PickedStrand& strand);
void print(const std::vector<LogEntry>& log);

}  // namespace pelage
