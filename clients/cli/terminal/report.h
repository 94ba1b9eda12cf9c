// Reports errors, as text for people or as JSON for programs.
#pragma once

#include <map>
#include <string>

#include "base/status.h"

namespace pelage {

enum ExitCode { done = 0, failed = 1, wrong_use = 2, refused = 3 };

/// How this run of the program reports failures.
struct ReportStyle {
  bool json = false;                         // print a problem document instead of text
  std::map<std::string, std::string> flags;  // flags by the member that they set; see flags_of()
};
void set_report_style(ReportStyle style);
bool reports_json();

/// Prints an error to standard error: message, context, flag or field, limit, nearest name and advice; a default advice
/// for its code if the status has none. `context` says what was being done, such as "step 3 of groom.jsonl". Returns
/// the exit code.
ExitCode report(const Status& status, const std::string& context = {});

}  // namespace pelage
