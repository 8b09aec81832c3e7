#include <cmath>

#include "gltf_builder.h"

// The promise of model.h, told sentence by sentence and not with the reader's own code.
namespace hachure::gltf_testing {
namespace {

using namespace hachure::assets;

template <class Vectors> bool finite(const Vectors& vectors) {
    using Vector = typename Vectors::value_type;
    for (const Vector& vector : vectors)
        for (int i = 0; i < Vector::length(); ++i)
            if (!std::isfinite(vector[i])) return false;
    return true;
}

bool finite_numbers(const std::vector<float>& numbers) {
    for (const float number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

template <class Vectors> bool unit(const Vectors& vectors) {
    for (const auto& v : vectors)
        if (std::abs(std::sqrt(double{v.x} * v.x + double{v.y} * v.y + double{v.z} * v.z) - 1.0) > 1e-5) return false;
    return true;
}

template <class Array> bool in(std::int32_t index, const Array& array) {
    return index >= 0 && static_cast<std::size_t>(index) < array.size();
}

template <class Array> bool in_or_none(std::int32_t index, const Array& array) {
    return index == -1 || in(index, array);
}

std::string primitive_fault(const Primitive& p, const Model& model) {
    const std::size_t n = p.positions.size();
    const auto fits = [n](const auto& array) { return array.empty() || array.size() == n; };
    if (n == 0 || p.indices.empty() || p.indices.size() % 3 != 0) return "a primitive has no whole triangle";
    for (const std::uint32_t index : p.indices)
        if (index >= n) return "an index points beyond the vertices";
    if (!fits(p.normals) || !fits(p.tangents) || !fits(p.colors)) return "an attribute's size differs";
    if (!finite(p.positions) || !finite(p.tangents) || !finite(p.colors)) return "an attribute is not finite";
    if (!unit(p.normals) || !unit(p.tangents)) return "a normal or tangent is not unit";
    for (const auto& t : p.tangents)
        if (std::abs(t.w) != 1.0f) return "a tangent has no handedness";
    for (int set = 0; set < 2; ++set) {
        if (!fits(p.texcoords[set]) || !fits(p.joints[set]) || !fits(p.weights[set])) return "a set's size differs";
        if (!finite(p.texcoords[set]) || !finite(p.weights[set])) return "a set is not finite";
        if (p.joints[set].size() != p.weights[set].size()) return "joints and weights are not pairs";
    }
    for (const MorphTarget& t : p.morph_targets) {
        if (!fits(t.positions) || !fits(t.normals) || !fits(t.tangents)) return "a morph target's size differs";
        if (!finite(t.positions) || !finite(t.normals) || !finite(t.tangents)) return "a morph target is not finite";
    }
    return in_or_none(p.material, model.materials) ? "" : "a primitive's material is out of range";
}

std::string mesh_faults(const Model& model) {
    for (const Mesh& mesh : model.meshes) {
        if (!finite_numbers(mesh.morph_weights)) return "a morph weight is not finite";
        for (const Primitive& primitive : mesh.primitives) {
            if (primitive.morph_targets.size() != mesh.primitives.front().morph_targets.size())
                return "primitives of a mesh have different numbers of morph targets";
            if (const std::string fault = primitive_fault(primitive, model); !fault.empty()) return fault;
        }
    }
    return "";
}

std::string skinning_fault(const Node& node, const Model& model) {
    if (node.mesh < 0 || node.skin < 0) return "";
    const std::size_t joints = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
    for (const Primitive& p : model.meshes[static_cast<std::size_t>(node.mesh)].primitives)
        for (const auto& set : p.joints)
            for (const auto& joint : set)
                for (int i = 0; i < 4; ++i)
                    if (joint[i] >= joints) return "a joint index points beyond the skin";
    return "";
}

std::string node_faults(const Model& model) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Node& node = model.nodes[i];
        if (!in_or_none(node.parent, model.nodes) || !in_or_none(node.mesh, model.meshes) ||
            !in_or_none(node.skin, model.skins) || !in_or_none(node.camera, model.cameras) ||
            !in_or_none(node.light, model.lights))
            return "a node's index is out of range";
        for (const std::int32_t child : node.children)
            if (!in(child, model.nodes) || model.nodes[static_cast<std::size_t>(child)].parent != static_cast<int>(i))
                return "children and parents contradict each other";
        std::size_t steps = 0;
        for (std::int32_t up = node.parent; up >= 0; up = model.nodes[static_cast<std::size_t>(up)].parent)
            if (++steps > model.nodes.size()) return "the node graph has a cycle";
        if (!finite(std::vector<glm::vec3>{node.translation, node.scale})) return "a transform is not finite";
        const glm::quat q = node.rotation;
        if (std::abs(std::sqrt(double{q.x} * q.x + double{q.y} * q.y + double{q.z} * q.z + double{q.w} * q.w) - 1.0) >
            1e-5)
            return "a rotation is not unit";
        if (!finite_numbers(node.morph_weights)) return "a morph weight is not finite";
        if (const std::string fault = skinning_fault(node, model); !fault.empty()) return fault;
    }
    return "";
}

std::string skin_faults(const Model& model) {
    for (const Skin& skin : model.skins) {
        if (skin.joints.size() != skin.inverse_bind.size()) return "a skin lacks inverse bind matrices";
        for (const std::int32_t joint : skin.joints)
            if (!in(joint, model.nodes)) return "a skin's joint is out of range";
        for (const glm::mat4& matrix : skin.inverse_bind)
            for (int i = 0; i < 16; ++i)
                if (!std::isfinite(matrix[i / 4][i % 4])) return "an inverse bind matrix is not finite";
    }
    return "";
}

std::string animation_faults(const Model& model) {
    for (const Animation& animation : model.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (!in_or_none(channel.node, model.nodes)) return "a channel's node is out of range";
            const std::size_t keys = channel.times.size();
            const std::size_t per_key = channel.interpolation == Interpolation::cubic_spline ? 3 : 1;
            if (keys == 0 || channel.components < 1) return "a channel is empty";
            if (channel.values.size() != keys * per_key * static_cast<std::size_t>(channel.components))
                return "a channel has another number of values than its keys need";
            if (!finite_numbers(channel.times) || !finite_numbers(channel.values)) return "a key is not finite";
            for (const float time : channel.times)
                if (time > animation.duration) return "a key lies beyond the duration";
        }
    }
    return "";
}

std::string other_faults(const Model& model) {
    if (model.scenes.empty() || !in(model.default_scene, model.scenes)) return "there is no default scene";
    for (const Scene& scene : model.scenes)
        for (const std::int32_t root : scene.roots)
            if (!in(root, model.nodes)) return "a scene's root is out of range";
    for (const Texture& texture : model.textures)
        if (!in_or_none(texture.image, model.images)) return "a texture's image is out of range";
    for (const Material& m : model.materials)
        for (const TextureUse& use : {m.base_color_texture, m.metallic_roughness_texture, m.normal_texture})
            if (!in_or_none(use.texture, model.textures) || use.texcoord < 0 || use.texcoord > 1)
                return "a material's texture is out of range";
    for (const EncodedImage& image : model.images)
        if (image.bytes.empty()) return "an image is empty";
    for (const std::string& warning : model.warnings)
        if (warning.find('\n') != std::string::npos) return "a warning has two lines";
    return "";
}

} // namespace

std::string broken_promise(const Model& model) {
    for (const auto& faults : {mesh_faults, node_faults, skin_faults, animation_faults, other_faults})
        if (const std::string fault = faults(model); !fault.empty()) return fault;
    return "";
}

} // namespace hachure::gltf_testing
