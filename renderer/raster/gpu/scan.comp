#version 450 core
// Exclusive prefix sums (Blelloch 1990): within each run of numbers, then over the sums of the runs, which are then added
// to the runs.
layout(local_size_x = 256) in;
layout(std430, binding = 0) buffer Numbers { uint numbers[]; };
layout(std430, binding = 1) buffer Sums { uint sums[]; };  // sum of each run, then of all numbers
uniform int stage;  // 0: within runs; 1: over the sums of the runs, by one group; 2: adds these to the runs
uniform uint count;

const uint run = 1024;
shared uint partial[256];

// Returns the sum over all lanes before this one; `total` becomes the sum over all lanes.
uint sum_before(uint own, out uint total) {
  uint lane = gl_LocalInvocationIndex;
  partial[lane] = own;
  barrier();
  for (uint step = 1; step < 256; step *= 2) {
    uint other = lane >= step ? partial[lane - step] : 0;
    barrier();
    partial[lane] += other;
    barrier();
  }
  total = partial[255];
  uint before = partial[lane] - own;
  barrier();
  return before;
}

void scan_run(uint first, uint end, bool of_sums, inout uint carry) {
  uint at = first + 4 * gl_LocalInvocationIndex;
  uint value[4];
  uint own = 0;
  for (uint k = 0; k < 4; ++k) {
    value[k] = at + k < end ? (of_sums ? sums[at + k] : numbers[at + k]) : 0;
    own += value[k];
  }
  uint total, sum = carry + sum_before(own, total);
  for (uint k = 0; k < 4; ++k) {
    if (at + k < end) {
      if (of_sums) sums[at + k] = sum;
      else numbers[at + k] = sum;
    }
    sum += value[k];
  }
  carry += total;
}

void main() {
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, runs = (count + run - 1) / run;
  uint carry = 0;
  if (stage == 0) {
    if (group >= runs) return;
    scan_run(group * run, min(count, (group + 1) * run), false, carry);
    if (gl_LocalInvocationIndex == 0) sums[group] = carry;
  } else if (stage == 1) {
    for (uint first = 0; first < runs; first += run) scan_run(first, min(runs, first + run), true, carry);
    if (gl_LocalInvocationIndex == 0) sums[runs] = carry;
  } else {
    uint first = group * run;
    for (uint at = first + gl_LocalInvocationIndex; at < min(count, first + run); at += 256) numbers[at] += sums[group];
  }
}
