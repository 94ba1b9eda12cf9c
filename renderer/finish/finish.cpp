#include "renderer/finish/finish.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "renderer/finish/resize.h"

namespace pelage {

Encoding encoding_of(const FurFrame& frame, std::int32_t largest) {
  Encoding encoding;
  encoding.exposure = static_cast<float>(std::exp2(frame.exposure));
  encoding.filmic = frame.tone_map == ToneMap::filmic;
  encoding.transparent = frame.background == Background::transparent;
  encoding.studio = frame.background == Background::studio;
  encoding.background = frame.background_colour;
  encoding.width = frame.width, encoding.height = frame.height, encoding.largest = largest;
  return encoding;
}

namespace {

template <class Picture>
void finish_into(const FurFrame& frame, const FinishInput& input, int top, int bottom, Picture& picture) {
  using Number = typename decltype(Picture::rgba)::value_type;
  assert(input.light.width > 0 && input.light.height > 0 && 0 <= top && top <= bottom && bottom <= frame.height);
  constexpr int rows_together = 8;
  const Encoding encoding = encoding_of(frame, std::numeric_limits<Number>::max());
  const ResizedLight resized(input.light, frame.width, frame.height);
  const auto row_numbers = 4 * static_cast<std::size_t>(frame.width);
  const auto finish_run = [&](std::uint32_t run) {
    std::vector<float> row(row_numbers + 4 * encode_batch), over(input.overlay ? row.size() : 0);
    std::vector<std::int32_t> numbers(row.size());
    const int begin = top + static_cast<int>(run) * rows_together, end = std::min(bottom, begin + rows_together);
    for (int y = begin; y < end; ++y) {
      const std::size_t first = static_cast<std::size_t>(y) * row_numbers;
      resized.row(y, row.data());
      if (input.overlay) std::copy_n(&input.overlay->rgba[first], row_numbers, over.begin());
      encode_row(encoding, y, row.data(), input.overlay ? over.data() : nullptr, numbers.data());
      std::transform(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(row_numbers),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(first),
                     [](std::int32_t number) { return static_cast<Number>(number); });
    }
  };
  for_each_in_parallel(static_cast<std::uint32_t>((bottom - top + rows_together - 1) / rows_together), finish_run,
                       input.threads);
}

template <class Picture>
Picture finished(const FurFrame& frame, const FinishInput& input) {
  auto picture = empty_picture<Picture>(frame.width, frame.height);
  const int top = frame.crop ? frame.crop->top : 0, rows = frame.crop ? frame.crop->height : frame.height;
  finish_into(frame, input, top, top + rows, picture);
  return picture;
}

}  // namespace

Image finish_picture(const FurFrame& frame, const FinishInput& input) { return finished<Image>(frame, input); }

Image16 finish_picture_deep(const FurFrame& frame, const FinishInput& input) { return finished<Image16>(frame, input); }

void finish_rows(const FurFrame& frame, const FinishInput& input, int top, int bottom, Image& picture) {
  finish_into(frame, input, top, bottom, picture);
}

}  // namespace pelage
