#include "server/scene/snapshot.h"

namespace pelage {

RecentChanges RecentChanges::with(std::vector<VertexRange> touched) const {
  RecentChanges more = *this;
  ++more.number_;
  if (more.known_.size() == max_known) more.known_.erase(more.known_.begin());
  more.known_.push_back(std::make_shared<const std::vector<VertexRange>>(std::move(touched)));
  return more;
}

std::optional<std::vector<VertexRange>> RecentChanges::since(std::uint64_t number) const {
  if (number > number_ || number_ - number > known_.size()) return {};
  std::vector<VertexRange> touched;
  for (auto change = known_.end() - static_cast<std::ptrdiff_t>(number_ - number); change != known_.end(); ++change)
    touched.insert(touched.end(), (*change)->begin(), (*change)->end());
  return merge_ranges(std::move(touched));
}

SceneView SceneSnapshot::view(bool masked) const {
  if (!pose) return {*model, *fields, *settings, revision, skin_texture.get(), copy_id, nullptr, masked};
  const BodySwing* swing = pose->swing ? &*pose->swing : nullptr;
  return {*pose->model, *fields, pose->settings, revision, skin_texture.get(), pose->model->id, swing, masked};
}

std::size_t SceneSnapshot::bytes() const {
  return sizeof(SceneSnapshot) + fields->bytes() + (skin_texture ? skin_texture->rgba.capacity() : 0);
}

}  // namespace pelage
