#pragma once

#include <hachure/runtime/assets/model.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

// Whether two models are the same to the last bit (directions: but one), told without the code that writes or merges
// them.
namespace hachure::test {
namespace model_difference_detail {

template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// Reading makes them unit, again and again: what is unit to a float may move by its last bit.
template <class V> bool near(const V& a, const V& b) {
    for (int i = 0; i < V::length(); ++i)
        if (!(std::abs(a[i] - b[i]) <= 2.5e-7f)) return false;
    return true;
}

template <class V> bool near(const std::vector<V>& a, const std::vector<V>& b) {
    return std::ranges::equal(a, b, [](const V& x, const V& y) { return near(x, y); });
}

inline bool same(const assets::TextureUse& a, const assets::TextureUse& b) {
    return a.texture == b.texture && (a.texture < 0 || (a.texcoord == b.texcoord && a.offset == b.offset &&
                                                        a.scale == b.scale && a.rotation == b.rotation));
}

inline bool same(const assets::Primitive& a, const assets::Primitive& b) {
    bool result = same(a.positions, b.positions) && near(a.normals, b.normals) && near(a.tangents, b.tangents) &&
                  same(a.colors, b.colors) && same(a.indices, b.indices) && a.material == b.material &&
                  a.morph_targets.size() == b.morph_targets.size();
    for (int set = 0; set < 2; ++set)
        result = result && same(a.texcoords[set], b.texcoords[set]) && same(a.joints[set], b.joints[set]) &&
                 same(a.weights[set], b.weights[set]);
    for (std::size_t i = 0; result && i < a.morph_targets.size(); ++i) {
        const assets::MorphTarget &x = a.morph_targets[i], &y = b.morph_targets[i];
        result = x.name == y.name && same(x.positions, y.positions) && same(x.normals, y.normals) &&
                 same(x.tangents, y.tangents);
    }
    return result;
}

inline bool same(const assets::Mesh& a, const assets::Mesh& b) {
    bool result =
        a.name == b.name && same(a.morph_weights, b.morph_weights) && a.primitives.size() == b.primitives.size();
    for (std::size_t i = 0; result && i < a.primitives.size(); ++i) result = same(a.primitives[i], b.primitives[i]);
    return result;
}

inline bool same(const assets::Material& a, const assets::Material& b) {
    return a.name == b.name && a.base_color == b.base_color && same(a.base_color_texture, b.base_color_texture) &&
           a.metallic == b.metallic && a.roughness == b.roughness &&
           same(a.metallic_roughness_texture, b.metallic_roughness_texture) &&
           same(a.normal_texture, b.normal_texture) && a.emissive == b.emissive && a.alpha_mode == b.alpha_mode &&
           a.double_sided == b.double_sided && same(a.emissive_texture, b.emissive_texture) &&
           same(a.occlusion_texture, b.occlusion_texture) && a.extras == b.extras;
}

inline bool same(const assets::Texture& a, const assets::Texture& b) {
    return a.image == b.image && a.wrap_s == b.wrap_s && a.wrap_t == b.wrap_t && a.magnify == b.magnify &&
           a.minify == b.minify && a.mipmaps == b.mipmaps;
}

inline bool same(const assets::EncodedImage& a, const assets::EncodedImage& b) { return a.bytes == b.bytes; }

inline bool same(const assets::Camera& a, const assets::Camera& b) {
    return a.orthographic == b.orthographic && a.yfov == b.yfov && a.aspect == b.aspect && a.xmag == b.xmag &&
           a.ymag == b.ymag && a.znear == b.znear && a.zfar == b.zfar;
}

inline bool same(const assets::Light& a, const assets::Light& b) {
    return a.kind == b.kind && a.color == b.color && a.intensity == b.intensity && a.range == b.range &&
           a.inner_cone == b.inner_cone && a.outer_cone == b.outer_cone;
}

inline bool same(const assets::Node& a, const assets::Node& b) {
    return a.name == b.name && a.parent == b.parent && a.children == b.children && a.translation == b.translation &&
           near(a.rotation, b.rotation) && a.scale == b.scale && a.matrix == b.matrix && a.mesh == b.mesh &&
           a.skin == b.skin && a.camera == b.camera && a.light == b.light && same(a.morph_weights, b.morph_weights) &&
           a.extras == b.extras;
}

inline bool same(const assets::Skin& a, const assets::Skin& b) {
    return a.name == b.name && a.joints == b.joints && same(a.inverse_bind, b.inverse_bind) && a.skeleton == b.skeleton;
}

inline bool same(const assets::Animation& a, const assets::Animation& b) {
    bool result = a.name == b.name && a.duration == b.duration && a.channels.size() == b.channels.size();
    for (std::size_t i = 0; result && i < a.channels.size(); ++i) {
        const assets::AnimationChannel &x = a.channels[i], &y = b.channels[i];
        result = x.node == y.node && x.path == y.path && x.pointer == y.pointer && x.interpolation == y.interpolation &&
                 same(x.times, y.times) && same(x.values, y.values) && x.components == y.components;
    }
    return result;
}

inline bool same(const assets::Scene& a, const assets::Scene& b) {
    return a.name == b.name && a.roots == b.roots && a.extras == b.extras;
}

template <class T> std::string first(const char* kind, const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size())
        return std::string("number of ") + kind + ": " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
               "\n";
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!same(a[i], b[i])) return std::string(kind) + " " + std::to_string(i) + "\n";
    return {};
}

} // namespace model_difference_detail

/// The first part of each kind that differs; empty when the models are the same. Names of images are for messages.
inline std::string model_difference(const assets::Model& a, const assets::Model& b) {
    using model_difference_detail::first;
    return first("meshes", a.meshes, b.meshes) + first("materials", a.materials, b.materials) +
           first("textures", a.textures, b.textures) + first("images", a.images, b.images) +
           first("cameras", a.cameras, b.cameras) + first("lights", a.lights, b.lights) +
           first("nodes", a.nodes, b.nodes) + first("skins", a.skins, b.skins) +
           first("animations", a.animations, b.animations) + first("scenes", a.scenes, b.scenes) +
           (a.default_scene == b.default_scene ? "" : "the default scene\n");
}

} // namespace hachure::test
