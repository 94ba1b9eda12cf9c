#include "server/frames/cryptomatte.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdio>

#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::size_t layers = 3, ranks = 2 * layers;
constexpr float min_share = 1e-4f;  // minimum coverage that is written
constexpr const char* layer_name = "CryptoObject";

std::uint32_t mixed(std::uint32_t block) { return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u; }

/// Appleby 2011, MurmurHash3_x86_32.
std::uint32_t murmur3(std::string_view text) {
  std::uint32_t hash = 0;
  const std::size_t block_bytes = text.size() / 4 * 4;
  for (std::size_t at = 0; at < text.size(); at += 4) {
    std::uint32_t block = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(4, text.size() - at); ++k)
      block |= std::uint32_t{static_cast<unsigned char>(text[at + k])} << (8 * k);
    hash ^= mixed(block);
    if (at < block_bytes) hash = std::rotl(hash, 13) * 5 + 0xe6546b64u;
  }
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  return hash ^ (hash >> 16);
}

std::string hex_of(std::uint32_t bits) {
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", bits);
  return text.data();
}

using Share = std::pair<float, std::size_t>;  // coverage, and the object's number

/// Returns the coverages of a pixel's objects, highest first.
std::array<Share, max_objects> sorted_shares(std::span<const FloatImage> shares, std::size_t pixel) {
  std::array<Share, max_objects> all{};
  for (std::size_t k = 0; k < max_objects; ++k) {
    const float share = std::clamp(shares[k / 3].rgba[4 * pixel + k % 3], 0.0f, 1.0f);
    all[k] = {share >= min_share ? share : 0.0f, k};
  }
  std::ranges::stable_sort(all, std::ranges::greater(), &Share::first);
  return all;
}

}  // namespace

float matte_id(std::string_view name) {
  std::uint32_t bits = murmur3(name);
  const std::uint32_t exponent = bits >> 23 & 255;
  if (exponent == 0 || exponent == 255) bits ^= 1u << 23;
  return std::bit_cast<float>(bits);
}

Cryptomatte::Cryptomatte(const FurFrame& frame, std::span<const FloatImage> shares) {
  assert(shares.size() * 3 >= max_objects);
  const auto add = [&](const std::string& name) { objects_.emplace_back(name, matte_id(name)); };
  for (const char* name : {"skin", "eyes", "curves"}) add(name);
  for (const NamedCoat& coat : frame.coats) add("coat/" + coat.name);
  const int width = shares[0].width, height = shares[0].height;
  ranks_.assign(layers, empty_picture<FloatImage>(width, height));
  const std::size_t pixels = shares[0].rgba.size() / 4;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const std::array<Share, max_objects> sorted = sorted_shares(shares, pixel);
    for (std::size_t rank = 0; rank < ranks && sorted[rank].first > 0; ++rank) {
      float* at = &ranks_[rank / 2].rgba[4 * pixel + 2 * (rank % 2)];
      at[0] = objects_[sorted[rank].second].second, at[1] = sorted[rank].first;
    }
  }
}

std::vector<ExrPlane> Cryptomatte::planes() const {
  std::vector<ExrPlane> planes;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::string name = layer_name + ("0" + std::to_string(k));
    for (ExrPlane& plane : rgba_planes(ranks_[k].rgba, ExrSample::single, name)) planes.push_back(std::move(plane));
  }
  return planes;
}

std::vector<ImageText> Cryptomatte::texts() const {
  const std::string key = matte_text + hex_of(murmur3(layer_name)).substr(0, 7) + "/";
  std::string manifest;
  for (const auto& [name, id] : objects_)
    manifest +=
        (manifest.empty() ? "{" : ",") + json_text(name) + ":\"" + hex_of(std::bit_cast<std::uint32_t>(id)) + "\"";
  return {{key + "name", layer_name},
          {key + "hash", "MurmurHash3_32"},
          {key + "conversion", "uint32_to_float32"},
          {key + "manifest", manifest + "}"}};
}

}  // namespace pelage
