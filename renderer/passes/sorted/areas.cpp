#include "renderer/passes/sorted/areas.h"

#include <cassert>

namespace pelage {

std::vector<Area> halves(const Area& area) {
  assert(area.pixels() >= 2);
  Area first = area, second = area;
  if (area.width >= area.height) {
    first.width = area.width / 2;
    second.left += first.width, second.width -= first.width;
  } else {
    first.height = area.height / 2;
    second.top += first.height, second.height -= first.height;
  }
  return {first, second};
}

std::vector<Area> cut(const Area& area, double most) {
  std::vector<Area> done, open{area};
  while (!open.empty()) {
    const Area next = open.back();
    open.pop_back();
    if (next.pixels() <= most || next.pixels() < 2) {
      done.push_back(next);
      continue;
    }
    for (const Area& half : halves(next)) open.push_back(half);
  }
  return done;
}

}  // namespace pelage
