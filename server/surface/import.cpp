#include "server/surface/import.h"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "protocol/base/limits.h"
#include "server/surface/child_process.h"
#include "server/surface/worker_contract.h"

namespace pelage {

namespace {

Status refusal(const std::string& reason) { return failure(Code::invalid, "The model cannot be read: " + reason); }

/// The last line that the worker wrote; libraries may have written others before it.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

Status reason_of_signal(int signal) {
  if (signal == SIGXCPU) return refusal("it takes more than the allowed processor time.");
  if (signal == SIGSYS) return refusal("its reader tried to do what it must not, and was ended.");
  return refusal(std::string("its reader crashed (") + strsignal(signal) + ").");
}

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds;
  return text.str();
}

/// Why there is no answer; ok when there is one.
Status outcome(const ChildResult& result, const ImportLimits& limits) {
  if (result.timed_out) return refusal("it takes longer than " + seconds_text(limits.seconds) + " s.");
  if (result.too_long) {
    return refusal("it becomes larger than " + std::to_string(limits.answer_bytes) + " octets in memory.");
  }
  if (result.signal != 0) return reason_of_signal(result.signal);
  switch (result.exit_code) {
    case worker_exit::done: return {};
    case worker_exit::bad_input: return refusal(last_line(result.complaint));
    case worker_exit::out_of_memory: return refusal("it needs more memory than is allowed.");
    default: break;
  }
  return failure(Code::internal, "The reader of models ended with code " + std::to_string(result.exit_code) + ": " +
                                     last_line(result.complaint));
}

}  // namespace

std::string program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path().string();
}

Result<RawModel> import_model(const std::string& worker, ModelFormat format, std::span<const std::byte> octets,
                              const ImportLimits& limits) {
  if (octets.size() > limits::model_bytes) {
    return failure(Code::too_large, "The model is too large.", "", std::to_string(limits::model_bytes) + " octets");
  }
  const std::vector<std::string> arguments = {worker, worker_format_names[static_cast<std::size_t>(format)],
                                              std::to_string(limits.seconds), std::to_string(limits.memory_bytes)};
  const Result<ChildResult> result = run_child(arguments, octets, {limits.seconds, limits.answer_bytes});
  if (!result.ok()) return result.status();
  if (Status status = outcome(*result, limits); !status.ok()) return status;
  return decode_raw_model(std::as_bytes(std::span(result->answer)));
}

}  // namespace pelage
