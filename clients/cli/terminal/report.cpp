#include "clients/cli/terminal/report.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdio>

#include "protocol/json/encode.h"

namespace pelage {

namespace {

ReportStyle& report_style() {
  static ReportStyle style;
  return style;
}

const char* advice_for(Code code) {
  switch (code) {
    case Code::malformed: return "correct the text; openapi.json of the server says what it takes";
    case Code::not_found: return "see what there is with `pelage list`";
    case Code::conflict: return "try again";
    case Code::precondition: return "look at the scene with `pelage info` and decide again";
    case Code::too_large: return "send less at a time";
    case Code::unsupported: return "send it in a form that the server reads";
    case Code::invalid: return "correct the value and try again; nothing was changed by it";
    case Code::busy:
    case Code::unavailable: return "try again in a moment; the server has other work";
    case Code::ok:
    case Code::internal: break;
  }
  return "the server's own output says more";
}

ExitCode exit_code_of(Code code) {
  const bool ours = code == Code::internal || code == Code::unavailable || code == Code::busy || code == Code::conflict;
  return ours ? failed : refused;
}

/// Returns the HTTP status that the server uses for a code, so that the client's own errors look like the server's.
int http_status_of(Code code) {
  switch (code) {
    case Code::malformed: return 400;
    case Code::not_found: return 404;
    case Code::conflict: return 409;
    case Code::precondition: return 412;
    case Code::too_large: return 413;
    case Code::unsupported: return 415;
    case Code::invalid: return 422;
    case Code::busy: return 429;
    case Code::unavailable: return 503;
    case Code::ok:
    case Code::internal: break;
  }
  return 500;
}

/// Returns the flag that set the member at a JSON pointer or one of its parents; "" if no flag did.
std::string flag_of(std::string pointer) {
  while (!pointer.empty()) {
    const std::size_t slash = pointer.rfind('/');
    if (slash == std::string::npos) break;
    const std::string step = pointer.substr(slash + 1);
    pointer.resize(slash);
    const auto flag = report_style().flags.find(step);
    if (flag != report_style().flags.end()) return flag->second;
  }
  return "";
}

void report_as_json(const Status& status, const std::string& context, const std::string& flag,
                    const std::string& next) {
  std::string problem = encode_problem(status, http_status_of(status.code));
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) problem.insert(problem.rfind('}'), fmt::format(",\"{}\":{}", name, json_text(value)));
  };
  add("context", context), add("flag", flag), add("next", next);
  fmt::print(stderr, "{}\n", problem);
}

}  // namespace

void set_report_style(ReportStyle style) { report_style() = std::move(style); }

bool reports_json() { return report_style().json; }

ExitCode report(const Status& status, const std::string& context) {
  const std::string flag = flag_of(status.pointer);
  const std::string next = status.next.empty() ? advice_for(status.code) : status.next;
  if (report_style().json) {
    report_as_json(status, context, flag, next);
    return exit_code_of(status.code);
  }
  fmt::print(stderr, "pelage: {}\n", status.message);
  if (!context.empty()) fmt::print(stderr, "  in:      {}\n", context);
  if (!flag.empty()) fmt::print(stderr, "  flag:    {}\n", flag);
  if (flag.empty() && !status.pointer.empty()) fmt::print(stderr, "  field:   {}\n", status.pointer);
  if (!status.limit.empty()) fmt::print(stderr, "  limit:   {}\n", status.limit);
  if (!status.nearest.empty()) fmt::print(stderr, "  nearest: {}\n", status.nearest);
  fmt::print(stderr, "  next:    {}\n", next);
  return exit_code_of(status.code);
}

}  // namespace pelage
