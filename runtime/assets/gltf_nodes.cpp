#include <hachure/runtime/assets/gltf_numbers.h>
#include <hachure/runtime/assets/gltf_reader.h>
#include <hachure/runtime/assets/gltf_transform.h>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

std::size_t morph_targets(const Mesh& mesh) {
    return mesh.primitives.empty() ? 0 : mesh.primitives.front().morph_targets.size();
}

Node read_node(const GltfReader& reader, std::size_t index, const Model& model) {
    const tinygltf::Node& source = reader.document.model->nodes[index];
    Node node;
    node.name = source.name;
    node.extras = reader.document.node_extras[index];
    node.children.assign(source.children.begin(), source.children.end());
    read_transform(reader, source, node_pointer(index), node);
    node.mesh = source.mesh;
    node.skin = source.skin;
    node.camera = source.camera;
    node.light = light_of(source);
    node.morph_weights = to_floats(source.weights);
    if (node.morph_weights.empty()) return node;
    const std::size_t targets = node.mesh >= 0 ? morph_targets(model.meshes[static_cast<std::size_t>(node.mesh)]) : 0;
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

// The root above each node. Every node has at most one parent by now, so what no root reaches goes in circles.
std::vector<std::int32_t> find_roots(const GltfReader& reader, const std::vector<Node>& nodes) {
    std::vector<std::int32_t> roots(nodes.size(), -1);
    std::vector<std::int32_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent >= 0) continue;
        const auto root = static_cast<std::int32_t>(i);
        open.push_back(root);
        while (!open.empty()) {
            const auto node = static_cast<std::size_t>(open.back());
            open.pop_back();
            roots[node] = root;
            open.insert(open.end(), nodes[node].children.begin(), nodes[node].children.end());
        }
    }
    const auto lost = std::find(roots.begin(), roots.end(), -1);
    if (lost != roots.end())
        reader.document.fail("has a node among its own descendants",
                             node_pointer(static_cast<std::size_t>(lost - roots.begin())));
    return roots;
}

Scene scene_of_all_roots(const std::vector<Node>& nodes) {
    Scene scene;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent < 0) scene.roots.push_back(static_cast<std::int32_t>(i));
    return scene;
}

std::vector<Scene> read_scenes(const GltfReader& reader, const std::vector<std::int32_t>& root_of) {
    std::vector<Scene> scenes;
    std::vector<std::size_t> listed_by(root_of.size(), ~std::size_t{0}); // the last scene that lists each root
    for (const tinygltf::Scene& source : reader.document.model->scenes) {
        Scene scene;
        scene.name = source.name;
        scene.extras = reader.document.scene_extras[scenes.size()];
        for (const int node : source.nodes) {
            const std::int32_t root = root_of[static_cast<std::size_t>(node)];
            if (root != node)
                reader.warnings.add("a scene lists a node below a root: the whole tree is taken",
                                    fmt::format("/scenes/{}", scenes.size()));
            if (std::exchange(listed_by[static_cast<std::size_t>(root)], scenes.size()) != scenes.size())
                scene.roots.push_back(root);
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

} // namespace

void read_nodes(const GltfReader& reader, Model& model) {
    const tinygltf::Model& source = *reader.document.model;
    for (std::size_t i = 0; i < source.nodes.size(); ++i) model.nodes.push_back(read_node(reader, i, model));
    link_parents(reader, model.nodes);
    model.scenes = read_scenes(reader, find_roots(reader, model.nodes));
    if (model.scenes.empty()) model.scenes.push_back(scene_of_all_roots(model.nodes));
    model.default_scene = std::max(source.defaultScene, 0);
}

} // namespace hachure::assets
