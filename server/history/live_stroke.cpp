#include "server/history/live_stroke.h"

#include "base/limits.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

/// Returns everything that the parts of a stroke must have in common, as text.
std::string tool_text(Command command) {
  Stroke& stroke = *stroke_of(command);
  stroke.part = 0;
  stroke.last = true;
  stroke.samples.clear();
  return encode(command);
}

Status wrong_part(std::uint32_t expected) {
  return failure(Code::invalid, "parts of a stroke come in order", "/stroke/part",
                 "the next part is " + std::to_string(expected));
}

/// Checks the samples of all parts together, because limits and rising times apply across parts.
Status check_samples(const std::vector<StrokeSample>& so_far, const std::vector<StrokeSample>& more) {
  if (so_far.size() + more.size() > limits::samples_per_stroke) {
    return failure(Code::invalid, "the parts of this stroke have too many samples", "/stroke/samples",
                   "at most " + std::to_string(limits::samples_per_stroke) + " in all parts");
  }
  if (!so_far.empty() && !more.empty() && more.front().time < so_far.back().time) {
    return failure(Code::invalid, "time falls from one part of the stroke to the next", "/stroke/samples/0/time",
                   "at least " + std::to_string(so_far.back().time));
  }
  return {};
}

}  // namespace

Result<LiveStroke::Plan> LiveStroke::plan(const Command& command) const {
  const Stroke* stroke = stroke_of(command);
  if (stroke != nullptr && !stroke->id.empty() && stroke->id == id_) return next_part(command);
  if (stroke != nullptr && stroke->part != 0) return wrong_part(0);
  return Plan{command, command, false};
}

bool LiveStroke::joins(const Command& command) const {
  const Stroke* stroke = stroke_of(command);
  return stroke != nullptr && !id_.empty() && stroke->id == id_ && logged_parts_ > 0;
}

Result<LiveStroke::Plan> LiveStroke::next_part(const Command& command) const {
  const Stroke& part = *stroke_of(command);
  if (finished_) return failure(Code::conflict, "this stroke has had its last part", "/stroke/id");
  if (part.part != next_part_) return wrong_part(next_part_);
  if (tool_text(command) != tool_text(merged_)) {
    return failure(Code::invalid, "a part repeats the tool, its settings and the view of its stroke", "/stroke/id");
  }
  const std::vector<StrokeSample>& so_far = stroke_of(merged_)->samples;
  if (Status bad = check_samples(so_far, part.samples); !bad.ok()) return bad;
  Plan plan{merged_, command, logged_parts_ > 0};
  Stroke& merged = *stroke_of(plan.merged);
  merged.samples.insert(merged.samples.end(), part.samples.begin(), part.samples.end());
  Stroke& to_log = *stroke_of(plan.to_log);
  to_log.part = logged_parts_;
  to_log.samples.insert(to_log.samples.begin(), unlogged_.begin(), unlogged_.end());
  return plan;
}

void LiveStroke::accept(const Plan& plan, const Command& command, bool changed) {
  const Stroke* part = stroke_of(command);
  if (part == nullptr || part->id.empty()) {
    if (changed) end();
    return;
  }
  if (part->id != id_) logged_parts_ = 0;
  id_ = part->id;
  next_part_ = part->part + 1;
  finished_ = part->last;
  merged_ = plan.merged;
  unlogged_.clear();
  if (changed)
    ++logged_parts_;
  else
    unlogged_ = stroke_of(plan.to_log)->samples;
}

void LiveStroke::end() { *this = {}; }

}  // namespace pelage
