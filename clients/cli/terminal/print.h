// Answers in words, on standard output.
#pragma once

#include <vector>

#include "protocol/commands/answers.h"

namespace pelage {

void print(const SceneSummary& summary);
void print(const std::vector<SceneSummary>& summaries);
void print(const CommandResult& result);
void print(const CommandAnswer& answer);
/// What lies there; not how recipes name it.
void print(const PickAnswer& answer);
void print(const PickedStrand& strand);
void print(const std::vector<LogEntry>& log);

}  // namespace pelage
