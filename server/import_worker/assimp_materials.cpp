#include "server/import_worker/assimp_materials.h"

#include <limits>
#include <string_view>

#include "renderer/image/image.h"
#include "server/import_worker/parse.h"
#include "server/import_worker/read_picture.h"

namespace pelage {

namespace {

constexpr std::size_t max_texture_pixels = std::size_t{8192} * 8192;

struct Texture {
  aiString path;
  unsigned uv_channel = 0;
};

bool find_texture(const aiMaterial& material, Texture& texture) {
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    if (material.GetTexture(type, 0, &texture.path, nullptr, &texture.uv_channel) == aiReturn_SUCCESS) return true;
  }
  return false;
}

/// glTF has linear factors; 3DS has colours as they were on the screen.
glm::vec3 base_colour(const aiMaterial& material, ModelFormat format) {
  aiColor4D colour(1, 1, 1, 1);
  if (format == ModelFormat::tds) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    const bool is_default = std::string_view(name.C_Str()).starts_with("%%%DEFAULT");  // assimp's own grey
    if (is_default || material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return glm::vec3(1);
    return srgb_to_linear({colour.r, colour.g, colour.b});
  }
  if (material.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  return {colour.r, colour.g, colour.b};
}

}  // namespace

Result<MaterialReader::Entry> MaterialReader::read(unsigned index) {
  if (const auto known = materials_.find(index); known != materials_.end()) return known->second;
  if (model_.materials.size() > std::numeric_limits<std::uint16_t>::max()) return broken("it has too many materials.");
  Entry entry{static_cast<std::uint16_t>(model_.materials.size()), 0};
  RawMaterial material;
  if (index < scene_.mNumMaterials) {
    const aiMaterial& source = *scene_.mMaterials[index];
    Texture texture;
    material.base_colour = base_colour(source, format_);
    if (find_texture(source, texture)) {
      const Result<int> image = read_image(texture.path.C_Str());
      if (!image.ok()) return image.status();
      material.image = *image;
      entry.uv_channel = texture.uv_channel;
    }
  }
  model_.materials.push_back(material);
  return materials_.emplace(index, entry).first->second;
}

/// -1 for a picture in another file: 3DS names it, nobody has it.
Result<int> MaterialReader::read_image(const char* path) {
  const aiTexture* texture = scene_.GetEmbeddedTexture(path);
  if (!texture) return -1;
  if (const auto known = images_.find(texture); known != images_.end()) return known->second;
  if (texture->mHeight != 0) return broken("a picture inside it is stored in an unknown way.");
  const std::span bytes(reinterpret_cast<const std::byte*>(texture->pcData), texture->mWidth);
  Result<Image> image = decode_image(bytes, max_texture_pixels);
  if (!image.ok()) return image.status();
  model_.images.push_back({image->width, image->height, std::move(image->rgba)});
  return images_.emplace(texture, static_cast<int>(model_.images.size()) - 1).first->second;
}

}  // namespace pelage
