// Answers in words, on standard output.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/session.h"
#include "protocol/base/status.h"
#include "protocol/commands/answers.h"

namespace pelage {

void print(const SceneSummary& summary);
void print(const std::vector<SceneSummary>& summaries);
void print(const CommandResult& result);
void print(const CommandAnswer& answer);
/// With the place in each form that commands and recipes take; `box` is the model's.
void print(const PickAnswer& answer, const Bounds& box);
void print(const std::vector<LogEntry>& log);

// Files and the standard streams.

/// "-" is standard input. Refused when it cannot be read (not_found) or is over `max_bytes` (too_large).
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

/// Under a temporary name in the same folder, then renamed; "-" is standard output.
Status write_file(const std::string& path, const std::string& bytes);

/// A file that is written piece by piece, under a temporary name that goes with it unless it is kept.
class NewFile {
 public:
  explicit NewFile(std::string path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  bool write(std::string_view piece);
  /// Renames it, or says why it cannot be written.
  Status keep();

 private:
  std::string path_, temporary_;
  std::ofstream file_;
};

// Programs that do one action of the client.

/// Becomes the program of this name that lies beside this one, with the same arguments. Comes back only to say that it
/// cannot.
ExitCode hand_over(const char* program, char* const* arguments);

}  // namespace pelage
