#include "server/frames/linear_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace pelage {

std::vector<Aov> linear_aovs(const FrameRequest& request) {
  if (!is_linear(request.format)) return {Aov::beauty};
  std::vector<Aov> drawn;
  for (const Aov aov : request.aovs) {
    if (aov != Aov::cryptomatte)
      drawn.push_back(aov);
    else
      drawn.insert(drawn.end(), {Aov::objects_1, Aov::objects_2, Aov::objects_3, Aov::objects_4});
  }
  return drawn;
}

FrameRequest linear_request(const FrameRequest& request) {
  FrameRequest linear = request;
  linear.aovs = linear_aovs(request), linear.format = FrameFormat::exr;
  return linear;
}

Knobs knobs_of(const FurFrame& frame, const std::optional<TraceReport>& report) {
  Knobs knobs = frame.knobs;
  if (report && knobs.method == Method::strands) knobs.trace.passes = report->passes, knobs.trace.seconds = 0;
  return knobs;
}

namespace {

bool has_a_mean(Aov aov) {
  return aov != Aov::depth && aov != Aov::position && aov != Aov::normal && aov != Aov::tangent && aov != Aov::strand &&
         aov != Aov::root;
}

void add_report(const TraceReport& report, TraceReport& sum) {
  sum.passes += report.passes, sum.samples += report.samples;
  sum.grow_ms += report.grow_ms, sum.trace_ms += report.trace_ms;
  sum.strands = report.strands, sum.end = report.end;
}

}  // namespace

void MeanPicture::add(LinearPicture picture) {
  assert(added_ < count_ && picture.aovs.size() == kinds_.size());
  sums_.resize(kinds_.size());
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    if (!has_a_mean(kinds_[k])) continue;
    const std::vector<float>& numbers = picture.aovs[k].rgba;
    sums_[k].resize(numbers.size());
    std::transform(numbers.begin(), numbers.end(), sums_[k].begin(), sums_[k].begin(), std::plus<double>());
  }
  noise_square_ += picture.report.noise * picture.report.noise;
  add_report(picture.report, report_);
  if (added_++ == count_ / 2) mean_ = std::move(picture);
}

LinearPicture MeanPicture::take() && {
  assert(added_ == count_);
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    if (!has_a_mean(kinds_[k])) continue;
    std::transform(sums_[k].begin(), sums_[k].end(), mean_.aovs[k].rgba.begin(),
                   [&](double sum) { return static_cast<float>(sum / count_); });
  }
  mean_.report = report_;
  mean_.report.noise = std::sqrt(noise_square_) / count_;
  return std::move(mean_);
}

}  // namespace pelage
