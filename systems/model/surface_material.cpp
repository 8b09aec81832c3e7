#include <hachure/runtime/assets/complete.h>
#include <hachure/runtime/assets/image_file.h>
#include <hachure/runtime/error.h>
#include <hachure/systems/model/surface_material.h>

#include <algorithm>

namespace hachure {
namespace {

/// Beyond it nothing of the surface's own normal is left, and the shader's floats would overflow some day.
constexpr float max_normal_scale = 1e6f;

/// Grey pictures are height maps, or a mistake: they hold no directions.
void check_channels(const assets::Image& image, ColorSpace color_space, const std::string& name) {
    if (image.type != assets::PixelType::u8) throw Error(name, "is not an 8-bit image");
    if (color_space == ColorSpace::linear && image.channels < 3)
        throw Error(name, "is not a normal map: it has " + std::to_string(image.channels) + " of 3 channels");
}

} // namespace

std::int32_t SurfaceMaterials::texture(std::int32_t index, ColorSpace color_space) {
    if (index < 0) return -1;
    const assets::Texture& texture = model_.textures[static_cast<std::size_t>(index)];
    if (texture.image < 0) return -1; // the reader has said so
    const TextureKey key(texture.image, color_space, texture.wrap_s, texture.wrap_t, texture.magnify, texture.minify,
                         texture.mipmaps);
    const auto [entry, fresh] = loaded_.try_emplace(key, -1);
    if (fresh) entry->second = load(texture, color_space);
    return entry->second;
}

std::int32_t SurfaceMaterials::load(const assets::Texture& texture, ColorSpace color_space) {
    const assets::EncodedImage& source = model_.images[static_cast<std::size_t>(texture.image)];
    if (source.bytes.empty()) return -1;
    try {
        assets::Image image = assets::read_image_memory(source.name, source.bytes);
        check_channels(image, color_space, source.name);
        return store_.add(SurfaceTexture{.image = std::move(image),
                                         .wrap_s = texture.wrap_s,
                                         .wrap_t = texture.wrap_t,
                                         .magnify = texture.magnify,
                                         .minify = texture.minify,
                                         .mipmaps = texture.mipmaps,
                                         .color_space = color_space});
    } catch (const Error& error) {
        if (std::ranges::find(warnings_, error.what()) == warnings_.end()) warnings_.emplace_back(error.what());
        return -1;
    }
}

SurfaceMaterial SurfaceMaterials::get(std::int32_t index) {
    SurfaceMaterial result;
    if (index < 0) return result;
    const assets::Material& material = model_.materials[static_cast<std::size_t>(index)];
    const assets::TextureUse &color = material.base_color_texture, &normal = material.normal_texture;
    result.name = material.name;
    result.base_color = material.base_color;
    result.base_color_texture = texture(color.texture, ColorSpace::srgb);
    result.uv_offset = color.offset;
    result.uv_scale = color.scale;
    result.uv_rotation = color.rotation;
    result.normal_texture = texture(normal.texture, ColorSpace::linear);
    result.normal_scale = std::clamp(material.normal_scale, -max_normal_scale, max_normal_scale);
    result.normal_uv_offset = normal.offset;
    result.normal_uv_scale = normal.scale;
    result.normal_uv_rotation = normal.rotation;
    result.alpha_cutoff = material.alpha_mode == assets::AlphaMode::mask ? material.alpha_cutoff : 0.0f;
    result.double_sided = material.double_sided;
    return result;
}

void SurfaceMaterials::prepare(assets::Primitive& primitive) {
    const assets::Material material =
        primitive.material < 0 ? assets::Material{} : model_.materials[static_cast<std::size_t>(primitive.material)];
    const assets::TextureUse &color = material.base_color_texture, &normal = material.normal_texture;
    const bool mapped = texture(normal.texture, ColorSpace::linear) >= 0;
    if (mapped)
        assets::complete_tangents(primitive, normal);
    else
        primitive.tangents.clear();
    const std::int32_t first = color.texture >= 0 || !mapped ? color.texcoord : normal.texcoord;
    std::vector<glm::vec2> second;
    if (mapped && normal.texcoord != first) second = std::move(primitive.texcoords[normal.texcoord]);
    if (first == 1) primitive.texcoords[0] = std::move(primitive.texcoords[1]);
    primitive.texcoords[1] = std::move(second);
}

} // namespace hachure
