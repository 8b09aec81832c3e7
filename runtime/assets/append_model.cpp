#include <hachure/runtime/assets/append_model.h>

#include <array>
#include <charconv>
#include <string>
#include <string_view>

namespace hachure::assets {
namespace {

void shift(std::int32_t& index, std::int32_t by) {
    if (index >= 0) index += by;
}

template <class T> std::int32_t size_of(const std::vector<T>& list) { return static_cast<std::int32_t>(list.size()); }

/// The pointer of a KHR_animation_pointer with its index moved to where its thing is now.
std::string shifted(const std::string& pointer, const ModelPlaces& places) {
    struct Array {
        std::string_view before;
        std::int32_t by;
    };
    const std::array arrays{Array{"/nodes/", places.nodes}, Array{"/meshes/", places.meshes},
                            Array{"/materials/", places.materials}, Array{"/cameras/", places.cameras},
                            Array{"/extensions/KHR_lights_punctual/lights/", places.lights}};
    for (const auto& [before, by] : arrays) {
        if (!pointer.starts_with(before)) continue;
        const char* first = pointer.data() + before.size();
        std::int32_t index = 0;
        const auto [end, error] = std::from_chars(first, pointer.data() + pointer.size(), index);
        if (error != std::errc{} || index < 0) break;
        return std::string(before) + std::to_string(index + by) + std::string(end);
    }
    return pointer;
}

void append_nodes(Model& target, const Model& source, const ModelPlaces& places, std::int32_t parent) {
    for (const Node& original : source.nodes) {
        Node& node = target.nodes.emplace_back(original);
        if (node.name.empty()) node.name = "node " + std::to_string(size_of(target.nodes) - 1 - places.nodes);
        shift(node.parent, places.nodes);
        for (std::int32_t& child : node.children) child += places.nodes;
        shift(node.mesh, places.meshes);
        shift(node.skin, places.skins);
        shift(node.camera, places.cameras);
        shift(node.light, places.lights);
    }
    for (const std::int32_t root : source.scenes[static_cast<std::size_t>(source.default_scene)].roots) {
        target.nodes[static_cast<std::size_t>(root + places.nodes)].parent = parent;
        target.nodes[static_cast<std::size_t>(parent)].children.push_back(root + places.nodes);
    }
}

void append_animations(Model& target, const Model& source, const ModelPlaces& places) {
    for (const Animation& original : source.animations) {
        Animation& animation = target.animations.emplace_back(original);
        for (AnimationChannel& channel : animation.channels) {
            shift(channel.node, places.nodes);
            channel.pointer = shifted(channel.pointer, places);
        }
    }
}

} // namespace

ModelPlaces append_resources(Model& target, const Model& source) {
    const ModelPlaces places{.meshes = size_of(target.meshes), .materials = size_of(target.materials)};
    const std::int32_t textures = size_of(target.textures), images = size_of(target.images);
    target.images.insert(target.images.end(), source.images.begin(), source.images.end());
    for (Texture texture : source.textures) {
        shift(texture.image, images);
        target.textures.push_back(texture);
    }
    for (const Material& original : source.materials) {
        Material& material = target.materials.emplace_back(original);
        for (TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                                &material.normal_texture, &material.emissive_texture, &material.occlusion_texture})
            shift(use->texture, textures);
    }
    for (const Mesh& original : source.meshes)
        for (Primitive& primitive : target.meshes.emplace_back(original).primitives)
            shift(primitive.material, places.materials);
    return places;
}

ModelPlaces append_instance(Model& target, const Model& source, ModelPlaces places, std::int32_t parent) {
    places.nodes = size_of(target.nodes);
    places.cameras = size_of(target.cameras);
    places.lights = size_of(target.lights);
    places.skins = size_of(target.skins);
    places.animations = size_of(target.animations);
    append_nodes(target, source, places, parent);
    target.cameras.insert(target.cameras.end(), source.cameras.begin(), source.cameras.end());
    target.lights.insert(target.lights.end(), source.lights.begin(), source.lights.end());
    for (const Skin& original : source.skins) {
        Skin& skin = target.skins.emplace_back(original);
        for (std::int32_t& joint : skin.joints) joint += places.nodes;
        shift(skin.skeleton, places.nodes);
    }
    append_animations(target, source, places);
    return places;
}

} // namespace hachure::assets
