#include "renderer/raster/model_copy.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace pelage {

namespace {

template <class T>
std::vector<T> copied(std::span<const T> from) {
  return {from.begin(), from.end()};
}

/// Copies the dirty ranges of a field, or all of it if its size has changed. Returns the bytes that were written.
template <class T>
std::size_t take(std::span<const T> from, std::span<const DirtyRange> dirty, std::vector<T>& to) {
  if (from.size() != to.size()) {
    to.assign(from.begin(), from.end());
    return to.size() * sizeof(T);
  }
  if (from.empty()) return 0;
  std::size_t count = 0;
  for (const DirtyRange& range : dirty) {
    std::copy(from.begin() + range.begin, from.begin() + range.end, to.begin() + range.begin);
    count += range.end - range.begin;
  }
  return count * sizeof(T);
}

template <class... T>
std::size_t bytes_of(const std::vector<T>&... arrays) {
  return (0 + ... + (arrays.capacity() * sizeof(T)));
}

}  // namespace

ModelCopy::ModelCopy(const FurModel& model, EachCoat<FurFields> fields)
    : positions_(copied(model.positions)),
      normals_(copied(model.normals)),
      tangents_(copied(model.tangents)),
      rest_positions_(copied(model.rest_positions)),
      rest_normals_(copied(model.rest_normals)),
      triangles_(copied(model.triangles)),
      corners_(copied(model.corners)) {
  for (const ImageView& image : model.images) {
    pixels_.push_back(copied(image.rgba));
    images_.push_back({image.width, image.height, pixels_.back()});
  }
  model_ = {model.id, positions_,        normals_,       tangents_,       triangles_,   corners_,
            images_,  model.has_colours, model.original, rest_positions_, rest_normals_};
  update(fields);
}

std::size_t ModelCopy::CoatCopy::update(const FurFields& fields, std::span<const DirtyRange> dirty) {
  const FurPaint& from = fields.paint;
  std::size_t bytes = take(fields.direction, dirty, direction) + take(fields.length, dirty, length);
  bytes += take(fields.still, dirty, still);
  bytes += take(from.density, dirty, density) + take(from.width, dirty, width);
  bytes += take(from.curl, dirty, curl) + take(from.clump, dirty, clump);
  bytes += take(from.wetness, dirty, wetness) + take(from.bare, dirty, bare);
  bytes += take(from.mask, dirty, mask);
  bytes += take(from.root_colour, dirty, root_colour);
  bytes += take(from.tip_colour, dirty, tip_colour);
  return bytes;
}

std::size_t ModelCopy::CoatCopy::bytes() const {
  return bytes_of(direction, still, length, density, width, curl, clump, wetness, bare, mask, root_colour, tip_colour);
}

std::size_t ModelCopy::update(EachCoat<FurFields> fields) {
  assert(!fields.empty());
  const DirtyRange all{0, static_cast<std::uint32_t>(positions_.size())};
  const bool changed = fields.size() != coats_.size();
  std::size_t bytes = 0;
  coats_.resize(fields.size());
  for (std::size_t c = 0; c < fields.size(); ++c) {
    assert(fields[c].length.size() == positions_.size());
    CoatCopy& copy = coats_[c];
    const bool other = copy.id != fields[c].coat || copy.length.empty();
    if (other) copy = {}, copy.id = fields[c].coat;
    bytes += copy.update(fields[c], other ? std::span(&all, 1) : fields[c].dirty);
  }
  const std::span<const FurSkinRegion> skin = fields.front().skin;
  const bool other_skin = !std::equal(skin.begin(), skin.end(), skin_.begin(), skin_.end());
  if (other_skin) skin_.assign(skin.begin(), skin.end());
  if (bytes > 0 || other_skin || changed) ++changes_;
  return bytes;
}

std::vector<FurFields> ModelCopy::fields() const {
  std::vector<FurFields> all;
  for (const CoatCopy& copy : coats_) {
    FurFields& fields = all.emplace_back(FurFields{copy.direction, copy.length, {}, skin_, {}});
    fields.paint = {copy.density, copy.width, copy.curl,        copy.clump,     copy.wetness,
                    copy.bare,    copy.mask,  copy.root_colour, copy.tip_colour};
    fields.still = copy.still, fields.coat = copy.id;
  }
  return all;
}

std::size_t ModelCopy::bytes() const {
  std::size_t bytes =
      bytes_of(positions_, normals_, tangents_, rest_positions_, rest_normals_, triangles_, corners_, skin_);
  for (const auto& pixels : pixels_) bytes += pixels.capacity();
  for (const CoatCopy& copy : coats_) bytes += copy.bytes();
  return bytes;
}

}  // namespace pelage
