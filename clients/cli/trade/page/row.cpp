#include "clients/cli/trade/page/row.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace pelage::trade {

namespace {

using Line = std::vector<std::string>;

const Line& names() {
  static const Line result{"scene",     "size",     "series", "base",       "value",   "reference", "truth",
                           "shells",    "steps",    "scale",  "flip",       "flip_95", "outline",   "outline_95",
                           "luminance", "coverage", "floor",  "non_finite", "draw_ms", "cpu_ms",    "knobs"};
  return result;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

std::string joined(const Line& line) {
  std::string text;
  for (const std::string& field : line) text += (text.empty() ? "" : ",") + quoted(field);
  return text + "\r\n";
}

template <class T>
std::string text_of(T value) {
  return fmt::format("{}", value);  // the shortest that reads back to the same bits
}

Line line_of(const Row& r) {
  return {r.scene,
          text_of(r.size),
          r.series,
          r.base,
          r.value,
          r.reference,
          text_of(r.truth),
          text_of(r.shells),
          text_of(r.steps),
          text_of(r.scale),
          text_of(r.flip),
          text_of(r.flip_95),
          text_of(r.outline),
          text_of(r.outline_95),
          text_of(r.luminance),
          text_of(r.coverage),
          text_of(r.floor),
          text_of(r.non_finite),
          text_of(r.draw_ms),
          text_of(r.cpu_ms),
          r.knobs};
}

/// Takes the fields of the next line off the text; none when a quote is not closed.
std::optional<Line> take_line(std::string_view& text) {
  Line line(1);
  bool inside = false;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (inside && c == '"' && text.starts_with('"')) {
      line.back() += c;
      text.remove_prefix(1);
    } else if (c == '"') {
      inside = !inside;
    } else if (!inside && c == ',') {
      line.emplace_back();
    } else if (!inside && c == '\n') {
      break;
    } else if (inside || c != '\r') {
      line.back() += c;
    }
  }
  return inside ? std::nullopt : std::optional(line);
}

/// Reads fields one after the other and remembers whether any was bad.
class Reader {
 public:
  explicit Reader(const Line& line) : line_(line) {}

  void read(std::string& value) { value = line_[next_++]; }

  template <class T>
  void read(T& value) {
    const std::string& text = line_[next_++];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    good_ = good_ && error == std::errc{} && end == text.data() + text.size();
  }

  bool good() const { return good_; }

 private:
  const Line& line_;
  std::size_t next_ = 0;
  bool good_ = true;
};

std::optional<Row> row_of(const Line& line) {
  if (line.size() != names().size()) return std::nullopt;
  Row row;
  Reader reader(line);
  const auto read = [&](auto&... values) { (reader.read(values), ...); };
  read(row.scene, row.size, row.series, row.base, row.value, row.reference, row.truth, row.shells, row.steps, row.scale,
       row.flip, row.flip_95, row.outline, row.outline_95, row.luminance, row.coverage, row.floor, row.non_finite,
       row.draw_ms, row.cpu_ms, row.knobs);
  return reader.good() ? std::optional(row) : std::nullopt;
}

}  // namespace

std::string to_csv(const std::vector<Row>& rows) {
  std::string text = joined(names());
  for (const Row& row : rows) text += joined(line_of(row));
  return text;
}

Result<std::vector<Row>> from_csv(std::string_view text) {
  if (take_line(text) != names()) return failure(Code::malformed, "The table has other columns; start without it.");
  std::vector<Row> rows;
  while (!text.empty()) {
    const std::optional<Line> line = take_line(text);
    const std::optional<Row> row = line ? row_of(*line) : std::nullopt;
    if (!row) return failure(Code::malformed, fmt::format("Row {} of the table is broken.", rows.size() + 1));
    rows.push_back(*row);
  }
  return rows;
}

}  // namespace pelage::trade
