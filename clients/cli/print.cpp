#include "clients/cli/print.h"

#include <fmt/format.h>

namespace pelage {

namespace {

std::string text_of(glm::dvec3 v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

std::string shortened(const std::string& text) { return text.size() <= 60 ? text : text.substr(0, 57) + "..."; }

}  // namespace

void print(const SceneSummary& summary) {
  const ModelReport& report = summary.report;
  fmt::print("id          {}\nname        {}\nrevision    {}\nmodel       {}\nfur patches {}\n", summary.id,
             summary.name, summary.revision, summary.model, summary.fur_patches);
  fmt::print("vertices    {} (of {} in the source)\n", report.vertices, report.source_vertices);
  fmt::print("triangles   {} (of {} faces in the source)\nparts       {}\n", report.triangles, report.source_faces,
             report.parts);
  fmt::print("size        {:.6g}\nfrom        {}\nto          {}\n", report.size, text_of(report.bounds.min),
             text_of(report.bounds.max));
  for (const Repair& repair : report.repairs) fmt::print("repaired    {}: {}\n", repair.code, repair.count);
  for (const EditLayer& layer : summary.edit_layers)
    fmt::print("layer       {} (weight {:g}{})\n", layer.name, layer.weight, layer.muted ? ", muted" : "");
  fmt::print("undo, redo  {}, {} steps\nfields      {}\n", summary.undo_steps, summary.redo_steps,
             to_hex(summary.fields_hash));
}

void print(const std::vector<SceneSummary>& summaries) {
  for (const SceneSummary& scene : summaries) {
    fmt::print("{}  {}  revision {}  {}  {} triangles\n", scene.id, scene.name, scene.revision, scene.model,
               scene.report.triangles);
  }
}

void print(const CommandResult& result) {
  fmt::print("{}: touched {}", result.op, result.touched);
  if (result.clamped > 0) fmt::print(", {} held at a limit", result.clamped);
  for (const FieldChange& change : result.fields) {
    fmt::print("; {} {}: mean {:.4g}, largest {:.4g}", change.changed, change.field, change.mean_change,
               change.max_change);
  }
  fmt::print(" ({:.2f} ms)\n", result.milliseconds);
  for (const std::string& warning : result.warnings) fmt::print("  warning: {}\n", warning);
}

void print(const CommandAnswer& answer) {
  for (const CommandResult& result : answer.results) print(result);
  fmt::print("revision {}\n", answer.revision);
}

void print(const PickAnswer& answer) {
  if (!answer.hit) {
    fmt::print("nothing there\n");
    return;
  }
  fmt::print("triangle    {}\nbarycentric {}\nposition    {}\nnormal      {}\n", answer.triangle,
             text_of(answer.barycentric), text_of(answer.position), text_of(answer.normal));
  fmt::print("direction   {}\ninclination {:.6g}\nlength      {:.6g}\nstretch     {:.6g}\n", text_of(answer.direction),
             answer.inclination, answer.length, answer.stretch);
  for (std::size_t i = 0; i < answer.painted.size(); ++i) {
    const FieldShape& shape = field_shapes[first_painted + i];
    const glm::dvec4 value = answer.painted[i];
    if (shape.channels == 1) fmt::print("{:11} {:.6g}\n", shape.name, value.x);
    if (shape.channels == 4) fmt::print("{:11} {} cover {:.6g}\n", shape.name, text_of(glm::dvec3(value)), value.w);
  }
}

void print(const std::vector<LogEntry>& log) {
  for (const LogEntry& entry : log) {
    fmt::print("{:>6}{} {:<6}  {:>8} touched  {}\n", entry.revision, entry.in_effect ? '*' : ' ', entry.kind,
               entry.touched, shortened(entry.commands));
  }
}

}  // namespace pelage
