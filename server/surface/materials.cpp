#include "server/surface/materials.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>

#include "base/limits.h"

namespace pelage {

namespace {

constexpr std::array<std::string_view, 30> bare_words = {
    "eye",    "eyes", "eyeball", "eyeballs", "cornea", "iris", "sclera", "pupil",  "pupils",  "tooth",
    "teeth",  "fang", "fangs",   "tusk",     "tusks",  "claw", "claws",  "nail",   "nails",   "talon",
    "talons", "beak", "hoof",    "hooves",   "hoofs",  "horn", "horns",  "antler", "antlers", "tongue"};
/// Words that denote furred parts after a bare word, as in "eye brow".
constexpr std::array<std::string_view, 6> furred_after_eye = {"brow", "brows", "lash", "lashes", "lid", "lids"};

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }

/// Splits a name into words, in lower case.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool inside = false;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (!is_letter(name[k])) {
      inside = false;
      continue;
    }
    const bool begins = !inside || (is_capital(name[k]) && !is_capital(name[k - 1]));
    if (begins) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[k])));
    inside = true;
  }
  return words;
}

}  // namespace

bool names_bare_part(std::string_view name) {
  const std::vector<std::string> words = words_of(name);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool furred = k + 1 < words.size() && is_one_of(furred_after_eye, words[k + 1]);
    if (is_one_of(bare_words, words[k]) && !furred) return true;
  }
  return false;
}

void name_materials(const RawModel& raw, const Soup& soup, Mesh& mesh) {
  if (raw.face_material.empty()) return;
  std::vector<MaterialReport>& named = mesh.report.materials;
  std::map<std::string_view, std::uint16_t> numbers;
  mesh.materials.assign(soup.triangles.size(), no_material);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const std::string& name = raw.materials[raw.face_material[soup.faces[t]]].name;
    if (name.empty()) continue;
    auto number = numbers.find(name);
    if (number == numbers.end()) {
      if (named.size() == limits::named_materials) continue;
      number = numbers.emplace(name, static_cast<std::uint16_t>(named.size())).first;
      named.push_back({name, 0, names_bare_part(name)});
    }
    mesh.materials[t] = number->second;
    ++named[number->second].triangles;
  }
  std::size_t bare = 0;
  for (const MaterialReport& material : named) bare += material.bare ? material.triangles : 0;
  if (bare == soup.triangles.size())
    for (MaterialReport& material : named) material.bare = false;
  if (named.empty()) mesh.materials.clear();
}

std::vector<bool> bare_vertices(const Mesh& mesh, const std::vector<MaterialReport>& known) {
  std::vector<bool> bare(mesh.positions.size(), !mesh.materials.empty());
  std::vector<bool> counts;
  for (const MaterialReport& material : mesh.report.materials) {
    const auto same_name = [&](const MaterialReport& other) { return other.name == material.name; };
    counts.push_back(material.bare && std::none_of(known.begin(), known.end(), same_name));
  }
  for (std::size_t t = 0; t < mesh.materials.size(); ++t) {
    const std::uint16_t material = mesh.materials[t];
    if (material != no_material && counts[material]) continue;
    for (int k = 0; k < 3; ++k) bare[mesh.triangles[t][k]] = false;
  }
  return bare;
}

}  // namespace pelage
