#include "clients/cli/terminal/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "clients/cli/terminal/table.h"
#include "protocol/json/decode.h"
#include "protocol/json/names.h"

namespace pelage {

namespace {

std::string text_of(glm::dvec3 v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

void print_sheets(const std::vector<NumberedPart>& sheets) {
  constexpr std::size_t max_printed = 8;
  for (std::size_t i = 0; i < std::min(max_printed, sheets.size()); ++i) {
    fmt::print(
        "sheet       part {} ({} triangles at {}) has one layer, bare behind; load with --two-sided {} for fur on both "
        "sides\n",
        sheets[i].part, sheets[i].triangles, text_of(sheets[i].centre), sheets[i].part);
  }
  if (sheets.size() > max_printed)
    fmt::print("sheet       and {} more; --json lists them\n", sheets.size() - max_printed);
}

constexpr std::size_t max_commands = 3;

/// Returns the command's name and where it acts: the radius of the stroke's brush, or "everywhere".
template <class Tool>
std::string words_of(const Tool& command) {
  std::string words = Tool::op;
  if constexpr (requires { command.stroke, command.brush; }) {
    if (command.stroke) words += fmt::format(" r {:g}", command.brush.radius);
  }
  if constexpr (requires { command.flood; }) {
    if (command.flood) words += " everywhere";
  }
  return words;
}

/// Describes a log entry's commands, given as JSON, such as "comb r 0.12, frizz everywhere and 2 more": at most three,
/// then the number of the others. Returns "" for no commands.
std::string described(const std::string& commands) {
  const auto decoded =
      commands.empty() ? Result<std::vector<Command>>(std::vector<Command>{}) : decode_commands(commands);
  if (!decoded) return commands;  // unknown commands of a newer server
  std::string words;
  for (std::size_t k = 0; k < decoded->size() && k < max_commands; ++k) {
    words += (k > 0 ? ", " : "") + std::visit([](const auto& command) { return words_of(command); }, (*decoded)[k]);
  }
  if (decoded->size() > max_commands) words += fmt::format(" and {} more", decoded->size() - max_commands);
  return words;
}

}  // namespace

namespace {

void print(const TransferReport& transfer) {
  fmt::print("groom       kept; {} of {} vertices lie farther than .05 sizes from the model before{}\n", transfer.far,
             transfer.vertices, transfer.align == Alignment::box ? ", aligned by their boxes" : "");
  fmt::print("before      {} is the scene as it was, with its undo log\n", transfer.before);
}

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
  using json_names::axes, json_names::word_of;
  fmt::print("axes        up {}, front {} of the file\n", word_of(axes, report.up), word_of(axes, report.front));
  if (!report.pose.empty()) fmt::print("pose        {}\n", report.pose);
  if (!report.animations.empty()) fmt::print("animations  {}\n", fmt::join(report.animations, ", "));
  for (const MaterialReport& material : report.materials)
    fmt::print("material    {}: {} triangles{}\n", material.name, material.triangles, material.bare ? ", bare" : "");
  for (const Repair& repair : report.repairs) {
    fmt::print("repaired    {}: {}{}\n", repair.code, repair.count,
               repair.names.empty() ? "" : fmt::format(" ({})", fmt::join(repair.names, ", ")));
  }
  for (const NumberedPart& part : report.doubtful_parts) {
    fmt::print("doubtful    part {} ({} triangles at {}) may be inside out; load with --flip {} to turn it\n",
               part.part, part.triangles, text_of(part.centre), part.part);
  }
  print_sheets(report.sheets);
  for (const CoatEntry& coat : summary.coats) fmt::print("coat        {}{}\n", coat.name, coat.muted ? " (muted)" : "");
  for (const EditLayer& layer : summary.edit_layers)
    fmt::print("layer       {} (weight {:g}{})\n", layer.name, layer.weight, layer.muted ? ", muted" : "");
  fmt::print("undo, redo  {}, {} steps\nfields      {}\n", summary.undo_steps, summary.redo_steps,
             to_hex(summary.fields_hash));
  if (!summary.damage.empty()) fmt::print("damage      {}\n", summary.damage);
  if (summary.transfer) print(*summary.transfer);
}

void print(const std::vector<SceneSummary>& summaries) {
  std::vector<std::vector<std::string>> rows{{"id", "name", "revision", "model", "triangles"}};
  for (const SceneSummary& scene : summaries)
    rows.push_back(
        {scene.id, scene.name, std::to_string(scene.revision), scene.model, std::to_string(scene.report.triangles)});
  fmt::print("{}", table_of(rows));
  for (const SceneSummary& scene : summaries) {
    if (!scene.damage.empty()) fmt::print("{} cannot be changed: {}\n", scene.name, scene.damage);
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

void print(const PickedStrand& strand) {
  fmt::print("strand      {} of the {}, at {:.2g} of its length, root {}\n", strand.id,
             strand.kind == StrandKind::coat ? "coat" : "curves", strand.along, text_of(strand.root));
}

void print(const PickAnswer& answer) {
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
    const std::string words = described(entry.commands), author = entry.author.empty() ? "" : ", by " + entry.author;
    const bool later = entry.step != 0 && entry.step != entry.revision;  // it joined or replayed an earlier step
    fmt::print("{:>6}{} {}, {} vertices{}{}\n", entry.revision, entry.in_effect ? '*' : ' ',
               words.empty() ? entry.kind : words, entry.touched, later ? fmt::format(", step {}", entry.step) : "",
               author);
  }
}

}  // namespace pelage
