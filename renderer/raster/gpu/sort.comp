#version 450 core
// Sorts the entries of a tile, nearest first, and entries with equal keys by their knots. Sorts runs in shared memory
// (Batcher 1968), then merges them: each entry moves to its own position plus the number of entries before it in the
// other run.
layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer TileEntries { uint tile_entries[]; };
layout(std430, binding = 1) coherent buffer Entries { uvec2 entries[]; };
layout(std430, binding = 2) coherent buffer Others { uvec2 others[]; };  // scratch memory
uniform uint entry_capacity;

const uint run = 2048;
shared uvec2 sorting[run];

bool before(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

void order_pair(uint low, uint high, bool up) {
  uvec2 a = sorting[low], b = sorting[high];
  if (before(b, a) != up) return;
  sorting[low] = b;
  sorting[high] = a;
}

void sort_run(uint first, uint count) {
  uint size = 2;
  while (size < count) size *= 2;
  for (uint i = gl_LocalInvocationIndex; i < size; i += 256)
    sorting[i] = i < count ? entries[first + i] : uvec2(0xffffffffu);
  barrier();
  for (uint span = 2; span <= size; span *= 2) {
    for (uint step = span / 2; step > 0; step /= 2) {
      for (uint i = gl_LocalInvocationIndex; i < size / 2; i += 256) {
        uint low = 2 * i - i % step;
        order_pair(low, low + step, (low & span) == 0);
      }
      barrier();
    }
  }
  for (uint i = gl_LocalInvocationIndex; i < count; i += 256) entries[first + i] = sorting[i];
  barrier();
}

// Returns how many of the sorted entries from `first` to `end` come before an entry.
uint count_before(uint first, uint end, uvec2 entry, bool in_others) {
  uint low = first, length = end - first;
  for (int bits = 0; bits < 32; ++bits) {
    if (length == 0) break;
    uint middle = low + length / 2;
    bool is_before = before(in_others ? others[middle] : entries[middle], entry);
    low = is_before ? middle + 1 : low;
    length = is_before ? length - length / 2 - 1 : length / 2;
  }
  return low - first;
}

// Merges runs of `size` entries into runs of twice as many, which it writes to the other buffer.
void merge_runs(uint first, uint end, uint size, bool in_others) {
  for (uint i = first + gl_LocalInvocationIndex; i < end; i += 256) {
    uint own = (i - first) / size, pair = first + own / 2 * 2 * size, other = first + (own ^ 1u) * size;
    uvec2 entry = in_others ? others[i] : entries[i];
    uint index = pair + (i - first) % size + count_before(min(other, end), min(other + size, end), entry, in_others);
    if (in_others) entries[index] = entry;
    else others[index] = entry;
  }
  memoryBarrierBuffer();
  barrier();
}

void main() {
  uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  uint first = tile_entries[tile], end = tile_entries[tile + 1];
  if (end <= first || end > entry_capacity) return;
  for (uint at = first; at < end; at += run) sort_run(at, min(run, end - at));
  memoryBarrierBuffer();
  barrier();
  bool in_others = false;
  for (uint size = run; size < end - first; size *= 2) {
    merge_runs(first, end, size, in_others);
    in_others = !in_others;
  }
  if (!in_others) return;
  for (uint i = first + gl_LocalInvocationIndex; i < end; i += 256) entries[i] = others[i];
}
