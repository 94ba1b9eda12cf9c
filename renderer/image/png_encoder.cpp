#include "renderer/image/png_encoder.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace pelage {

namespace {

std::size_t pixels_of(const PngLayout& layout) {
  return static_cast<std::size_t>(layout.width) * static_cast<std::size_t>(layout.height);
}

}  // namespace

std::string PngEncoder::encode(Image image, bool keep_alpha) {
  const auto picture = std::make_shared<Kept>();
  picture->layout = png_layout(image, keep_alpha);
  picture->image = std::move(image);
  const Pictures before = pictures_of(picture->layout);
  std::map<const Kept*, std::size_t> taken_over;
  for (int band = 0; band < png_band_count(picture->layout); ++band) {
    const auto rows = png_band_of(picture->image, band);
    const auto same = std::ranges::find_if(
        before, [&](const auto& kept) { return std::ranges::equal(png_band_of(kept->image, band), rows); });
    if (same != before.end()) ++taken_over[same->get()];
    picture->bands.push_back(same != before.end() ? (*same)->bands[static_cast<std::size_t>(band)]
                                                  : std::make_shared<const PngBand>(png_band(picture->layout, rows)));
  }
  const auto source = std::ranges::max_element(taken_over, {}, [](const auto& entry) { return entry.second; });
  keep(picture, source == taken_over.end() ? nullptr : source->first);
  return png_file(picture->layout, picture->bands, {}, PngNumbers::srgb);
}

PngEncoder::Pictures PngEncoder::pictures_of(const PngLayout& layout) const {
  const std::lock_guard lock(mutex_);
  Pictures same;
  std::ranges::copy_if(pictures_, std::back_inserter(same), [&](const auto& kept) { return kept->layout == layout; });
  return same;
}

void PngEncoder::keep(std::shared_ptr<const Kept> picture, const Kept* source) {
  const std::lock_guard lock(mutex_);
  std::erase_if(pictures_, [&](const auto& kept) { return kept.get() == source; });
  pictures_.push_front(std::move(picture));
  std::size_t pixels = 0;
  const auto first_without_room = std::ranges::find_if(
      pictures_, [&](const auto& kept) { return (pixels += pixels_of(kept->layout)) > most_pixels_; });
  pictures_.erase(first_without_room, pictures_.end());
}

}  // namespace pelage
