#include "protocol/json/encode.h"

#include <algorithm>

#include "protocol/json/members_scene.h"
#include "protocol/json/write.h"

namespace pelage {

using json_parts::line;
using json_parts::written;

std::string encode(const Command& command) { return line(written(command)); }
std::string encode(const NewScene& request) { return line(written(request)); }
std::string encode(const FrameRequest& request) { return line(written(request)); }
std::string encode(const BranchRequest& request) { return line(written(request)); }
std::string encode(const AmendRequest& request) { return line(written(request)); }
std::string encode(const PickRequest& request) { return line(written(request)); }
std::string encode(const Knobs& knobs) { return line(written(knobs)); }
std::string encode(const CommandAnswer& answer) { return line(written(answer)); }
std::string encode(const SceneSummary& summary) { return line(written(summary)); }
std::string encode(const SceneList& scenes) { return line(written(scenes)); }
std::string encode(const PickAnswer& answer) { return line(written(answer)); }
std::string encode(const RecipeRequest& request) { return line(written(request)); }
std::string encode(const RecipeAnswer& answer) { return line(written(answer)); }
std::string encode(const Comparison& comparison) { return line(written(comparison)); }
std::string encode(const SettingsAnswer& settings) { return line(written(settings)); }
std::string encode(const Log& log) { return line(written(log)); }
std::string encode(const SceneEvent& event) { return line(written(event)); }
std::string encode(const ChangeEvent& event) { return line(written(event)); }
std::string encode(const FrameEstimate& estimate) { return line(written(estimate)); }
std::string encode(const FrameCost& cost) { return line(written(cost)); }
std::string encode(const ExportAnswer& answer) { return line(written(answer)); }
std::string encode(const FrameProgressList& frames) { return line(written(frames)); }
std::string encode(const FrameCounters& counters) { return line(written(counters)); }
std::string encode(const MapAnswer& answer) { return line(written(answer)); }
std::string encode(const PictureAnswer& answer) { return line(written(answer)); }
std::string encode(const Problem& problem) { return line(written(problem)); }

std::string encode(const TraceReport& report) {
  TraceReport finite_report = report;
  finite_report.noise = std::min(report.noise, 1.0);
  return line(written(finite_report));
}

std::string encode(const std::vector<Command>& commands) {
  return commands.size() == 1 ? encode(commands.front()) : line(written(json_parts::Batch{commands}));
}

std::string json_text(std::string_view text) { return line(json_parts::Json(text)); }

}  // namespace pelage
