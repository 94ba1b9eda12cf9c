#include "renderer/marched/crossings.h"

#include <algorithm>

namespace pelage {

void EyePixels::begin(const SkinPixels& skin) {
  if (there) return;
  there = true, inverse = skin.inverse;
  number.fill(-1);
}

void CurvePixels::sort() {
  std::stable_sort(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) {
    return a.number != b.number ? a.number < b.number : a.inverse > b.inverse;
  });
  first.fill(0);
  for (const Pixel& pixel : pixels) ++first[static_cast<std::size_t>(pixel.number) + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
}

void TileScratch::clear() {
  skin.inverse.fill(0), skin.piece.fill(0);
  eyes.there = false;
  records.clear(), values.clear();
  first.fill(0), last.fill(0);
}

float* TileScratch::add(const Record& record, int group, int numbers) {
  const auto at = static_cast<std::size_t>(group), begin = values.size();
  records.push_back(record);
  const auto number = static_cast<std::uint32_t>(records.size());
  (last[at] ? records[last[at] - 1].next : first[at]) = number;
  last[at] = number;
  values.resize(begin + static_cast<std::size_t>(numbers));
  return &values[begin];
}

void sort_by_depth(std::vector<Crossing>& crossings) {
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const Crossing crossing = crossings[i];
    std::size_t at = i;
    for (; at > 0 && crossings[at - 1].inverse < crossing.inverse; --at) crossings[at] = crossings[at - 1];
    crossings[at] = crossing;
  }
}

namespace {

/// Whether a ray that has met `near` is still in the fur when it meets `far`: going in, it meets nothing higher before;
/// coming out, nothing lower.
bool joined(const Record& near, const Record& far) {
  if (near.facing) return far.facing ? far.height < near.height : far.height <= near.height;
  return !near.outermost && (far.facing ? far.height >= near.height : far.height > near.height);
}

}  // namespace

void find_segments(std::span<const Crossing> crossings, std::span<const Record> records, float reach,
                   std::vector<Segment>& segments) {
  constexpr std::size_t max_open = 8;
  std::array<const Crossing*, max_open> open{};  // from which a ray goes on in fur; the oldest ones are lost
  std::size_t count = 0;
  for (const Crossing& crossing : crossings) {
    const Record& record = records[crossing.record];
    std::size_t found = count;
    float least = reach * reach;
    for (std::size_t i = 0; i < count; ++i) {
      const Record& before = records[open[i]->record];
      const glm::vec2 apart = open[i]->tile - crossing.tile;
      const float square = glm::dot(apart, apart);
      if (before.patch == record.patch && square <= least && joined(before, record)) found = i, least = square;
    }
    if (found < count) segments.push_back({open[found]->record, crossing.record});
    const bool leaves = !record.facing && record.outermost;
    if (found < count && leaves) open[found] = open[--count];
    if (leaves) continue;
    if (found == count) found = count < max_open ? count++ : max_open - 1;
    open[found] = &crossing;
  }
}

}  // namespace pelage
