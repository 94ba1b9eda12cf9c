// What went wrong, in words for people or as JSON for programs.
#pragma once

#include <map>
#include <string>

#include "base/status.h"

namespace pelage {

enum ExitCode { done = 0, failed = 1, wrong_use = 2, refused = 3 };

/// How this run of the program reports failures.
struct ReportStyle {
  bool json = false;                         // one problem document
  std::map<std::string, std::string> flags;  // of the command line, by the last step of the member's JSON pointer
};
void set_report_style(ReportStyle style);
bool reports_json();

/// Prints the reason, where, the limit, the nearest name and what to do next, to standard error: what the status says,
/// or what fits its code. `context` says what was being done, such as "step 3 of groom.jsonl". Gives the exit code that
/// fits.
ExitCode report(const Status& status, const std::string& context = {});

}  // namespace pelage
