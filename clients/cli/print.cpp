#include "clients/cli/print.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "clients/cli/describe.h"
#include "protocol/json/names.h"

namespace pelage {

namespace {

std::string text_of(glm::dvec3 v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); }

void print_sheets(const std::vector<NumberedPart>& sheets) {
  constexpr std::size_t shown = 8;
  for (std::size_t i = 0; i < std::min(shown, sheets.size()); ++i) {
    fmt::print(
        "sheet       part {} ({} triangles at {}) has one layer, bare behind; load with --two-sided {} for fur on both "
        "sides\n",
        sheets[i].part, sheets[i].triangles, text_of(sheets[i].centre), sheets[i].part);
  }
  if (sheets.size() > shown) fmt::print("sheet       and {} more; --json lists them\n", sheets.size() - shown);
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
  for (const Repair& repair : report.repairs) {
    fmt::print("repaired    {}: {}{}\n", repair.code, repair.count,
               repair.names.empty() ? "" : fmt::format(" ({})", fmt::join(repair.names, ", ")));
  }
  for (const NumberedPart& part : report.doubtful_parts) {
    fmt::print("doubtful    part {} ({} triangles at {}) may be inside out; load with --flip {} to turn it\n",
               part.part, part.triangles, text_of(part.centre), part.part);
  }
  print_sheets(report.sheets);
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

void print(const PickAnswer& answer, const Bounds& box) {
  if (!answer.hit) {
    fmt::print("nothing there\n");
    return;
  }
  const auto share = [&](int k) {
    const double side = box.max[k] - box.min[k];
    return side > 0 ? (answer.position[k] - box.min[k]) / side : 0;
  };
  fmt::print("triangle    {}\nbarycentric {}\nposition    {}\nnormal      {}\n", answer.triangle,
             text_of(answer.barycentric), text_of(answer.position), text_of(answer.normal));
  fmt::print("in a recipe {{\"at\": [{:.3f}, {:.3f}, {:.3f}]}}\n", share(0), share(1), share(2));
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
    fmt::print("{:>6}{} {}, {} vertices{}\n", entry.revision, entry.in_effect ? '*' : ' ',
               words.empty() ? entry.kind : words, entry.touched, author);
  }
}

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& stream = path == "-" ? std::cin : file;
  std::string bytes;
  char block[1 << 16];
  while (stream.read(block, sizeof block) || stream.gcount() > 0) {
    bytes.append(block, static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > max_bytes) {
      return failure(Code::too_large, path + " is too large.", "", fmt::format("at most {} bytes", max_bytes));
    }
  }
  // A folder opens as a file and fails at the first read.
  if (stream.bad() || (path != "-" && !file.is_open())) {
    return with_next(failure(Code::not_found, "Cannot read " + path + "."),
                     "name a file that exists and that you may read; - is standard input");
  }
  return bytes;
}

Status write_file(const std::string& path, const std::string& bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout ? Status{}
                     : with_next(failure(Code::internal, "Cannot write to standard output."),
                                 "see why its reader ended, or name a file");
  }
  NewFile file(path);
  file.write(bytes);
  return file.keep();
}

NewFile::NewFile(std::string path)
    : path_(std::move(path)), temporary_(fmt::format("{}.{}", path_, getpid())), file_(temporary_, std::ios::binary) {}

NewFile::~NewFile() {
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

bool NewFile::write(std::string_view piece) {
  return static_cast<bool>(file_.write(piece.data(), static_cast<std::streamsize>(piece.size())));
}

Status NewFile::keep() {
  file_.close();
  if (file_ && std::rename(temporary_.c_str(), path_.c_str()) == 0) {
    temporary_.clear();
    return {};
  }
  return with_next(failure(Code::internal, "Cannot write " + path_ + "."),
                   "name a file in a folder that exists, in which you may write and which has room");
}

ExitCode hand_over(const char* program, char* const* arguments) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string path = self.parent_path() / program;
  execv(path.c_str(), arguments);
  return report(with_next(failure(Code::internal, "Cannot start " + path + "; it belongs beside pelage."),
                          "build or install all programs in one folder"));
}

}  // namespace pelage
