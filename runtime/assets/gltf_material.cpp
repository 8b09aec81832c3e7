#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

namespace hachure::assets {
namespace {

glm::vec2 vector_of(const tinygltf::Value& value, glm::vec2 fallback) {
    if (!value.IsArray() || value.ArrayLen() != 2) return fallback;
    return {static_cast<float>(value.Get(0).GetNumberAsDouble()), static_cast<float>(value.Get(1).GetNumberAsDouble())};
}

void read_transform(const tinygltf::Value& extension, TextureUse& use) {
    use.offset = vector_of(extension.Get("offset"), use.offset);
    use.scale = vector_of(extension.Get("scale"), use.scale);
    if (extension.Has("rotation")) use.rotation = static_cast<float>(extension.Get("rotation").GetNumberAsDouble());
    if (extension.Has("texCoord")) use.texcoord = extension.Get("texCoord").GetNumberAsInt();
}

// TextureInfo and NormalTextureInfo of tinygltf share these members and no base.
template <class TextureInfo>
TextureUse read_use(const GltfReader& reader, const TextureInfo& source, const std::string& where) {
    TextureUse use;
    use.texture = source.index;
    use.texcoord = source.texCoord;
    const auto transform = source.extensions.find("KHR_texture_transform");
    if (transform != source.extensions.end()) read_transform(transform->second, use);
    if (use.texcoord <= 1) return use;
    reader.warnings.add("textures that use texture coordinates beyond the second set are skipped", where);
    return {};
}

Material read_material(const GltfReader& reader, std::size_t index) {
    const tinygltf::Material& source = reader.document.model->materials[index];
    const std::string where = fmt::format("/materials/{}", index);
    const auto& pbr = source.pbrMetallicRoughness;
    Material material;
    material.name = source.name;
    material.base_color = to_vector(pbr.baseColorFactor, material.base_color);
    material.base_color_texture = read_use(reader, pbr.baseColorTexture, where);
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    material.metallic_roughness_texture = read_use(reader, pbr.metallicRoughnessTexture, where);
    material.normal_texture = read_use(reader, source.normalTexture, where);
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.emissive = to_vector(source.emissiveFactor, material.emissive);
    material.alpha_mode = source.alphaMode == "MASK"    ? AlphaMode::mask
                          : source.alphaMode == "BLEND" ? AlphaMode::blend
                                                        : AlphaMode::opaque;
    material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
    material.double_sided = source.doubleSided;
    material.emissive_texture = read_use(reader, source.emissiveTexture, where);
    material.occlusion_texture = read_use(reader, source.occlusionTexture, where);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    material.extras = reader.document.material_extras[index];
    return material;
}

} // namespace

void read_materials(const GltfReader& reader, Model& model) {
    for (std::size_t i = 0; i < reader.document.model->materials.size(); ++i)
        model.materials.push_back(read_material(reader, i));
}

} // namespace hachure::assets
