#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>
#include <hachure/runtime/assets/gltf_transform.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>

namespace hachure::assets {
namespace {

std::string node_pointer(std::size_t node) { return fmt::format("/nodes/{}", node); }

std::int32_t light_of(const tinygltf::Node& source) {
    const auto it = source.extensions.find("KHR_lights_punctual");
    return it != source.extensions.end() ? it->second.Get("light").GetNumberAsInt() : -1;
}

void read_transform(const GltfReader& reader, const tinygltf::Node& source, const std::string& where, Node& node) {
    if (!source.matrix.empty()) {
        glm::mat4 matrix;
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = static_cast<float>(source.matrix[static_cast<std::size_t>(i)]);
        return set_transform(node, matrix);
    }
    node.translation = to_vector(source.translation, node.translation);
    node.scale = to_vector(source.scale, node.scale);
    if (source.rotation.empty()) return;
    const auto& r = source.rotation; // x, y, z, w; doubles that fit floats, so their squares fit doubles
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (!(length > 1e-12)) return reader.warnings.add("rotations of length zero become the identity", where);
    if (std::abs(length - 1.0) > 1e-3) reader.warnings.add("rotations that are not unit are normalised", where);
    node.rotation = glm::quat(glm::dquat(r[3] / length, r[0] / length, r[1] / length, r[2] / length));
}

Node read_node(const GltfReader& reader, std::size_t index, const Model& model) {
    const tinygltf::Node& source = reader.document.model->nodes[index];
    Node node;
    node.name = source.name;
    node.children.assign(source.children.begin(), source.children.end());
    read_transform(reader, source, node_pointer(index), node);
    node.mesh = source.mesh;
    node.skin = source.skin;
    node.camera = source.camera;
    node.light = light_of(source);
    node.morph_weights = to_floats(source.weights);
    if (node.morph_weights.empty()) return node;
    const auto& mesh = source.mesh >= 0 ? model.meshes[static_cast<std::size_t>(source.mesh)] : Mesh{};
    const std::size_t targets = mesh.primitives.empty() ? 0 : mesh.primitives.front().morph_targets.size();
    if (node.morph_weights.size() != targets) {
        reader.warnings.add("morph weights that do not match the morph targets are dropped", node_pointer(index));
        node.morph_weights.clear();
    }
    return node;
}

void link_parents(const GltfReader& reader, std::vector<Node>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const std::int32_t child : nodes[i].children) {
            std::int32_t& parent = nodes[static_cast<std::size_t>(child)].parent;
            if (parent >= 0)
                reader.document.fail("has a node with two parents", node_pointer(static_cast<std::size_t>(child)));
            parent = static_cast<std::int32_t>(i);
        }
    }
}

// Every node has at most one parent by now, so what the roots do not reach goes in circles.
void refuse_cycles(const GltfReader& reader, const std::vector<Node>& nodes) {
    std::vector<bool> reached(nodes.size());
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) open.push_back(i);
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        reached[node] = true;
        for (const std::int32_t child : nodes[node].children) open.push_back(static_cast<std::size_t>(child));
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost != reached.end())
        reader.document.fail("has a node among its own descendants",
                             node_pointer(static_cast<std::size_t>(lost - reached.begin())));
}

Scene scene_of_all_roots(const std::vector<Node>& nodes) {
    Scene scene;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) scene.roots.push_back(static_cast<std::int32_t>(i));
    return scene;
}

Scene read_scene(const GltfReader& reader, std::size_t index, const std::vector<Node>& nodes) {
    const tinygltf::Scene& source = reader.document.model->scenes[index];
    Scene scene;
    scene.name = source.name;
    std::vector<bool> listed(nodes.size());
    for (std::int32_t node : source.nodes) {
        while (nodes[static_cast<std::size_t>(node)].parent >= 0) {
            reader.warnings.add("a scene lists a node below a root: the whole tree is taken",
                                fmt::format("/scenes/{}", index));
            node = nodes[static_cast<std::size_t>(node)].parent;
        }
        if (!listed[static_cast<std::size_t>(node)]) scene.roots.push_back(node);
        listed[static_cast<std::size_t>(node)] = true;
    }
    return scene;
}

} // namespace

void read_nodes(const GltfReader& reader, Model& model) {
    const tinygltf::Model& source = *reader.document.model;
    for (std::size_t i = 0; i < source.nodes.size(); ++i) model.nodes.push_back(read_node(reader, i, model));
    link_parents(reader, model.nodes);
    refuse_cycles(reader, model.nodes);

    for (std::size_t i = 0; i < source.scenes.size(); ++i) model.scenes.push_back(read_scene(reader, i, model.nodes));
    if (model.scenes.empty()) model.scenes.push_back(scene_of_all_roots(model.nodes));
    model.default_scene = std::max(source.defaultScene, 0);
}

} // namespace hachure::assets
