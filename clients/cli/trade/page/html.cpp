#include "clients/cli/trade/page/html.h"

#include "clients/cli/trade/page/svg.h"

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
