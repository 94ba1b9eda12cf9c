// Encodes commands, requests and answers as one line of JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "protocol/commands/scene.h"
#include "protocol/commands/settings.h"
#include "protocol/json/decode.h"

namespace pelage {

std::string encode(const Command& command);                // decodes to the same command, bit for bit
std::string encode(const std::vector<Command>& commands);  // one: the command itself; more: {"commands": [...]}
std::string encode(const NewScene& request);               // decodes to the same request
std::string encode(const FrameRequest& request);           // decodes to the same request
std::string encode(const BranchRequest& request);          // decodes to the same request
std::string encode(const AmendRequest& request);           // decodes to the same request
std::string encode(const PickRequest& request);            // decodes to the same request
std::string encode(const RecipeRequest& request);          // decodes to the same request
std::string encode(const CommandAnswer& answer);
std::string encode(const SceneSummary& summary);
std::string encode(const SceneList& scenes);
std::string encode(const PickAnswer& answer);
std::string encode(const RecipeAnswer& answer);
std::string encode(const Comparison& comparison);
std::string encode(const SettingsAnswer& settings);  // each member as its command is encoded
std::string encode(const Log& log);
std::string encode(const SceneEvent& event);
std::string encode(const ChangeEvent& event);
std::string encode(const Knobs& knobs);
std::string encode(const FrameEstimate& estimate);
std::string encode(const FrameCost& cost);
std::string encode(const ExportAnswer& answer);
std::string encode(const FrameProgressList& frames);
std::string encode(const FrameCounters& counters);
/// Encodes a trace report. Noise that cannot be estimated yet is infinite, which JSON cannot hold; it is written as 1,
/// the largest error of a displayed channel.
std::string encode(const TraceReport& report);
std::string encode(const MapAnswer& answer);
std::string encode(const PictureAnswer& answer);
std::string encode(const Problem& problem);

/// Returns the JSON Schema (draft 2020-12) of a job's file, with all that it refers to.
std::string job_schema();

/// Returns a text as a JSON string, with its quotes.
std::string json_text(std::string_view text);

/// Encodes a problem document (RFC 9457): type, title, status, detail, and pointer, limit and nearest if there are any.
std::string encode_problem(const Status& status, int http_status);

}  // namespace pelage
