// Answers in words, on standard output.
#pragma once

#include <vector>

#include "protocol/commands/answers.h"

namespace pelage {

void print(const SceneSummary& summary);
void print(const std::vector<SceneSummary>& summaries);
void print(const CommandResult& result);
void print(const CommandAnswer& answer);
/// Prints what lies at a position, without the forms that recipes take.
void print(const PickAnswer& answer);
void print(const PickedStrand& strand);
void print(const std::vector<LogEntry>& log);

}  // namespace pelage
