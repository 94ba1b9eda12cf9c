// Answers in words, on standard output.
#pragma once

#include <vector>

#include "protocol/commands/answers.h"
#include "renderer/compare/compare.h"

namespace pelage {

void print(const SceneSummary& summary);
void print(const std::vector<SceneSummary>& summaries);
void print(const CommandAnswer& answer);
void print(const PickAnswer& answer);
void print(const std::vector<LogEntry>& log);

/// Only with figures.
void print(const PictureError& error);
void print_json(const PictureError& error);

}  // namespace pelage
