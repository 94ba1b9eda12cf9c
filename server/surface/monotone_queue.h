// The queue of searches that take the nearest place first.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pelage {

/// Gives vertices by rising distance, and of equally far ones by rising number: the order of a binary heap. It relies
/// on nothing being added nearer than what was taken last, or much farther. Distances lie in bands; those of later
/// bands wait unsorted (Dial 1969), so that the heap of the present band stays small.
class MonotoneQueue {
 public:
  using Place = std::pair<double, std::uint32_t>;

  /// Bands are `width` wide, above 0. What is added lies at most `reach` beyond what was taken last, but for the first.
  MonotoneQueue(double width, double reach)
      : width_(width), bands_(static_cast<std::size_t>(std::ceil(reach / width)) + 3) {}

  bool empty() const { return count_ == 0; }

  void push(double distance, std::uint32_t vertex) {
    const auto band = static_cast<std::uint64_t>(distance / width_);
    if (count_++ == 0) band_ = band;
    assert(band < band_ + bands_.size());
    if (band > band_) {
      bands_[band % bands_.size()].emplace_back(distance, vertex);
      return;
    }
    near_.emplace_back(distance, vertex);
    std::push_heap(near_.begin(), near_.end(), std::greater<>());
  }

  /// The least distance in it; infinite when it is empty.
  double least() {
    if (empty()) return std::numeric_limits<double>::infinity();
    while (near_.empty()) {
      near_.swap(bands_[++band_ % bands_.size()]);
      std::make_heap(near_.begin(), near_.end(), std::greater<>());
    }
    return near_.front().first;
  }

  /// Takes the nearest out. There must be one.
  Place pop() {
    least();
    std::pop_heap(near_.begin(), near_.end(), std::greater<>());
    const Place place = near_.back();
    near_.pop_back();
    --count_;
    return place;
  }

 private:
  double width_;
  std::vector<std::vector<Place>> bands_;  // by their number modulo their count
  std::vector<Place> near_;                // a heap of the band `band_` and those before it
  std::uint64_t band_ = 0;
  std::size_t count_ = 0;
};

}  // namespace pelage
