#include "server/import_worker/skeleton.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace pelage {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

BodySide side_of_word(const std::string& word) {
  if (word == "l" || word == "left") return BodySide::left;
  return word == "r" || word == "right" ? BodySide::right : BodySide::none;
}

glm::dvec3 direction_of(Axis axis) {
  glm::dvec3 direction(0);
  const int index = static_cast<int>(axis);
  direction[index / 2] = index % 2 == 0 ? 1 : -1;
  return direction;
}

/// Returns the axis that the vector is close to; none if the angle to every axis is too large.
std::optional<Axis> nearest_axis(glm::dvec3 vector) {
  constexpr double clearly = 0.8;  // cosine
  const double length = glm::length(vector);
  for (int index = 0; index < 6; ++index) {
    if (glm::dot(vector, direction_of(static_cast<Axis>(index))) > clearly * length) return static_cast<Axis>(index);
  }
  return {};
}

std::set<std::string> joints_of(const aiScene& scene) {
  std::set<std::string> joints;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[m];
    for (unsigned b = 0; b < mesh.mNumBones; ++b) joints.insert(mesh.mBones[b]->mName.C_Str());
  }
  return joints;
}

}  // namespace

BodySide side_of_joint(const std::string& name) {
  std::string word;
  for (std::size_t i = 0; i <= name.size(); ++i) {
    const char c = i < name.size() ? name[i] : ' ';
    const bool next_is_small = i + 1 < name.size() && is_letter(name[i + 1]) && !is_capital(name[i + 1]);
    const bool begins = is_capital(c) && (word.empty() || !is_capital(name[i - 1]) || next_is_small);
    if (!is_letter(c) || begins) {
      if (const BodySide side = side_of_word(word); side != BodySide::none) return side;
      word.clear();
    }
    if (is_letter(c)) word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return BodySide::none;
}

std::optional<Axis> front_by_joints(const aiScene& scene, const NodeTransforms& transforms, Axis up) {
  glm::dvec3 sums[2] = {glm::dvec3(0), glm::dvec3(0)};
  double counts[2] = {0, 0};
  for (const std::string& joint : joints_of(scene)) {
    const BodySide side = side_of_joint(joint);
    const glm::dmat4* transform = transforms.of(joint);
    if (side == BodySide::none || !transform) continue;
    const int s = side == BodySide::left ? 0 : 1;
    sums[s] += glm::dvec3((*transform)[3]), counts[s] += 1;
  }
  if (counts[0] == 0 || counts[1] == 0) return {};
  const glm::dvec3 left = sums[0] / counts[0] - sums[1] / counts[1], upward = direction_of(up);
  const glm::dvec3 across = left - glm::dot(left, upward) * upward;
  if (!is_finite(across) || !(glm::length(across) > 0.5 * glm::length(left))) return {};
  return nearest_axis(glm::cross(across, upward));
}

}  // namespace pelage
