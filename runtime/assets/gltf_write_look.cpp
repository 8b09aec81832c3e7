#include <hachure/runtime/assets/gltf_writer.h>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace hachure::assets {
namespace {

using nlohmann::json;

std::string_view mime_type(std::span<const std::byte> bytes) {
    return !bytes.empty() && bytes[0] == std::byte{0xff} ? "image/jpeg" : "image/png";
}

int wrap_number(Wrap wrap) {
    switch (wrap) {
    case Wrap::clamp:
        return 33071;
    case Wrap::mirror:
        return 33648;
    case Wrap::repeat:
        break;
    }
    return 10497;
}

int minify_number(const Texture& texture) {
    const bool linear = texture.minify == Filter::linear;
    if (!texture.mipmaps) return linear ? 9729 : 9728;
    return linear ? 9987 : 9984;
}

void write_images(GltfWriter& writer) {
    json images = json::array();
    for (const EncodedImage& image : writer.model.images)
        images.push_back({{"name", image.name},
                          {"mimeType", mime_type(image.bytes)},
                          {"bufferView", writer.data.bytes(image.bytes)}});
    put_array(writer, "images", std::move(images));
}

void write_textures(GltfWriter& writer) {
    json textures = json::array(), samplers = json::array();
    for (const Texture& texture : writer.model.textures) {
        json sampler{{"wrapS", wrap_number(texture.wrap_s)},
                     {"wrapT", wrap_number(texture.wrap_t)},
                     {"magFilter", texture.magnify == Filter::linear ? 9729 : 9728},
                     {"minFilter", minify_number(texture)}};
        auto known = std::ranges::find(samplers, sampler);
        const auto index = static_cast<std::size_t>(known - samplers.begin());
        if (known == samplers.end()) samplers.push_back(std::move(sampler));
        json& written = textures.emplace_back(json{{"sampler", index}});
        if (texture.image >= 0) written["source"] = texture.image;
    }
    put_array(writer, "samplers", std::move(samplers));
    put_array(writer, "textures", std::move(textures));
}

void put_use(GltfWriter& writer, json& object, const char* key, const TextureUse& use) {
    if (use.texture < 0) return;
    json& written = object[key];
    written["index"] = use.texture;
    if (use.texcoord != 0) written["texCoord"] = use.texcoord;
    if (use.offset == glm::vec2(0.0f) && use.scale == glm::vec2(1.0f) && use.rotation == 0.0f) return;
    writer.extensions.insert("KHR_texture_transform");
    written["extensions"]["KHR_texture_transform"] = {{"offset", gltf_numbers(use.offset)},
                                                      {"scale", gltf_numbers(use.scale)},
                                                      {"rotation", gltf_number(use.rotation)}};
}

/// Factors of glTF end at 1; materials of other files may go beyond.
template <class V> V factor(const V& value) { return glm::clamp(value, V(0.0f), V(1.0f)); }

json material_json(GltfWriter& writer, const Material& material) {
    json pbr{{"baseColorFactor", gltf_numbers(factor(material.base_color))},
             {"metallicFactor", gltf_number(factor(material.metallic))},
             {"roughnessFactor", gltf_number(factor(material.roughness))}};
    put_use(writer, pbr, "baseColorTexture", material.base_color_texture);
    put_use(writer, pbr, "metallicRoughnessTexture", material.metallic_roughness_texture);
    json result{{"pbrMetallicRoughness", std::move(pbr)}, {"emissiveFactor", gltf_numbers(factor(material.emissive))}};
    if (!material.name.empty()) result["name"] = material.name;
    put_use(writer, result, "normalTexture", material.normal_texture);
    if (material.normal_texture.texture >= 0) result["normalTexture"]["scale"] = gltf_number(material.normal_scale);
    put_use(writer, result, "emissiveTexture", material.emissive_texture);
    put_use(writer, result, "occlusionTexture", material.occlusion_texture);
    if (material.occlusion_texture.texture >= 0)
        result["occlusionTexture"]["strength"] = gltf_number(material.occlusion_strength);
    if (material.alpha_mode == AlphaMode::blend) result["alphaMode"] = "BLEND";
    if (material.alpha_mode == AlphaMode::mask) {
        result["alphaMode"] = "MASK";
        result["alphaCutoff"] = gltf_number(material.alpha_cutoff);
    }
    if (material.double_sided) result["doubleSided"] = true;
    write_extras(result, material.extras);
    return result;
}

} // namespace

void write_look(GltfWriter& writer) {
    write_images(writer);
    write_textures(writer);
    json materials = json::array();
    for (const Material& material : writer.model.materials) materials.push_back(material_json(writer, material));
    put_array(writer, "materials", std::move(materials));
}

} // namespace hachure::assets
