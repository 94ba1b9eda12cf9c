#include "server/import/import.h"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "base/limits.h"
#include "server/import/child_process.h"
#include "server/import/map_picture.h"

namespace pelage {

namespace {

/// Returns the refusal of an upload; `subject` is "model", "environment", "picture" or "file".
Status refusal(const std::string& subject, const std::string& reason) {
  return failure(Code::invalid, "The " + subject + " cannot be read: " + reason);
}

/// Returns the last line that the worker wrote; libraries may have written others before it.
std::string last_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

std::string reason_of_signal(int signal) {
  if (signal == SIGXCPU) return "it takes more than the allowed processor time.";
  if (signal == SIGSYS) return "its reader tried to do what it must not, and was ended.";
  return std::string("its reader crashed (") + strsignal(signal) + ").";
}

std::string seconds_text(double seconds) {
  std::ostringstream text;
  text << seconds;
  return text.str();
}

/// Returns ok if there is an answer, else the reason why not.
Status outcome(const std::string& subject, const ChildResult& result, const ImportLimits& limits) {
  if (result.cancelled) return failure(Code::unavailable, "Nobody waits for the " + subject + " any more.");
  if (result.timed_out) return refusal(subject, "it takes longer than " + seconds_text(limits.seconds) + " s.");
  if (result.too_long) {
    return refusal(subject, "it becomes larger than " + std::to_string(limits.answer_bytes) + " bytes in memory.");
  }
  if (result.signal != 0) return refusal(subject, reason_of_signal(result.signal));
  switch (result.exit_code) {
    case worker_exit::done: return {};
    case worker_exit::bad_input: return refusal(subject, last_line(result.complaint));
    case worker_exit::out_of_memory: return refusal(subject, "it needs more memory than is allowed.");
    default: break;
  }
  return failure(Code::internal, "The reader of uploads ended with code " + std::to_string(result.exit_code) + ": " +
                                     last_line(result.complaint));
}

/// Runs the worker, and passes its answer to `take` as it arrives.
Status run_worker(const std::string& worker, const std::string& job, const std::string& subject,
                  std::span<const std::byte> bytes, const ImportLimits& limits, const TakeAnswer& take,
                  const std::string& pose = {}) {
  const std::vector<std::string> arguments = {worker, job, std::to_string(limits.seconds),
                                              std::to_string(limits.memory_bytes), pose};
  const ChildLimits child{limits.seconds, limits.answer_bytes, limits.cancelled};
  const Result<ChildResult> result = run_child(arguments, bytes, child, take);
  if (!result.ok()) return result.status();
  return outcome(subject, *result, limits);
}

Result<std::string> whole_answer(const std::string& worker, const std::string& job, const std::string& subject,
                                 std::span<const std::byte> bytes, const ImportLimits& limits,
                                 const std::string& pose = {}) {
  std::string answer;
  const auto keep = [&](std::string_view more) { return answer += more, true; };
  const Status run = run_worker(worker, job, subject, bytes, limits, keep, pose);
  return run.ok() ? Result<std::string>(std::move(answer)) : run;
}

Result<RawModel> read_model(const std::string& worker, const std::string& job, std::span<const std::byte> bytes,
                            const std::string& pose, const ImportLimits& limits) {
  if (bytes.size() > limits::model_bytes) {
    return failure(Code::too_large, "The model is too large.", "", std::to_string(limits::model_bytes) + " bytes");
  }
  const Result<std::string> answer = whole_answer(worker, job, "model", bytes, limits, pose);
  if (!answer.ok()) return answer.status();
  return decode_raw_model(std::as_bytes(std::span(*answer)));
}

Status check_picture_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() <= limits::picture_bytes) return {};
  return failure(Code::too_large, "The picture is too large.", "",
                 "at most " + std::to_string(limits::picture_bytes) + " bytes");
}

}  // namespace

std::string program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path().string();
}

Result<RawModel> import_model(const std::string& worker, ModelFormat format, std::span<const std::byte> bytes,
                              const std::string& pose, const ImportLimits& limits) {
  return read_model(worker, worker_format_names[static_cast<std::size_t>(format)], bytes, pose, limits);
}

Result<RawModel> import_shape(const std::string& worker, ModelFormat format, std::span<const std::byte> bytes,
                              const std::string& pose) {
  const std::string job = std::string(worker_format_names[static_cast<std::size_t>(format)]) + worker_shape;
  return read_model(worker, job, bytes, pose, {});
}

Result<SphericalHarmonics> import_environment(const std::string& worker, std::span<const std::byte> bytes,
                                              const ImportLimits& limits) {
  if (Status status = check_picture_bytes(bytes); !status.ok()) return status;
  const Result<std::string> answer = whole_answer(worker, worker_environment, "environment", bytes, limits);
  if (!answer.ok()) return answer.status();
  return decode_harmonics(std::as_bytes(std::span(*answer)));
}

Result<RawImage> import_picture(const std::string& worker, std::span<const std::byte> bytes,
                                const ImportLimits& limits) {
  if (Status status = check_picture_bytes(bytes); !status.ok()) return status;
  const Result<std::string> answer = whole_answer(worker, worker_picture, "picture", bytes, limits);
  if (!answer.ok()) return answer.status();
  return decode_raw_image(std::as_bytes(std::span(*answer)));
}

Result<MapPicture> import_map(const std::string& worker, std::span<const std::byte> bytes, const ImportLimits& limits) {
  if (Status status = check_picture_bytes(bytes); !status.ok()) return status;
  const Result<std::string> answer = whole_answer(worker, worker_map, "picture", bytes, limits);
  if (!answer.ok()) return answer.status();
  return decode_map_picture(std::as_bytes(std::span(*answer)));
}

Result<GuideFile> import_guides(const std::string& worker, GuideFormat format, std::span<const std::byte> bytes,
                                const ImportLimits& limits) {
  const char* job = worker_guide_names[static_cast<std::size_t>(format)];
  const Result<std::string> answer = whole_answer(worker, job, "file", bytes, limits);
  if (!answer.ok()) return answer.status();
  return decode_guides(std::as_bytes(std::span(*answer)));
}

Status import_saved(const std::string& worker, std::span<const std::byte> bytes, const TakeRows& take,
                    ImportLimits limits) {
  if (bytes.size() > limits::model_bytes)
    return failure(Code::too_large, "The file is too large.", "", std::to_string(limits::model_bytes) + " bytes");
  limits.answer_bytes = limits::saved_bytes / 4 * 5;  // rows take a little more than pages
  Status taken;
  const auto take_bytes = [&](std::string_view more) { return (taken = take(more)).ok(); };
  const Status run = run_worker(worker, worker_saved, "file", bytes, limits, take_bytes);
  return taken.ok() ? run : taken;
}

}  // namespace pelage
