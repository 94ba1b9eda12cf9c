#include "server/import_worker/animation.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "server/import_worker/parse.h"

namespace pelage {

namespace {

/// The indices of the keys before and after a time, and the share of the time between them that has passed, [0, 1].
struct Between {
  unsigned first = 0, second = 0;
  double share = 0;
};

template <class Key>
Between between(const Key* keys, unsigned count, double time) {
  const Key* end = keys + count;
  const Key* after = std::upper_bound(keys, end, time, [](double t, const Key& key) { return t < key.mTime; });
  if (after == keys) return {0, 0, 0};
  const auto second = static_cast<unsigned>(after - keys);
  if (after == end) return {count - 1, count - 1, 0};
  const double from = keys[second - 1].mTime, to = after->mTime;
  return {second - 1, second, to > from ? (time - from) / (to - from) : 0};
}

/// Returns the vector at a time; `rest` if there are no keys.
aiVector3D vector_at(const aiVectorKey* keys, unsigned count, double time, const aiVector3D& rest) {
  if (count == 0) return rest;
  const Between at = between(keys, count, time);
  const aiVector3D &a = keys[at.first].mValue, &b = keys[at.second].mValue;
  return a + (b - a) * static_cast<ai_real>(at.share);
}

aiQuaternion turn_at(const aiQuatKey* keys, unsigned count, double time, const aiQuaternion& rest) {
  if (count == 0) return rest;
  const Between at = between(keys, count, time);
  aiQuaternion turn;
  aiQuaternion::Interpolate(turn, keys[at.first].mValue, keys[at.second].mValue, static_cast<ai_real>(at.share));
  return turn.Normalize();
}

void move_node(aiScene& scene, const aiNodeAnim& channel, double time) {
  aiNode* node = scene.mRootNode->FindNode(channel.mNodeName);
  if (!node) return;
  aiVector3D scale, translation;
  aiQuaternion turn;
  node->mTransformation.Decompose(scale, turn, translation);
  node->mTransformation = aiMatrix4x4(vector_at(channel.mScalingKeys, channel.mNumScalingKeys, time, scale),
                                      turn_at(channel.mRotationKeys, channel.mNumRotationKeys, time, turn),
                                      vector_at(channel.mPositionKeys, channel.mNumPositionKeys, time, translation));
}

double weight_of(const aiMeshMorphKey& key, unsigned target) {
  double weight = 0;
  for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
    if (key.mValues[i] == target) weight += key.mWeights[i];
  return weight;
}

void move_targets(aiScene& scene, const aiMeshMorphAnim& channel, double time) {
  const aiNode* node = scene.mRootNode->FindNode(channel.mName);
  if (!node || channel.mNumKeys == 0) return;
  const Between at = between(channel.mKeys, channel.mNumKeys, time);
  for (unsigned i = 0; i < node->mNumMeshes; ++i) {
    if (node->mMeshes[i] >= scene.mNumMeshes) continue;
    aiMesh& mesh = *scene.mMeshes[node->mMeshes[i]];
    for (unsigned target = 0; target < mesh.mNumAnimMeshes; ++target) {
      const double a = weight_of(channel.mKeys[at.first], target), b = weight_of(channel.mKeys[at.second], target);
      mesh.mAnimMeshes[target]->mWeight = static_cast<float>(a + at.share * (b - a));
    }
  }
}

Status no_animation(const aiScene& scene, const std::string& name) {
  const std::vector<std::string> names = animation_names(scene);
  if (names.empty()) return broken("it has no animation, so that it has no pose; load it without one.");
  std::string all;
  for (const std::string& known : names) all += (all.empty() ? "\"" : ", \"") + known + "\"";
  return broken("it has no animation \"" + name + "\"; it has " + all + ".");
}

}  // namespace

std::vector<std::string> animation_names(const aiScene& scene) {
  std::vector<std::string> names;
  for (unsigned i = 0; i < scene.mNumAnimations; ++i) {
    const std::string name = scene.mAnimations[i]->mName.C_Str();
    names.push_back(name.empty() ? std::to_string(i + 1) : name);
  }
  return names;
}

Status apply_pose(aiScene& scene, const std::string& pose) {
  const std::size_t at = pose.rfind('@');
  const std::string name = pose.substr(0, at);
  const std::optional<double> seconds = at == std::string::npos ? 0 : to_number(std::string_view(pose).substr(at + 1));
  if (!seconds || !(*seconds >= 0) || !std::isfinite(*seconds))
    return broken("the seconds of the pose \"" + pose + "\" are no number of 0 or more; write NAME@SECONDS.");
  const std::vector<std::string> names = animation_names(scene);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return no_animation(scene, name);
  const aiAnimation& animation = *scene.mAnimations[found - names.begin()];
  const double time = *seconds * (animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 1);
  for (unsigned i = 0; i < animation.mNumChannels; ++i) move_node(scene, *animation.mChannels[i], time);
  for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i)
    move_targets(scene, *animation.mMorphMeshChannels[i], time);
  return {};
}

}  // namespace pelage
