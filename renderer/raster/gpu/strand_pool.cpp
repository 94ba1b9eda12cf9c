#include "renderer/raster/gpu/strand_pool.h"

#include <algorithm>
#include <cstring>

namespace pelage {

namespace {

std::size_t words_of(const StrandSet& set) {
  return set.colours.size() + set.count() + set.count() * (sizeof(StrandRoot) / sizeof(std::uint32_t)) +
         set.to_mean.size();
}

/// Returns `count` with room for what strokes may add.
std::size_t with_room(std::size_t count) { return count + count / 8 + 16; }

}  // namespace

std::size_t StrandPool::bytes_for(std::span<const GrownPart> parts) {
  std::size_t points = 0, words = 0;
  for (const GrownPart& part : parts)
    points += with_room(part.strands->points.size()), words += with_room(words_of(*part.strands));
  return std::max(points * sizeof(StrandPoint), words * sizeof(std::uint32_t));
}

bool StrandPool::update(std::span<const GrownPart> parts) {
  const auto fits = [&](std::size_t i) {
    return parts[i].strands->points.size() <= ranges_[i].point_capacity &&
           words_of(*parts[i].strands) <= ranges_[i].word_capacity;
  };
  bool fits_all = ranges_.size() == parts.size();
  for (std::size_t i = 0; i < parts.size() && fits_all; ++i) fits_all = fits(i);
  if (!fits_all) divide(parts);
  bool sent = false;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (ranges_[i].strands.lock() != parts[i].strands) send(parts[i], ranges_[i]), sent = true;
  return sent;
}

void StrandPool::divide(std::span<const GrownPart> parts) {
  std::size_t points = 0, words = 0;
  ranges_.assign(parts.size(), {});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Range& range = ranges_[i];
    range.at = {static_cast<std::uint32_t>(points), static_cast<std::uint32_t>(words)};
    range.point_capacity = with_room(parts[i].strands->points.size());
    range.word_capacity = with_room(words_of(*parts[i].strands));
    points += range.point_capacity, words += range.word_capacity;
  }
  points_.reserve(std::max<std::size_t>(points, 1) * sizeof(StrandPoint));
  words_.reserve(std::max<std::size_t>(words, 1) * sizeof(std::uint32_t));
}

void StrandPool::send(const GrownPart& part, Range& range) {
  const StrandSet& set = *part.strands;
  std::vector<std::uint32_t> words(words_of(set));
  std::uint32_t* to = words.data();
  const auto append = [&](const auto& values) {
    const std::size_t bytes = values.size() * sizeof(values[0]);
    if (bytes > 0) std::memcpy(to, values.data(), bytes);
    to += bytes / sizeof(std::uint32_t);
  };
  append(set.colours), append(set.neighbour);
  to = &words[set.colours.size() + set.count()];  // skip the neighbours, which curves do not have
  append(set.roots), append(set.to_mean);
  points_.send_at(range.at.points * sizeof(StrandPoint), std::span<const StrandPoint>(set.points));
  words_.send_at(range.at.words * sizeof(std::uint32_t), std::span<const std::uint32_t>(words));
  range.strands = part.strands;
}

}  // namespace pelage
