#include "clients/cli/trade/page/row.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>

#include "clients/cli/trade/page/page.h"
#include "clients/cli/trade/page/plots.h"

namespace pelage::trade {

namespace {

constexpr const char* style = R"(
body{font:16px/1.5 sans-serif;color:#2b2925;background:#faf8f4;max-width:1160px;margin:2em auto;padding:0 1.5em}
h1{font-size:1.9em;margin:0 0 .2em} h2{font-size:1.35em;margin:2em 0 .3em;border-bottom:1px solid #ddd6ca}
h3{font-size:1.05em;margin:1.2em 0 .2em} p{max-width:46em;margin:.4em 0}
table{border-collapse:collapse;font-size:14px;margin:.6em 0} th{text-align:left;color:#6b655b;font-weight:600}
td,th{padding:.15em 1em .15em 0;border-bottom:1px solid #eae4da;vertical-align:top}
.panels,.pictures{display:flex;flex-wrap:wrap;gap:10px 18px} .pair{display:flex;flex-wrap:wrap;gap:0 3em}
figure{margin:0;width:208px} figure img{width:208px;height:208px;display:block;border-radius:3px;margin-bottom:3px}
figcaption{font-size:13px;line-height:1.35;color:#55504a} svg{display:block;max-width:100%}
details{margin:1em 0} summary{cursor:pointer;color:#0072b2} .all{font-size:12px}
)";

std::string row_html(const std::vector<std::string>& cells, const char* tag) {
  std::string text = "<tr>";
  for (const std::string& cell : cells) text += std::string("<") + tag + ">" + escaped(cell) + "</" + tag + ">";
  return text + "</tr>\n";
}

}  // namespace

std::string table_html(const Table& table) {
  std::string text = "<table><thead>" + row_html(table.head, "th") + "</thead><tbody>";
  for (const auto& row : table.rows) text += row_html(row, "td");
  return text + "</tbody></table>";
}

std::string section(const std::string& title, const std::string& content) {
  return "<h2>" + escaped(title) + "</h2>\n" + content + "\n";
}

std::string document(const std::string& title, const std::string& content) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\" />"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" /><title>" +
         escaped(title) + "</title><style>" + style + "</style></head>\n<body>\n<h1>" + escaped(title) + "</h1>\n" +
         content + "</body></html>\n";
}

}  // namespace pelage::trade

namespace pelage::trade {

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

using Line = std::vector<std::string>;

const Line& names() {
  static const Line result{"scene",     "size",     "series", "base",       "value",   "reference",  "truth",
                           "shells",    "steps",    "scale",  "flip",       "flip_95", "silhouette", "silhouette_95",
                           "luminance", "coverage", "floor",  "non_finite", "draw_ms", "cpu_ms",     "knobs"};
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
          text_of(r.silhouette),
          text_of(r.silhouette_95),
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
       row.flip, row.flip_95, row.silhouette, row.silhouette_95, row.luminance, row.coverage, row.floor, row.non_finite,
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
