#include "server/history/refinement_codec.h"

#include <bit>
#include <cstring>

namespace pelage {

namespace {

static_assert(std::endian::native == std::endian::little);

void put_word(std::string& text, std::uint32_t word) { text.append(reinterpret_cast<const char*>(&word), sizeof word); }

/// The next run of a refinement; false when it could not follow the one before.
bool take_run(std::span<const std::uint32_t> words, ChosenTriangles& runs) {
  const TriangleRun run{words[0], words[1]};
  if (run.begin >= run.end || (!runs.empty() && run.begin <= runs.back().end)) return false;
  runs.push_back(run);
  return true;
}

}  // namespace

std::string encode_refinements(const std::vector<ChosenTriangles>& refinements) {
  std::string text;
  for (const ChosenTriangles& runs : refinements) {
    put_word(text, static_cast<std::uint32_t>(runs.size()));
    for (const TriangleRun run : runs) put_word(text, run.begin), put_word(text, run.end);
  }
  return text;
}

Result<std::vector<ChosenTriangles>> decode_refinements(std::span<const std::byte> bytes) {
  const auto damaged = [] { return failure(Code::internal, "the stored refinements of a model are damaged"); };
  if (bytes.size() % sizeof(std::uint32_t) != 0) return damaged();
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  std::vector<ChosenTriangles> refinements;
  std::span<const std::uint32_t> left(words);
  while (!left.empty()) {
    const std::size_t runs = left[0];
    left = left.subspan(1);
    if (left.size() / 2 < runs) return damaged();
    ChosenTriangles& chosen = refinements.emplace_back();
    for (std::size_t i = 0; i < runs; ++i, left = left.subspan(2)) {
      if (!take_run(left, chosen)) return damaged();
    }
  }
  return refinements;
}

}  // namespace pelage
