#version 450 core
// One round of natural merge sort (Knuth 5.2.4) over the list of each pixel: merges runs that are in order two by two. A
// fragment's depth is near / distance, so that the nearest one has the largest bits. It is a single loop of at most two
// and a half steps for each fragment, because the steps of one draw are bounded (max_steps).
#include "fragment_lists.glsl"

void main() {
  int pixel = pixel_of_list();
  uint first = lists.firsts[pixel];
  if (first == 0u || (first & in_order) != 0u) return;

  uint head = 0u, last = 0u;               // first and last fragment of the list that this round writes
  uint a = first, b = 0u, tail = 0u;       // the next fragments of the two runs, and of what follows them
  uvec2 at_a = links[a - 1u], at_b = uvec2(0u);
  uint scan = a;                           // searches for the end of the first run
  uvec2 at_scan = at_a;
  bool merging = false;
  uint rounds = 0u, step = 0u;
  for (; step < max_steps; ++step) {
    if (!merging) {
      uvec2 after = at_scan.y != 0u ? links[at_scan.y - 1u] : uvec2(0u);
      if (at_scan.y != 0u && at_scan.x >= after.x) {
        scan = at_scan.y, at_scan = after;
        continue;
      }
      ++rounds;
      if (rounds == 1u && at_scan.y == 0u) {
        lists.firsts[pixel] = first | in_order;
        return;
      }
      b = at_scan.y, at_b = after, tail = 0u;
      links[scan - 1u].y = 0u;
      if (scan == a) at_a.y = 0u;
      merging = true;
    }
    bool from_a = b == 0u || (a != 0u && at_a.x >= at_b.x);
    uint taken = from_a ? a : b;
    if (last == 0u) head = taken;
    else links[last - 1u].y = taken;
    last = taken;
    if (from_a) {
      a = at_a.y;
      if (a != 0u) at_a = links[a - 1u];
    } else {
      uint depth = at_b.x;
      b = at_b.y;
      if (b != 0u) {
        at_b = links[b - 1u];
        if (at_b.x > depth) tail = b, b = 0u;  // the second run ends
      }
    }
    if (a != 0u || b != 0u) continue;
    if (tail == 0u) break;
    a = scan = tail;
    at_a = at_scan = links[a - 1u];
    merging = false;
  }
  if (step == max_steps) {
    atomicOr(lists.too_long, 1u);
    return;
  }
  links[last - 1u].y = 0u;
  lists.firsts[pixel] = rounds == 1u ? head | in_order : head;
  if (rounds > 1u) atomicOr(lists.unsorted, 1u);
}
