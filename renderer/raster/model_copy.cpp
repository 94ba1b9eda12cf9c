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

/// Takes ranges of a field over, or all of it where it has come or gone. Bytes that were written.
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

ModelCopy::ModelCopy(const FurModel& model, const FurFields& fields)
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
  direction_.resize(positions_.size()), length_.resize(positions_.size());
  const DirtyRange all{0, static_cast<std::uint32_t>(positions_.size())};
  FurFields whole = fields;
  whole.dirty = {&all, 1};
  update(whole);
}

std::size_t ModelCopy::update(const FurFields& fields) {
  assert(fields.length.size() == positions_.size());
  const FurPaint& from = fields.paint;
  std::size_t bytes = take(fields.direction, fields.dirty, direction_) + take(fields.length, fields.dirty, length_);
  bytes += take(fields.still, fields.dirty, still_);
  bytes += take(from.density, fields.dirty, paint_.density) + take(from.width, fields.dirty, paint_.width);
  bytes += take(from.curl, fields.dirty, paint_.curl) + take(from.clump, fields.dirty, paint_.clump);
  bytes += take(from.wetness, fields.dirty, paint_.wetness) + take(from.bare, fields.dirty, paint_.bare);
  bytes += take(from.mask, fields.dirty, paint_.mask);
  bytes += take(from.root_colour, fields.dirty, paint_.root_colour);
  bytes += take(from.tip_colour, fields.dirty, paint_.tip_colour);
  const bool other_skin = !std::equal(fields.skin.begin(), fields.skin.end(), skin_.begin(), skin_.end());
  if (other_skin) skin_.assign(fields.skin.begin(), fields.skin.end());
  if (bytes > 0 || other_skin) ++changes_;
  return bytes;
}

FurFields ModelCopy::fields() const {
  FurFields fields{direction_, length_, {}, skin_, {}};
  fields.paint = {paint_.density, paint_.width, paint_.curl,        paint_.clump,     paint_.wetness,
                  paint_.bare,    paint_.mask,  paint_.root_colour, paint_.tip_colour};
  fields.still = still_;
  return fields;
}

std::size_t ModelCopy::bytes() const {
  std::size_t bytes =
      bytes_of(positions_, normals_, tangents_, rest_positions_, rest_normals_, triangles_, corners_, direction_,
               still_, length_, skin_, paint_.density, paint_.width, paint_.curl, paint_.clump, paint_.wetness,
               paint_.bare, paint_.mask, paint_.root_colour, paint_.tip_colour);
  for (const auto& pixels : pixels_) bytes += pixels.capacity();
  return bytes;
}

}  // namespace pelage
